// SPDX-License-Identifier: GPL-3.0-or-later
// Our search for shells against the kernel's.
#include <BOPAlgo_Builder.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <vector>

#include "catch.h"
#include "cells/parts.h"
#include "cells/solid_pieces.h"

using namespace featuremesh;
using namespace featuremesh::test;

namespace {

/// The faces into which the kernel divides those of all shapes: of the first the border, of the others those within it,
/// which are given once for either side.
TopTools_ListOfShape faces_to_divide(const std::vector<TopoDS_Shape>& shapes) {
    BOPAlgo_Builder fuse;
    for (const TopoDS_Shape& shape : shapes) fuse.AddArgument(shape);
    fuse.Perform();
    REQUIRE_FALSE(fuse.HasErrors());
    TopTools_ListOfShape faces;
    TopTools_MapOfShape border, seen;
    for (TopExp_Explorer it(shapes.front(), TopAbs_FACE); it.More(); it.Next()) {
        const TopTools_ListOfShape& images = fuse.Modified(it.Current());
        if (images.IsEmpty()) faces.Append(it.Current());
        for (const TopoDS_Shape& image : images) faces.Append(image);
    }
    for (const TopoDS_Shape& face : faces) border.Add(face);
    const Box whole{{0, 0, 0}, {30, 30, 30}};
    for (TopExp_Explorer it(fuse.Shape(), TopAbs_FACE); it.More(); it.Next()) {
        GProp_GProps area;
        BRepGProp::SurfaceProperties(it.Current(), area);
        const gp_Pnt middle = area.CentreOfMass();
        if (border.Contains(it.Current()) || !seen.Add(it.Current())) continue;
        if (!whole.grown(-1e-6).contains({middle.X(), middle.Y(), middle.Z()})) continue;
        for (const TopAbs_Orientation side : {TopAbs_FORWARD, TopAbs_REVERSED})
            faces.Append(it.Current().Oriented(side));
    }
    return faces;
}

/// Volume and number of faces of every piece, in order.
std::vector<double> measures(BOPAlgo_BuilderSolid& builder, const TopTools_ListOfShape& faces) {
    builder.SetShapes(faces);
    builder.Perform();
    REQUIRE_FALSE(builder.HasErrors());
    std::vector<double> list;
    for (const TopoDS_Shape& piece : builder.Areas()) {
        GProp_GProps volume;
        BRepGProp::VolumeProperties(piece, volume);
        int count = 0;
        for (TopExp_Explorer it(piece, TopAbs_FACE); it.More(); it.Next()) ++count;
        list.insert(list.end(), {volume.Mass(), double(count)});
    }
    return list;
}

void check_against_kernel(const std::vector<TopoDS_Shape>& shapes, std::size_t pieces) {
    const TopTools_ListOfShape faces = faces_to_divide(shapes);
    BOPAlgo_BuilderSolid plain;
    SolidPieces ours;
    const std::vector<double> expected = measures(plain, faces);
    CHECK(expected.size() == 2 * pieces);
    CHECK(measures(ours, faces) == expected);
}

TopoDS_Shape block() { return box(0, 0, 0, 30, 30, 30); }
TopoDS_Shape wall(double x) { return TopExp_Explorer(box(x, -5, -5, 1, 40, 40), TopAbs_FACE).Current(); }

}  // namespace

TEST_CASE("faces within a solid divide it as the kernel does") {
    check_against_kernel({block(), cylinder({10, 10, 0}, {0, 0, 1}, 4, 30), cylinder({20, 20, -5}, {0, 0, 1}, 4, 40)},
                         3);
    check_against_kernel({block(), wall(10), wall(20), box(-5, 12, -5, 40, 6, 40)}, 9);
    check_against_kernel({block(), box(0, 0, 0, 10, 10, 10), box(10, 10, 0, 10, 10, 10), box(10, 0, 10, 10, 10, 10)},
                         4);
}

TEST_CASE("pieces within pieces and pieces that touch in an edge are divided as the kernel does") {
    check_against_kernel({block(), sphere({15, 15, 15}, 8), sphere({15, 15, 15}, 4)}, 3);
    check_against_kernel({block(), cylinder({10, 15, 0}, {0, 0, 1}, 5, 30), cylinder({20, 15, 0}, {0, 0, 1}, 5, 30)},
                         3);
}

TEST_CASE("a cylinder tangent to a side within the solid, and a face that divides nothing") {
    check_against_kernel({block(), cylinder({5, 15, 0}, {0, 0, 1}, 5, 30)}, 2);
    check_against_kernel({block(), TopExp_Explorer(box(10, 10, 10, 5, 5, 5), TopAbs_FACE).Current()}, 1);
}
