// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of solids with faces and edges beside them: one mesh that shares nodes, updated as locally as each alone.
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopTools_ListOfShape.hxx>
#include <algorithm>
#include <map>
#include <set>

#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "update/fill_part.h"
#include "update/part_mesh.h"
#include "update/shell_division.h"

using namespace featuremesh;

namespace {

TopoDS_Shape joined(std::initializer_list<TopoDS_Shape> shapes) {
    TopTools_ListOfShape arguments;
    for (const TopoDS_Shape& shape : shapes) arguments.Append(shape);
    BRepAlgoAPI_BuilderAlgo builder;
    builder.SetArguments(arguments);
    builder.Build();
    return builder.Shape();
}

/// A block of 20 x 20 x `height`, a sheet from the middle of its side at x = 20 to x = `end`, a post at the far corner.
RawDocument block_sheet_and_post(double height, double end) {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 20, 20, height).Shape();
    const TopoDS_Shape sheet = BRepBuilderAPI_MakeFace(
        BRepBuilderAPI_MakePolygon(gp_Pnt(20, 0, 5), gp_Pnt(end, 0, 5), gp_Pnt(end, 20, 5), gp_Pnt(20, 20, 5), true)
            .Wire());
    const TopoDS_Shape post = BRepBuilderAPI_MakeEdge(gp_Pnt(end, 20, 5), gp_Pnt(end, 20, 35)).Edge();
    return PartDocument()
        .add("Block", "Part::Box", block)
        .add("Sheet", "Part::Feature", sheet)
        .add("Post", "Part::Feature", post)
        .add("Both", "Part::Compound", joined({block, sheet, post}),
             {{"Links", "Block", ""}, {"Links", "Sheet", ""}, {"Links", "Post", ""}})
        .finish();
}

template <std::size_t N>
std::set<Number> unchanged(const Mesh& old_mesh, const Mesh& new_mesh,
                           const std::vector<std::array<NodeId, N>>& old_elements,
                           const std::vector<Number>& old_numbers, const std::vector<std::array<NodeId, N>>& elements,
                           const std::vector<Number>& numbers) {
    std::map<Number, std::size_t> rows;
    for (std::size_t i = 0; i < old_numbers.size(); ++i) rows.emplace(old_numbers[i], i);
    std::set<Number> same;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto row = rows.find(numbers[i]);
        bool is_same = row != rows.end();
        for (std::size_t k = 0; is_same && k < N; ++k)
            is_same = old_mesh.point(old_elements[row->second][k]) == new_mesh.point(elements[i][k]);
        if (is_same) same.insert(numbers[i]);
    }
    return same;
}

void check_sound(const PartMesh& part) {
    CHECK(several(broken_invariants(part.mesh, expectation_of(part.part.brep))).in_english() == "");
}

}  // namespace

TEST_CASE("A solid, a sheet and a post in one mesh share the nodes where they meet") {
    const int order = GENERATE(1, 2);
    RunContext context;
    const PartMeshResult result = mesh_part(block_sheet_and_post(10, 50), options_of(4, order), context);
    const Mesh& mesh = result.part_mesh->mesh;
    const Brep& brep = result.part_mesh->part.brep;
    check_sound(*result.part_mesh);
    CHECK(result.report.warnings.empty());
    CHECK(brep.has_free_faces());
    CHECK(brep.has_free_edges());
    std::set<NodeId> of_tets, of_sheet, of_post, common;
    for (const auto& tet : mesh.tets) of_tets.insert(tet.begin(), tet.end());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (brep.is_free(mesh.triangle_faces[t])) of_sheet.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    for (std::size_t s = 0; s < mesh.segments.size(); ++s)
        if (brep.is_free(mesh.segment_edges[s])) of_post.insert(mesh.segments[s].begin(), mesh.segments[s].end());
    for (const NodeId n : of_sheet)
        if (of_tets.contains(n)) common.insert(n);
    CHECK(common.size() >= 5);
    for (const NodeId n : common) CHECK(mesh.point(n).x == Approx(20));
    CHECK(of_post.size() >= 7);
    CHECK(std::count_if(of_post.begin(), of_post.end(), [&](NodeId n) { return of_sheet.contains(n); }) == 1);
}

