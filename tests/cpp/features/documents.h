// SPDX-License-Identifier: GPL-3.0-or-later
// Hand-made raw documents.
#pragma once

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <string>
#include <utility>
#include <vector>

#include "features/raw_document.h"

namespace featuremesh::test {

inline TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Solid();
}
inline TopoDS_Shape cylinder(gp_Pnt base, gp_Dir axis, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(base, axis), radius, height).Solid();
}
inline TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }
inline TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }

class DocumentMaker {
  public:
    RawRecord& add(const std::string& name, const std::string& type, std::vector<RawLink> links = {},
                   const TopoDS_Shape& shape = {}, const TopoDS_Shape& own_volume = {}) {
        RawRecord record;
        record.name = record.label = name;
        record.type = type;
        record.links = std::move(links);
        record.shape = keep(shape);
        record.own_volume = keep(own_volume);
        document_.records.push_back(std::move(record));
        document_.final_object = name;
        return document_.records.back();
    }
    RawDocument done() const {
        RawDocument document = document_;
        document.shapes = write_shapes(shapes_);
        return document;
    }

  private:
    int keep(const TopoDS_Shape& shape) {
        if (shape.IsNull()) return -1;
        shapes_.push_back(shape);
        return static_cast<int>(shapes_.size()) - 1;
    }

    RawDocument document_;
    std::vector<TopoDS_Shape> shapes_;
};

}  // namespace featuremesh::test
