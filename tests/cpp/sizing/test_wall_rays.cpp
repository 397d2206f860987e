// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include "catch.h"
#include "sizing/sizing_field.h"
#include "sizing/wall_rays.h"

using namespace featuremesh;

TEST_CASE("thickness of a plate and of a tube") {
    const Brep plate(BRepPrimAPI_MakeBox(30, 20, 2).Shape());
    const WallRays rays(plate, 0.1);
    int faces_without_common_edge = 0;
    for (std::size_t f = 0; f < plate.face_count(); ++f) {
        const double thickness = rays.thickness(FaceId(f), {10, 10, 0}, {0, 0, 1}, 50);
        if (thickness < 50) {
            CHECK(thickness == Approx(2.0));
            ++faces_without_common_edge;
        }
        CHECK(rays.thickness(FaceId(f), {10, 10, 0}, {0, 0, 1}, 1.5) == 1.5);
    }
    CHECK(faces_without_common_edge == 2);
    const Brep tube(
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(20, 40).Shape(), BRepPrimAPI_MakeCylinder(19, 40).Shape()).Shape());
    const WallRays through(tube, 0.02);
    for (double angle : {0.1, 1.3, 4.0}) {
        const Vec3 out{std::cos(angle), std::sin(angle), 0};
        double thinnest = 50;
        for (std::size_t f = 0; f < tube.face_count(); ++f)
            thinnest = std::min(thinnest, through.thickness(FaceId(f), 20.0 * out + Vec3{0, 0, 20}, -out, 50));
        CHECK(thinnest == Approx(1.0).margin(0.05));
    }
}

TEST_CASE("elements across a gap make a thin plate fine and leave a thick block alone") {
    RunContext context;
    SizingOptions options;
    options.size = 8;
    options.elements_across_gap = 2;
    const SizingField thin = make_sizing(Brep(BRepPrimAPI_MakeBox(40, 40, 3).Shape()), options, {}, context);
    for (double x : {3.0, 20.0, 33.3}) {
        CHECK(thin.at({x, 20, 0}) == Approx(1.5));
        CHECK(thin.at({x, 20, 1.5}) <= 1.5 + 0.3 * 1.5);
    }
    CHECK(make_sizing(Brep(BRepPrimAPI_MakeBox(40, 40, 40).Shape()), options, {}, context).is_uniform());
}

TEST_CASE("of two solids that share a face each has its own thickness, and the thinner counts at the face") {
    TopTools_ListOfShape blocks;
    blocks.Append(BRepPrimAPI_MakeBox(40, 40, 3).Shape());
    blocks.Append(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 3), 40, 40, 30).Shape());
    for (const bool is_turned : {false, true}) {
        if (is_turned) blocks.Reverse();
        BRepAlgoAPI_BuilderAlgo glue;
        glue.SetArguments(blocks);
        glue.Build();
        const Brep brep(glue.Shape());
        REQUIRE(brep.face_count() == 11);
        RunContext context;
        SizingOptions options;
        options.size = 8;
        options.elements_across_gap = 2;
        const SizingField field = make_sizing(brep, options, {}, context);
        for (const double z : {0.0, 3.0}) CHECK(field.at({20, 20, z}) == Approx(1.5));
        CHECK(field.at({20, 20, 33}) == 8);
    }
}

TEST_CASE("the tip of a wedge is no gap") {
    RunContext context;
    SizingOptions options;
    options.size = 8;
    options.elements_across_gap = 1;
    const SizingField field = make_sizing(Brep(BRepPrimAPI_MakeWedge(60, 60, 60, 0.0).Shape()), options, {}, context);
    CHECK(field.smallest() > 1);
}
