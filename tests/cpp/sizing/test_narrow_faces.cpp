// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Pln.hxx>
#include <numbers>

#include "catch.h"
#include "sizing/sizing_field.h"

using namespace featuremesh;

namespace {

constexpr double size = 4;

SizingField sizing_of(const TopoDS_Shape& shape, double min_size = 0) {
    SizingOptions options;
    options.size = size;
    options.min_size = min_size;
    options.elements_per_circle = 0;
    RunContext context;
    return make_sizing(Brep(shape), options, {}, context);
}

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high) { return BRepPrimAPI_MakeBox(low, high).Shape(); }

/// A block with a ledge of this width along its top, at y = 40.
TopoDS_Shape ledge(double width) {
    return BRepAlgoAPI_Fuse(box({0, 0, 0}, {60, 40, 20}), box({0, 0, 20}, {60, 40 - width, 30})).Shape();
}

/// A block with a slot of this width in its top, at y = 20.
TopoDS_Shape slotted(double width) {
    return BRepAlgoAPI_Cut(box({0, 0, 0}, {60, 40, 20}), box({0, 20, 10}, {60, 20 + width, 20})).Shape();
}

/// A block with a rib of 0.4 on its top.
TopoDS_Shape ribbed(double height) {
    return BRepAlgoAPI_Fuse(box({0, 0, 0}, {60, 40, 20}), box({0, 20, 20}, {60, 20.4, 20 + height})).Shape();
}

TopoDS_Shape cylinder(double x, double z, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 0, z), gp_Dir(0, 0, 1)), radius, height).Shape();
}

/// Ten times as wide as it has hexagonal holes in a row.
TopoDS_Shape perforated_plate(int holes) {
    const auto polygon = [](double x, double y, double radius, int corners) {
        BRepBuilderAPI_MakePolygon out;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.5) / corners * (corners == 4 ? 1 : -1);
            out.Add(gp_Pnt(x + radius * std::cos(angle), y + radius * std::sin(angle), 0));
        }
        out.Close();
        return out.Wire();
    };
    BRepBuilderAPI_MakeFace face(gp_Pln(gp::XOY()), polygon(5. * holes, 5. * holes, 5. * holes * std::sqrt(2), 4));
    for (int i = 0; i < holes; ++i)
        for (int k = 0; k < holes; ++k) face.Add(polygon(10. * i + 5, 10. * k + 5, 3, 6));
    return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, 10)).Shape();
}

}  // namespace

TEST_CASE("pieces along a ledge are a few of its widths long") {
    const SizingField sizing = sizing_of(ledge(0.4));
    for (const double x : {0.3, 7.7, 30.0, 52.1, 59.7})
        for (const double y : {39.6, 39.8, 40.0}) CHECK(sizing.at({x, y, 20}) == Approx(1.6).epsilon(0.05));
    CHECK(sizing.at({30, 20, 10}) == size);
    CHECK(sizing.smallest() == Approx(1.6).epsilon(1e-6));
}

TEST_CASE("the bottom of a slot is refined by its width") {
    CHECK(sizing_of(slotted(0.4)).at({30, 20, 10}) == Approx(1.6).epsilon(0.05));
}

TEST_CASE("faces wide enough, or far too narrow, ask for nothing") {
    CHECK(sizing_of(ledge(0.81)).is_uniform());
    CHECK(sizing_of(ledge(0.1)).is_uniform());
}

TEST_CASE("the rim of a thin plate asks for nothing") {
    CHECK(sizing_of(box({0, 0, 0}, {60, 40, 0.4})).is_uniform());
    CHECK(sizing_of(ribbed(10)).is_uniform());
}

TEST_CASE("a low rib and a thin rod are refined by their width") {
    const SizingField rib = sizing_of(ribbed(2));
    for (const double x : {0.3, 30.0, 59.7}) CHECK(rib.at({x, 20.2, 22}) == Approx(1.6).epsilon(0.05));
    CHECK(rib.at({30, 5, 10}) == size);
    CHECK(sizing_of(box({0, 0, 0}, {0.4, 0.4, 60})).at({0.2, 0.2, 30}) == Approx(1.6).epsilon(0.05));
}

TEST_CASE("no piece along a narrow face is shorter than a quarter of the size") {
    CHECK(sizing_of(ledge(0.2)).smallest() == size / 4);
}

TEST_CASE("edges no longer than a few widths ask for nothing") {
    const TopoDS_Shape block = box({0, 0, 0}, {60, 40, 20});
    CHECK(sizing_of(BRepAlgoAPI_Cut(block, box({20, 20, 18.2}, {20.4, 20.4, 20})).Shape()).is_uniform());
    CHECK(!sizing_of(BRepAlgoAPI_Cut(block, box({20, 20, 17}, {20.4, 20.4, 20})).Shape()).is_uniform());
}

TEST_CASE("edges that meet ask for nothing") {
    CHECK(sizing_of(BRepPrimAPI_MakeCone(1.05, 0, 20, 5).Shape()).is_uniform());
}

TEST_CASE("a ring between two circles is a strip, a lens is none") {
    const auto stepped = [](double offset) {  // the lens is 0.1 wide on one side, 0.9 on the other
        return BRepAlgoAPI_Fuse(cylinder(0, 0, 10, 10), cylinder(offset, 10, 9.5, 10)).Shape();
    };
    const SizingField ring = sizing_of(stepped(0));
    for (const double angle : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0})
        CHECK(ring.at({10 * std::cos(angle), 10 * std::sin(angle), 10}) == Approx(2).epsilon(0.05));
    CHECK(sizing_of(stepped(0.4)).is_uniform());
}

TEST_CASE("an edge that gets longer elsewhere asks for the same along its strip") {
    const auto part = [](double length) {  // the ledge ends at x = 33
        return BRepAlgoAPI_Fuse(box({0, 0, 0}, {length, 40, 20}), box({0, 0, 20}, {33, 39.8, 30})).Shape();
    };
    const SizingField before = sizing_of(part(60));
    CHECK(before.at({32.9, 40, 20}) == Approx(1).epsilon(0.05));
    for (const double length : {60.7, 63.0, 71.3, 88.0}) {
        const SizingField after = sizing_of(part(length));
        for (double x = 0.1; x < 50; x += 0.3)
            for (const double y : {39.8, 40.0})
                for (const double z : {20.0, 19.0, 17.0})
                    CHECK(after.at({x, y, z}) == Approx(before.at({x, y, z})).epsilon(0.05));
    }
}

TEST_CASE("narrow faces ask for nothing below the smallest size") { CHECK(sizing_of(ledge(0.4), 2).smallest() == 2); }

TEST_CASE("narrow faces ask for nothing where they are not to") {
    SizingOptions options;
    options.size = size;
    options.elements_per_circle = 0;
    options.refines_narrow_faces = false;
    RunContext context;
    CHECK(make_sizing(Brep(ledge(0.4)), options, {}, context).is_uniform());
}

TEST_CASE("holes that leave room between them ask for nothing") {
    SizingOptions options;
    options.size = size;
    options.elements_per_circle = 0;
    RunContext context;
    CHECK(make_sizing(Brep(perforated_plate(10)), options, {}, context).smallest() == size);
}