TEST_CASE("What changes in a sheet beside a solid leaves the solid's mesh, and the other way round") {
    const int order = GENERATE(1, 2);
    RunContext context;
    const PartMeshResult before = mesh_part(block_sheet_and_post(10, 50), options_of(4, order), context);
    const Mesh& was = before.part_mesh->mesh;
    const PartMeshResult longer =
        update_part(*before.part_mesh, block_sheet_and_post(10, 56), options_of(4, order), context);
    const Mesh& is = longer.part_mesh->mesh;
    check_sound(*longer.part_mesh);
    CHECK(longer.report.fallbacks.empty());
    CHECK(unchanged(was, is, was.tets, was.tet_numbers, is.tets, is.tet_numbers).size() == was.tets.size());
    CHECK(unchanged(was, is, was.triangles, was.triangle_numbers, is.triangles, is.triangle_numbers).size() >
          0.8 * double(was.triangles.size()));
    // the post went along: its segments keep their numbers
    std::size_t moved = 0;
    const std::set<Number> old_numbers(was.segment_numbers.begin(), was.segment_numbers.end());
    for (std::size_t s = 0; s < is.segments.size(); ++s)
        if (longer.part_mesh->part.brep.is_free(is.segment_edges[s]))
            moved += old_numbers.contains(is.segment_numbers[s]);
    CHECK(moved >= 4);

    const PartMeshResult higher =
        update_part(*before.part_mesh, block_sheet_and_post(16, 50), options_of(4, order), context);
    const Mesh& now = higher.part_mesh->mesh;
    check_sound(*higher.part_mesh);
    CHECK(higher.report.fallbacks.empty());
    std::size_t shells = 0, kept = 0;
    const std::set<Number> same =
        unchanged(was, now, was.triangles, was.triangle_numbers, now.triangles, now.triangle_numbers);
    for (std::size_t t = 0; t < now.triangles.size(); ++t)
        if (higher.part_mesh->part.brep.is_free(now.triangle_faces[t]))
            ++shells, kept += same.contains(now.triangle_numbers[t]);
    CHECK(shells > 50);
    CHECK(kept == shells);
}

TEST_CASE("A solid that moves beside a sheet takes its mesh along, and leaves no node behind where the sheet ends") {
    const auto part = [](double x, double end) {
        PartDocument document;
        document.box("Block", {0, 0, 0}, {20, 20, 10}).box("Slide", {x, 40, 0}, {20, 15, 10});
        const TopoDS_Shape sheet = BRepBuilderAPI_MakeFace(
            BRepBuilderAPI_MakePolygon(gp_Pnt(20, 0, 5), gp_Pnt(end, 0, 5), gp_Pnt(end, 20, 5), gp_Pnt(20, 20, 5), true)
                .Wire());
        document.add("Sheet", "Part::Feature", sheet);
        return document
            .add("All", "Part::Compound", joined({document.shape("Block"), document.shape("Slide"), sheet}),
                 {{"Links", "Block", ""}, {"Links", "Slide", ""}, {"Links", "Sheet", ""}})
            .finish();
    };
    const int order = GENERATE(1, 2);
    const PartMeshResult before = meshed(part(0, 50), options_of(4, order));
    const PartMeshResult now = updated(*before.part_mesh, part(30, 46), options_of(4, order));
    check_sound(*now.part_mesh);
    CHECK(now.report.fallbacks.empty());
    CHECK(now.report.kept_tets_share == 1);
    const Mesh &was = before.part_mesh->mesh, &is = now.part_mesh->mesh;
    CHECK(is.tet_numbers == was.tet_numbers);
    std::set<NodeId> used;
    for (const auto& tet : is.tets) used.insert(tet.begin(), tet.end());
    for (const auto& triangle : is.triangles) used.insert(triangle.begin(), triangle.end());
    CHECK(used.size() == is.corner_count);
}

