// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/document_view.h"

#include <TopExp_Explorer.hxx>

#include "brep/brep.h"
#include "brep/shape_stream.h"

namespace featuremesh {

namespace {
const TopoDS_Shape no_shape;

Dimension highest_in(const TopoDS_Shape& shape) {
    return shape.IsNull() || !TopExp_Explorer(shape, TopAbs_EDGE).More() ? Dimension::from_shape : dimension_of(shape);
}

/// Faces of no solid, or edges of no face.
bool has_loose(const TopoDS_Shape& shape) {
    return TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SOLID).More() ||
           TopExp_Explorer(shape, TopAbs_EDGE, TopAbs_FACE).More();
}

}  // namespace

DocumentView::DocumentView(const RawDocument& document, Dimension asked)
    : document_(document), shapes_(read_shapes(document.shapes)), dimension_(asked) {
    for (const TopoDS_Shape& shape : shapes_) has_.push_back(highest_in(shape));
    for (std::size_t i = 0; i < document.records.size(); ++i)
        by_name_.emplace(document.records[i].name, static_cast<int>(i));
    if (dimension_ != Dimension::from_shape) return;
    const int last = find(document.final_object);
    if (last >= 0) dimension_ = highest_of(document.records[std::size_t(last)].shape);
    if (dimension_ == Dimension::from_shape) dimension_ = Dimension::solids;
    takes_loose_ =
        last >= 0 && dimension_ == Dimension::solids && has_loose(shape_of(document.records[std::size_t(last)]));
}

int DocumentView::find(const std::string& name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? -1 : found->second;
}

const TopoDS_Shape& DocumentView::at(int index) const {
    return index < 0 || index >= static_cast<int>(shapes_.size()) ? no_shape : shapes_[index];
}

const TopoDS_Shape& DocumentView::shape_of(const RawRecord& record) const { return at(record.shape); }

Dimension DocumentView::highest_of(int shape) const {
    return shape < 0 || shape >= static_cast<int>(has_.size()) ? Dimension::from_shape : has_[std::size_t(shape)];
}

const TopoDS_Shape& DocumentView::geometry_of(const RawRecord& record) const {
    const Dimension has = highest_of(record.shape);
    return has >= dimension_ || (takes_loose_ && has != Dimension::from_shape) ? at(record.shape) : no_shape;
}

bool DocumentView::has_solid(const RawRecord& record) const { return highest_of(record.shape) == Dimension::solids; }

const TopoDS_Shape& DocumentView::own_volume_of(const RawRecord& record) const {
    return highest_of(record.own_volume) == Dimension::solids ? at(record.own_volume) : no_shape;
}

std::vector<RawLink> DocumentView::links_of(const RawRecord& record, const std::string& property) {
    std::vector<RawLink> links;
    for (const RawLink& link : record.links)
        if (link.property == property && !link.object.empty()) links.push_back(link);
    return links;
}

}  // namespace featuremesh
