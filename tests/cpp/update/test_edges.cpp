// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of edges: meshed with segments, updated as locally as solids.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <map>

#include "catch.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "surface/projection.h"
#include "update/fill_part.h"

using namespace featuremesh;

namespace {

/// A frame of two posts, a beam of that length between, and an arch over them.
TopoDS_Shape frame(double length, double x = 0) {
    const gp_Pnt a(x, 0, 0), b(x, 0, 30), c(x + length, 0, 30), d(x + length, 0, 0), top(x + length / 2, 0, 50);
    BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    const TopoDS_Shape posts = BRepBuilderAPI_MakePolygon(a, b, c, d).Shape();
    builder.Add(all, posts);
    TopoDS_Vertex left, right;
    for (TopExp_Explorer it(posts, TopAbs_VERTEX); it.More(); it.Next()) {
        const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(it.Current()));
        if (p.Distance(b) < 1e-9) left = TopoDS::Vertex(it.Current());
        if (p.Distance(c) < 1e-9) right = TopoDS::Vertex(it.Current());
    }
    builder.Add(all, BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(b, top, c).Value(), left, right).Edge());
    return all;
}

RawDocument document_of(const TopoDS_Shape& shape) {
    return PartDocument().add("Frame", "Part::Feature", shape).finish();
}

void check_sound(const PartMesh& part) {
    const Mesh& mesh = part.mesh;
    CHECK(mesh.triangles.empty());
    CHECK(broken_invariants(mesh, expectation_of(part.part.brep)).empty());
    const Projector projector(part.part.brep);
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
        const Entity at = mesh.entities[n];
        REQUIRE(at.dim < 2);
        if (at.dim == 1) CHECK(projector.nearest(EdgeId(at.index), mesh.points[n]).distance < 1e-6);
    }
}

std::size_t count_same(const Mesh& old_mesh, const Mesh& new_mesh) {
    std::map<Number, std::array<Vec3, 2>> was;
    const auto ends = [](const Mesh& mesh, std::size_t s) {
        return std::array{mesh.point(mesh.segments[s][0]), mesh.point(mesh.segments[s][1])};
    };
    for (std::size_t s = 0; s < old_mesh.segments.size(); ++s) was[old_mesh.segment_numbers[s]] = ends(old_mesh, s);
    std::size_t same = 0;
    for (std::size_t s = 0; s < new_mesh.segments.size(); ++s)
        if (const auto it = was.find(new_mesh.segment_numbers[s]); it != was.end())
            same += it->second == ends(new_mesh, s);
    return same;
}

}  // namespace

TEST_CASE("A part of edges is meshed with segments") {
    const int order = GENERATE(1, 2);
    RunContext context;
    const PartMeshResult result = mesh_part(document_of(frame(80)), options_of(5, order), context);
    check_sound(*result.part_mesh);
    CHECK(result.report.dimension == Dimension::edges);
    CHECK(result.report.segments > 40);
    CHECK(result.report.lengths.share_within > 0.95);
}

TEST_CASE("Edges that did not change keep their segments, and those that moved take them along") {
    const int order = GENERATE(1, 2);
    RunContext context;
    const PartMeshResult before = mesh_part(document_of(frame(80)), options_of(5, order), context);
    const PartMeshResult longer =
        update_part(*before.part_mesh, document_of(frame(100)), options_of(5, order), context);
    check_sound(*longer.part_mesh);
    CHECK(longer.report.fallbacks.empty());
    CHECK(count_same(before.part_mesh->mesh, longer.part_mesh->mesh) >= 6 + 10);  // a post, and most of the beam
    const PartMeshResult moved =
        update_part(*before.part_mesh, document_of(frame(80, 13)), options_of(5, order), context);
    check_sound(*moved.part_mesh);
    CHECK(moved.report.kept_tets_share == 1.0);
    CHECK(moved.part_mesh->mesh.segment_numbers == before.part_mesh->mesh.segment_numbers);
}

TEST_CASE("The edges of a solid are meshed, but no seams") {
    RunContext context;
    MeshOptions options = options_of(4, 1);
    options.dimension = Dimension::edges;
    const RawDocument document = PartDocument().cylinder("Rod", {0, 0, 0}, 10, 30).finish();
    const PartMeshResult result = mesh_part(document, options, context);
    check_sound(*result.part_mesh);
    for (const auto& nodes : result.part_mesh->mesh.segments)
        CHECK(result.part_mesh->mesh.point(nodes[0]).z == Approx(result.part_mesh->mesh.point(nodes[1]).z));
}

TEST_CASE("The edges of a solid with poles are meshed without these, and a solid that has no others is refused") {
    const int order = GENERATE(1, 2);
    RunContext context;
    MeshOptions options = options_of(2, order);
    options.dimension = Dimension::edges;
    const auto meshed = [&](const TopoDS_Shape& shape) { return mesh_part(document_of(shape), options, context); };
    const PartMeshResult cone = meshed(BRepPrimAPI_MakeCone(5, 0, 10).Shape());
    check_sound(*cone.part_mesh);
    CHECK(!cone.part_mesh->mesh.segments.empty());
    for (const Vec3& p : cone.part_mesh->mesh.points) CHECK(p.z == 0);
    for (const TopoDS_Shape& shape : {BRepPrimAPI_MakeSphere(5).Shape(), BRepPrimAPI_MakeTorus(5, 2).Shape()})
        CHECK_THROWS_WITH(meshed(shape), Catch::Matchers::Contains("no edge"));
}
