// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/entity_finder.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <numbers>

#include "catch.h"

using namespace featuremesh;

namespace {

constexpr double tolerance = 1e-3, height = 10;

/// A prism on a polygon of this many corners.
TopoDS_Shape prism(int corners) {
    BRepBuilderAPI_MakePolygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        polygon.Add(gp_Pnt(100 * std::cos(angle), 100 * std::sin(angle), 0));
    }
    polygon.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0, 0, height)).Shape();
}

/// In the middle of the wall with that number.
Vec3 on_wall(int wall, int corners) {
    const double radius = 100 * std::cos(std::numbers::pi / corners),
                 angle = 2 * std::numbers::pi * (wall + 0.5) / corners;
    return {radius * std::cos(angle), radius * std::sin(angle), height / 2};
}

}  // namespace

TEST_CASE("a point is on the entity of lowest dimension that is near enough") {
    const Brep brep(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
    const EntityFinder finder(brep, tolerance);
    for (const double off : {0.0, 0.9 * tolerance, -0.9 * tolerance}) {
        CHECK(finder.find({off, 0, 0}).entity.dim == 0);
        CHECK(finder.find({5, off, 0}).entity.dim == 1);
        CHECK(finder.find({5, 6, 30 + off}).entity.dim == 2);
    }
    CHECK(finder.find({0, 0, 1.1 * tolerance}).entity.dim == 1);
    CHECK(finder.find({5, 0, 1.1 * tolerance}).entity.dim == 2);
    CHECK(finder.find({5, 6, 1.1 * tolerance}).entity.dim == 3);
    CHECK(finder.find({10, 20, 31}).entity.dim == 3);
    for (std::size_t v = 0; v < brep.vertex_count(); ++v)
        CHECK(finder.another().find(brep.point_of(VertexId(v))).entity == entity_of(VertexId(v)));
}

TEST_CASE("points are found on each of thousands of faces") {
    constexpr int corners = 2000;
    const Brep brep(prism(corners));
    const EntityFinder finder(brep, tolerance);
    int found = 0;
    for (int i = 0; i < corners; ++i) found += finder.find(on_wall(i, corners)).entity.dim == 2;
    CHECK(found == corners);
}
