// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <numbers>
#include <random>

#include "brep/enclosure.h"
#include "catch.h"

using namespace featuremesh;

namespace {
Vec3 random_point(std::mt19937_64& random) {
    std::uniform_real_distribution<double> side(-1, 11);
    return {side(random), side(random), side(random)};
}
}  // namespace

TEST_CASE("an enclosure agrees with the formula away from the boundary") {
    const TopoDS_Shape bored = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 10, 10).Shape(),
                                               BRepPrimAPI_MakeCylinder(gp_Ax2({5, 5, 0}, {0, 0, 1}), 3, 10).Shape())
                                   .Shape();
    const Enclosure inside({bored});
    const Brep brep(bored);
    const SolidLocator locator(brep);
    std::mt19937_64 random(7);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p = random_point(random);
        const double radial = std::hypot(p.x - 5, p.y - 5);
        const double to_box = std::min({p.x, p.y, p.z, 10 - p.x, 10 - p.y, 10 - p.z});
        if (std::abs(radial - 3) < 0.05 || std::abs(to_box) < 0.01) continue;
        const bool expected = to_box > 0 && radial > 3;
        CHECK(inside.contains(p) == expected);
        if (i < 200) CHECK(locator.solid_at(p).is_valid() == expected);
    }
}

TEST_CASE("what two volumes have in common is inside their enclosure, too") {
    const TopoDS_Shape low = BRepPrimAPI_MakeBox({0, 0, 0}, {10, 10, 6}).Shape(),
                       high = BRepPrimAPI_MakeBox({2, 2, 4}, {8, 8, 10}).Shape();
    const Enclosure inside({low, high});
    for (const double z : {1.0, 5.0, 9.0}) CHECK(inside.contains({5, 5, z}));
    CHECK(inside.contains({1, 1, 5}));
    CHECK_FALSE(inside.contains({1, 1, 7}));
}

TEST_CASE("a face drawn into a volume is no border of its enclosure") {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
    const TopoDS_Shape drawn = BRepBuilderAPI_MakeFace(gp_Pln({5, 5, 5}, gp::DZ()), -2, 2, -2, 2).Shape();
    TopoDS_Compound volume;
    BRep_Builder().MakeCompound(volume);
    BRep_Builder().Add(volume, box);
    BRep_Builder().Add(volume, drawn.Oriented(TopAbs_INTERNAL));
    const Enclosure inside({volume});
    for (const double z : {2.0, 8.0}) CHECK(inside.contains({5, 5, z}));
}

TEST_CASE("a face with very many holes is triangulated around each") {
    constexpr int across = 11;  // more than a hundred take another road
    BRepBuilderAPI_MakeFace face(gp_Pln(), 0, 10.0 * across, 0, 10.0 * across);
    for (int i = 0; i < across * across; ++i) {
        const gp_Pnt centre(10.0 * (i % across) + 5, 10.0 * (i / across) + 5, 0);
        const gp_Circ hole(gp_Ax2(centre, gp_Dir(0, 0, -1)), 3);
        face.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(hole)));
    }
    double area = 0;
    for (const auto& [a, b, c] : triangulate(face.Shape())) area += length(cross(b - a, c - a)) / 2;
    CHECK(area == Approx(across * across * (100 - 9 * std::numbers::pi)).epsilon(0.02));
}

TEST_CASE("an enclosure of nothing contains nothing") { CHECK_FALSE(Enclosure({}).contains({0, 0, 0})); }

TEST_CASE("a point grid finds what brute force finds") {
    std::mt19937_64 random(11);
    std::vector<Vec3> points;
    for (int i = 0; i < 300; ++i) points.push_back(random_point(random));
    const PointGrid grid(points, 0.8);
    for (int i = 0; i < 300; ++i) {
        const Vec3 p = random_point(random);
        bool near = false;
        for (const Vec3& q : points) near = near || distance(p, q) < 0.7;
        CHECK(grid.has_within(p, 0.7) == near);
    }
}
