// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/document_view.h"

#include <TopExp_Explorer.hxx>

#include "brep/shape_stream.h"

namespace featuremesh {

namespace {
const TopoDS_Shape no_shape;
}

DocumentView::DocumentView(const RawDocument& document) : document_(document), shapes_(read_shapes(document.shapes)) {
    for (const TopoDS_Shape& shape : shapes_) has_solid_.push_back(TopExp_Explorer(shape, TopAbs_SOLID).More());
    for (std::size_t i = 0; i < document.records.size(); ++i)
        by_name_.emplace(document.records[i].name, static_cast<int>(i));
}

int DocumentView::find(const std::string& name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? -1 : found->second;
}

const TopoDS_Shape& DocumentView::at(int index) const {
    return index < 0 || index >= static_cast<int>(shapes_.size()) ? no_shape : shapes_[index];
}

const TopoDS_Shape& DocumentView::shape_of(const RawRecord& record) const { return at(record.shape); }

const TopoDS_Shape& DocumentView::solids_of(const RawRecord& record) const {
    const TopoDS_Shape& shape = at(record.shape);
    return !shape.IsNull() && has_solid_[record.shape] ? shape : no_shape;
}

const TopoDS_Shape& DocumentView::own_volume_of(const RawRecord& record) const {
    const TopoDS_Shape& shape = at(record.own_volume);
    return !shape.IsNull() && has_solid_[record.own_volume] ? shape : no_shape;
}

std::vector<RawLink> DocumentView::links_of(const RawRecord& record, const std::string& property) {
    std::vector<RawLink> links;
    for (const RawLink& link : record.links)
        if (link.property == property && !link.object.empty()) links.push_back(link);
    return links;
}

}  // namespace featuremesh
