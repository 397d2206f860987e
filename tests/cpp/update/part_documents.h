// SPDX-License-Identifier: GPL-3.0-or-later
// Documents of Part primitives and booleans, made without FreeCAD.
#pragma once

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <string>
#include <vector>

#include "brep/written_shapes.h"
#include "features/raw_document.h"

namespace featuremesh {

class PartDocument {
  public:
    PartDocument& add(const std::string& name, const std::string& type, const TopoDS_Shape& shape,
                      std::vector<RawLink> links = {}, RigidMotion placement = {}) {
        RawRecord record;
        record.name = record.label = name;
        record.type = type;
        record.links = std::move(links);
        record.placement = record.global_placement = placement;
        record.shape = int(shapes_.size());
        shapes_.push_back(shape);
        document_.records.push_back(std::move(record));
        return *this;
    }
    PartDocument& box(const std::string& name, Vec3 low, Vec3 size) {
        return add(name, "Part::Box", BRepPrimAPI_MakeBox(gp_Pnt(low.x, low.y, low.z), size.x, size.y, size.z).Shape(),
                   {}, at(low));
    }
    PartDocument& cylinder(const std::string& name, Vec3 foot, double radius, double height) {
        const gp_Ax2 axis(gp_Pnt(foot.x, foot.y, foot.z), gp_Dir(0, 0, 1));
        return add(name, "Part::Cylinder", BRepPrimAPI_MakeCylinder(axis, radius, height).Shape(), {}, at(foot));
    }
    PartDocument& cut(const std::string& name, const std::string& base, const std::string& tool) {
        return add(name, "Part::Cut", BRepAlgoAPI_Cut(shape(base), shape(tool)).Shape(),
                   {{"Base", base, ""}, {"Tool", tool, ""}});
    }
    PartDocument& fuse(const std::string& name, const std::string& base, const std::string& tool) {
        return add(name, "Part::Fuse", BRepAlgoAPI_Fuse(shape(base), shape(tool)).Shape(),
                   {{"Base", base, ""}, {"Tool", tool, ""}});
    }
    /// The document whose last object is meshed.
    RawDocument finish() const {
        RawDocument document = document_;
        document.final_object = document.records.back().name;
        document.shapes = test::write_shapes(shapes_);
        return document;
    }
    const TopoDS_Shape& shape(const std::string& name) const {
        for (const RawRecord& record : document_.records)
            if (record.name == name) return shapes_[std::size_t(record.shape)];
        throw std::out_of_range(name);
    }

  private:
    static RigidMotion at(Vec3 p) {
        RigidMotion motion;
        motion.translation = p;
        return motion;
    }
    RawDocument document_;
    std::vector<TopoDS_Shape> shapes_;
};

/// A plate with a hole at x.
inline RawDocument plate_with_hole(double x, double radius = 4, double length = 60) {
    return PartDocument()
        .box("Plate", {0, 0, 0}, {length, 30, 6})
        .cylinder("Hole", {x, 15, -1}, radius, 8)
        .cut("Part", "Plate", "Hole")
        .finish();
}

/// A plate with a hole at x and a ledge 0.3 mm wide at y = 30, whose refinement may be left out.
inline RawDocument plate_with_ledge(double x) {
    return PartDocument()
        .box("Plate", {0, 0, 0}, {60, 30, 8})
        .box("Top", {0, 0, 8}, {60, 29.7, 6})
        .fuse("Stepped", "Plate", "Top")
        .cylinder("Hole", {x, 12, -1}, 4, 20)
        .cut("Part", "Stepped", "Hole")
        .finish();
}

}  // namespace featuremesh