TEST_CASE("Of a solid with a sheet only the solid is meshed where solids are asked for") {
    RunContext context;
    const PartMeshResult solids = mesh_part(block_sheet_and_post(10, 50), options_of(4, 1, Dimension::solids), context);
    check_sound(*solids.part_mesh);
    CHECK(!solids.part_mesh->part.brep.has_free_faces());
    const auto& warnings = solids.report.warnings;
    CHECK(std::any_of(warnings.begin(), warnings.end(),
                      [](const auto& line) { return line.in_english().starts_with("Not meshed"); }));
    const PartMeshResult all = update_part(*solids.part_mesh, block_sheet_and_post(10, 50), options_of(4, 1), context);
    check_sound(*all.part_mesh);
    CHECK(all.report.fallbacks.empty());
    CHECK(all.report.kept_tets_share == 1);
    CHECK(all.report.triangles > solids.report.triangles);
    const PartMeshResult back =
        update_part(*all.part_mesh, block_sheet_and_post(10, 50), options_of(4, 1, Dimension::solids), context);
    check_sound(*back.part_mesh);
    CHECK(back.report.triangles == solids.report.triangles);
    CHECK(back.report.nodes == solids.report.nodes);
}

TEST_CASE("A triangle that is missing in a sheet beside a solid, or a segment in a post, is found") {
    RunContext context;
    const PartMeshResult result = mesh_part(block_sheet_and_post(10, 50), options_of(4, 1), context);
    const Brep& brep = result.part_mesh->part.brep;
    Mesh without_triangle = result.part_mesh->mesh, without_segment = without_triangle;
    std::size_t t = 0, s = 0;
    while (!brep.is_free(without_triangle.triangle_faces[t])) ++t;
    while (!brep.is_free(without_segment.segment_edges[s])) ++s;
    without_triangle.triangles.erase(without_triangle.triangles.begin() + std::ptrdiff_t(t));
    without_triangle.triangle_faces.erase(without_triangle.triangle_faces.begin() + std::ptrdiff_t(t));
    without_triangle.triangle_numbers.erase(without_triangle.triangle_numbers.begin() + std::ptrdiff_t(t));
    without_segment.segments.erase(without_segment.segments.begin() + std::ptrdiff_t(s));
    without_segment.segment_edges.erase(without_segment.segment_edges.begin() + std::ptrdiff_t(s));
    without_segment.segment_numbers.erase(without_segment.segment_numbers.begin() + std::ptrdiff_t(s));
    CHECK(broken_invariants(without_triangle, expectation_of(brep)).front().code() == Code::gap_in_face);
    CHECK(broken_invariants(without_segment, expectation_of(brep)).front().code() == Code::gap_in_edge);
}

TEST_CASE("Shells are divided where segments beside them were") {
    RunContext context;
    const PartMeshResult result = mesh_part(block_sheet_and_post(10, 50), options_of(4, 1), context);
    const Brep& brep = result.part_mesh->part.brep;
    Mesh mesh = result.part_mesh->mesh;
    const auto segments = mesh.segments;
    const auto is_shared = [&](EdgeId edge) {
        const auto faces = brep.faces_of(edge);
        return faces.size() > 1 && std::any_of(faces.begin(), faces.end(), [&](FaceId f) { return brep.is_free(f); });
    };
    std::size_t divided = 0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
        if (!is_shared(mesh.segment_edges[s])) continue;
        const auto [a, b] = segments[s];
        std::array<NodeId, 2> on;  // at a third and at two thirds
        for (const int k : {0, 1})
            on[std::size_t(k)] = mesh.add_node(mesh.point(a) + (mesh.point(b) - mesh.point(a)) * ((k + 1) / 3.0),
                                               entity_of(mesh.segment_edges[s]));
        mesh.segments[s][1] = on[0];
        mesh.add_segment(on, mesh.segment_edges[s]);
        mesh.add_segment({on[1], b}, mesh.segment_edges[s]);
        ++divided;
    }
    REQUIRE(divided >= 4);
    mesh.corner_count = mesh.node_count();
    const std::size_t before = mesh.triangles.size();
    divide_shells(brep, segments, mesh);
    CHECK(mesh.triangles.size() == before + 2 * divided);
    mesh.tets.clear(), mesh.tet_solids.clear(), mesh.tet_numbers.clear();
    Expectation sheet;
    for (std::size_t f = 0; f < brep.face_count(); ++f) sheet.is_free_face.push_back(brep.is_free(FaceId(f)));
    for (const auto& finding : broken_invariants(mesh, sheet)) {
        CHECK(finding.code() != Code::gap_in_face);
        CHECK(finding.code() != Code::triangles_overlap);
    }
}
