// SPDX-License-Identifier: GPL-3.0-or-later
// The raw records with their shapes, found by name.
#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>
#include <vector>

#include "core/dimension.h"
#include "features/raw_document.h"

namespace featuremesh {

class DocumentView {
  public:
    /// Keeps a reference to the document. Throws StateError when its shapes cannot be read.
    explicit DocumentView(const RawDocument& document, Dimension asked = Dimension::from_shape);

    const std::vector<RawRecord>& records() const { return document_.records; }
    /// Index of a record; -1 for an unknown name.
    int find(const std::string& name) const;
    /// What is meshed of the part: what was asked for, or what the final object's shape has.
    Dimension dimension() const { return dimension_; }
    /// Faces or edges beside solids are meshed with them.
    bool takes_loose() const { return takes_loose_; }
    /// The record's shape when it has something of that dimension or above, or anything where what is loose is taken;
    /// else a null shape.
    const TopoDS_Shape& geometry_of(const RawRecord& record) const;
    /// Whether the record's shape has a solid.
    bool has_solid(const RawRecord& record) const;
    /// The record's own volume when it has at least one solid, else a null shape.
    const TopoDS_Shape& own_volume_of(const RawRecord& record) const;
    /// The record's shape whatever it is; null when it has none.
    const TopoDS_Shape& shape_of(const RawRecord& record) const;
    /// Names that a link property holds, in order; empty when it is not set.
    static std::vector<RawLink> links_of(const RawRecord& record, const std::string& property);

  private:
    const TopoDS_Shape& at(int index) const;
    Dimension highest_of(int shape) const;

    const RawDocument& document_;
    std::vector<TopoDS_Shape> shapes_;
    std::vector<Dimension> has_;  // by shape, its highest; from_shape for none
    Dimension dimension_;
    bool takes_loose_ = false;
    std::map<std::string, int> by_name_;
};

}  // namespace featuremesh
