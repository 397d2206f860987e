// SPDX-License-Identifier: GPL-3.0-or-later
// Parts whose planes are many faces, as where a mesh (STL) was made a solid.
#include "update/split_planes.h"

#include <algorithm>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include "catch.h"
#include "core/messages.h"
#include "part_documents.h"
#include "part_meshes.h"

using namespace featuremesh;

namespace {

/// A solid with a face for each triangle of the shape's display.
TopoDS_Shape of_triangles(const TopoDS_Shape& shape) {
    BRepMesh_IncrementalMesh(shape, 0.1);
    BRepBuilderAPI_Sewing sewing;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        TopLoc_Location place;
        const auto triangles = BRep_Tool::Triangulation(TopoDS::Face(face.Current()), place);
        for (int i = 1; i <= triangles->NbTriangles(); ++i) {
            BRepBuilderAPI_MakePolygon border;
            for (int k = 1; k <= 3; ++k)
                border.Add(triangles->Node(triangles->Triangle(i).Value(k)).Transformed(place.Transformation()));
            border.Close();
            sewing.Add(BRepBuilderAPI_MakeFace(border.Wire(), true).Face());
        }
    }
    sewing.Perform();
    TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Solid();
    BRepLib::OrientClosedSolid(solid);
    return solid;
}

TopoDS_Shape block_with_bore() {
    const gp_Ax2 up(gp_Pnt(20, 15, -1), gp::DZ());
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(60, 40, 20).Shape(), BRepPrimAPI_MakeCylinder(up, 8, 30).Shape())
        .Shape();
}

bool tells_of_planes(const TopoDS_Shape& shape) {
    const PartMeshResult result = meshed(PartDocument().add("Part", "Part::Feature", shape).finish(), options_of(6, 1));
    return std::any_of(result.report.warnings.begin(), result.report.warnings.end(),
                       [](const auto& line) { return line.code() == Code::planes_are_split; });
}

}  // namespace

TEST_CASE("where the faces of a solid are triangles of a mesh, the report tells how to join them") {
    const TopoDS_Shape split = of_triangles(block_with_bore());
    CHECK(tells_of_planes(split));
    ShapeUpgrade_UnifySameDomain joined(split);
    joined.Build();
    CHECK_FALSE(tells_of_planes(joined.Shape()));
    CHECK_FALSE(tells_of_planes(block_with_bore()));
}
