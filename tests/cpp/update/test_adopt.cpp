// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of other makers: ours with all CAD knowledge wiped off, and damaged in known ways.
#include <BOPAlgo_Builder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>

#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"
#include "foreign_copy.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

TopoDS_Shape glued(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    BOPAlgo_Builder builder;
    builder.AddArgument(a);
    builder.AddArgument(b);
    builder.Perform();
    return builder.Shape();
}

RawDocument plain_plate() { return PartDocument().box("Part", {0, 0, 0}, {60, 30, 6}).finish(); }

MeshOptions options_of(int order) {
    MeshOptions options;
    options.sizing.size = 2.5;
    options.order = order;
    return options;
}

std::shared_ptr<const PartMesh> meshed(const RawDocument& document, int order) {
    RunContext context;
    return mesh_part(document, options_of(order), context).part_mesh;
}

PartMeshResult adopted(const RawDocument& document, const Mesh& foreign) {
    RunContext context;
    return adopt_part(document, options_of(foreign.order), foreign, context);
}

void check_valid(const PartMesh& part) {
    Expectation expected;
    const Brep& brep = part.part.brep;
    for (std::size_t s = 0; s < brep.solid_count(); ++s) expected.solid_volumes.push_back(brep.volume_of(SolidId(s)));
    expected.solids_beside_face = brep.solids_beside_faces();
    CHECK(several(broken_invariants(part.mesh, expected)).in_english() == "");
}

/// Kept nodes have their bits and numbers, new ones new numbers.
void check_kept(const Mesh& foreign, const PartMesh& now) {
    for (std::size_t n = 0; n < now.node_origin.size(); ++n) {
        if (now.node_origin[n] < 0) {
            CHECK(now.mesh.node_numbers[n] >= foreign.next_node_number);
            continue;
        }
        const auto o = std::size_t(now.node_origin[n]);
        REQUIRE(now.mesh.points[n] == foreign.points[o]);
        REQUIRE(now.mesh.node_numbers[n] == foreign.node_numbers[o]);
    }
}

/// The plane face of all points with this x.
Entity face_at(const RawDocument& document, double x) {
    RunContext context;
    const Brep brep = read_part(document, context).brep;
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        const auto edges = brep.edges_of(FaceId(f));
        if (std::all_of(edges.begin(), edges.end(),
                        [&](EdgeId e) { return std::abs(brep.point_of(brep.ends_of(e)[0]).x - x) < 1e-9; }))
            return entity_of(FaceId(f));
    }
    throw std::out_of_range("no such face");
}

/// Of the tets around the hole at (54, 15), mm.
double mean_side_near(const Mesh& mesh) {
    double sum = 0;
    int count = 0;
    for (const auto& tet : mesh.tets) {
        const Vec3 a = mesh.point(tet[0]), b = mesh.point(tet[1]);
        if (std::hypot(a.x - 54, a.y - 15) > 5) continue;
        sum += distance(a, b);
        ++count;
    }
    return sum / count;
}

std::size_t inner_node(const Mesh& mesh, int dim) {
    for (std::size_t n = 0; n < mesh.corner_count; ++n)
        if (mesh.entities[n].dim == dim) return n;
    throw std::out_of_range("no such node");
}

}  // namespace

TEST_CASE("a mesh that fits is adopted bit for bit, and what it lacks is found") {
    for (const int order : {1, 2}) {
        const auto ours = meshed(plate_with_hole(20), order);
        const Mesh foreign = foreign_copy(ours->mesh);
        const auto result = adopted(plate_with_hole(20), foreign);
        const PartMesh& now = *result.part_mesh;
        CHECK(result.report.fallbacks.empty());
        CHECK(result.report.kept_nodes_share == 1);
        CHECK(result.report.kept_tets_share == 1);
        check_kept(foreign, now);
        for (std::size_t n = 0; n < now.mesh.node_count(); ++n) {
            const auto was = std::size_t(now.node_origin[n]);
            REQUIRE(now.mesh.entities[n] == ours->mesh.entities[was]);
            REQUIRE(std::abs(now.mesh.parameters[n][0] - ours->mesh.parameters[was][0]) < 1e-9);
        }
        CHECK(now.mesh.tet_solids == ours->mesh.tet_solids);
        CHECK(now.mesh.triangles.size() == ours->mesh.triangles.size());
        CHECK(now.mesh.segments.size() == ours->mesh.segments.size());
        auto before = ours->mesh.triangle_numbers, after = now.mesh.triangle_numbers;
        std::sort(before.begin(), before.end()), std::sort(after.begin(), after.end());
        CHECK(before == after);
        check_valid(now);
    }
}

TEST_CASE("a loose vertex is where another mesher put its node, too") {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(60, 30, 6).Shape();
    const RawDocument document = PartDocument().add("Part", "Part::Feature", box).finish();
    const auto ours = meshed(document, 1);
    const Brep brep(box);
    const VertexId loose = brep.ends_of(EdgeId(0))[0];
    double first, last;
    BRep_Tool::Range(brep.edge(EdgeId(0)), first, last);
    BRep_Builder().Range(brep.edge(EdgeId(0)), first + 1.6e-7, last);
    BRep_Builder().UpdateVertex(brep.vertex(loose), 1e-5);
    const RawDocument loosened = PartDocument().add("Part", "Part::Feature", box).finish();
    const auto result = adopted(loosened, foreign_copy(ours->mesh));
    CHECK(result.report.kept_nodes_share == 1);
    check_valid(*result.part_mesh);
    RunContext context;
    const auto next = update_part(*result.part_mesh, loosened, options_of(1), context);
    CHECK(next.report.kept_nodes_share == 1);
    CHECK(next.part_mesh->mesh.points == result.part_mesh->mesh.points);
}

TEST_CASE("an adopted mesh is updated locally") {
    for (const int order : {1, 2}) {
        const Mesh foreign = foreign_copy(meshed(plate_with_hole(20), order)->mesh);
        const auto first = adopted(plate_with_hole(20), foreign);
        RunContext context;
        const auto second = update_part(*first.part_mesh, plate_with_hole(23), options_of(order), context);
        CHECK(second.report.fallbacks.empty());
        CHECK(second.report.kept_nodes_share > 0.5);
        check_kept(first.part_mesh->mesh, *second.part_mesh);
        check_valid(*second.part_mesh);
    }
}

TEST_CASE("an adopted mesh keeps its grading where it is updated, saved and restored or not") {
    MeshOptions coarse = options_of(1), graded = options_of(1);
    coarse.sizing.size = graded.sizing.size = 3;
    graded.sizing.local = {{face_at(plate_with_hole(52, 2), 60), 1.0}};
    RunContext context;
    const auto source = mesh_part(plate_with_hole(52, 2), graded, context).part_mesh;
    const auto first = adopt_part(plate_with_hole(52, 2), coarse, foreign_copy(source->mesh), context).part_mesh;
    const auto restored =
        restore_part(plate_with_hole(52, 2), coarse, first->mesh, context, first->made_for, first->adopted_sizes);
    const double full = mean_side_near(mesh_part(plate_with_hole(54, 2), graded, context).part_mesh->mesh);
    for (const auto& old : {first, restored}) {
        const auto now = update_part(*old, plate_with_hole(54, 2), coarse, context);
        CHECK(now.report.fallbacks.empty());
        CHECK(mean_side_near(now.part_mesh->mesh) < 1.25 * full);
        CHECK(mean_side_near(now.part_mesh->mesh) > 0.8 * full);
        check_valid(*now.part_mesh);
    }
}

TEST_CASE(
    "an adopted mesh that is coarser than its typical size stays as coarse where it is updated, saved and restored or "
    "not") {
    MeshOptions typical = options_of(1), graded = options_of(1);
    typical.sizing.elements_per_circle = graded.sizing.elements_per_circle = 0;
    typical.sizing.size = 4, graded.sizing.size = 6;
    graded.sizing.local = {{face_at(plate_with_hole(50), 0), 1.0}};
    RunContext context;
    const auto source = mesh_part(plate_with_hole(50), graded, context).part_mesh;
    const auto first = adopt_part(plate_with_hole(50), typical, foreign_copy(source->mesh), context).part_mesh;
    const auto restored =
        restore_part(plate_with_hole(50), typical, first->mesh, context, first->made_for, first->adopted_sizes);
    const double full = mean_side_near(mesh_part(plate_with_hole(52), graded, context).part_mesh->mesh);
    for (const auto& old : {first, restored}) {
        const auto now = update_part(*old, plate_with_hole(52), typical, context);
        CHECK(now.report.fallbacks.empty());
        CHECK(mean_side_near(now.part_mesh->mesh) > 0.6 * full);  // of few tets, where one new vertex counts
        CHECK(mean_side_near(now.part_mesh->mesh) < 1.25 * full);
        check_valid(*now.part_mesh);
    }
    // a finer size than the mesh was made with is meant
    MeshOptions fine = typical;
    fine.sizing.size = 1.5;
    const auto asked_finer = adopt_part(plate_with_hole(50), fine, foreign_copy(source->mesh), context).part_mesh;
    CHECK(mean_side_near(update_part(*asked_finer, plate_with_hole(52), fine, context).part_mesh->mesh) < 0.7 * full);
}

TEST_CASE("nodes off the surface are released with what touches them, and named") {
    for (const int order : {1, 2}) {
        Mesh foreign = foreign_copy(meshed(plate_with_hole(20), order)->mesh);
        const auto ours = meshed(plate_with_hole(20), order);
        foreign.points[inner_node(ours->mesh, 2)] += Vec3{0.01, 0.02, 0.05};
        const auto result = adopted(plate_with_hole(20), foreign);
        REQUIRE(result.report.fallbacks.size() == 1);
        CHECK(result.report.fallbacks[0].in_english().find("1 boundary node is off the surface") != std::string::npos);
        CHECK(result.report.kept_tets_share > 0.9);
        CHECK(result.report.kept_tets_share < 1);
        check_kept(foreign, *result.part_mesh);
        check_valid(*result.part_mesh);
    }
}

TEST_CASE("straight mid-side nodes on a curved face are made anew, and their elements stay") {
    const auto ours = meshed(plate_with_hole(20), 2);
    Mesh foreign = foreign_copy(ours->mesh);
    std::size_t straightened = 0;
    for (std::size_t t = 0; t < foreign.triangles.size(); ++t)
        for (int s = 0; s < 3; ++s) {
            const Vec3 middle =
                (foreign.point(foreign.triangles[t][s]) + foreign.point(foreign.triangles[t][(s + 1) % 3])) * 0.5;
            Vec3& mid = foreign.points[foreign.triangle_mids[t][s].index()];
            straightened += distance(mid, middle) > 1e-6;
            mid = middle;
        }
    REQUIRE(straightened > 20);
    const auto result = adopted(plate_with_hole(20), foreign);
    CHECK(result.report.kept_tets_share == 1);
    REQUIRE(result.report.fallbacks.size() == 1);
    CHECK(result.report.fallbacks[0].in_english().find("mid-side nodes were off the surface") != std::string::npos);
    check_kept(foreign, *result.part_mesh);
    check_valid(*result.part_mesh);
    for (std::size_t n = 0; n < result.part_mesh->mesh.node_count(); ++n)
        if (result.part_mesh->node_origin[n] < 0) CHECK(result.part_mesh->mesh.entities[n].dim < 3);
}

TEST_CASE("inverted elements are released and filled anew") {
    const auto ours = meshed(plate_with_hole(20), 1);
    Mesh foreign = foreign_copy(ours->mesh);
    foreign.points[inner_node(ours->mesh, 3)] += Vec3{3, 3, 0.5};
    const auto result = adopted(plate_with_hole(20), foreign);
    REQUIRE_FALSE(result.report.fallbacks.empty());
    CHECK(result.report.fallbacks[0].in_english().find("inverted") != std::string::npos);
    CHECK(result.report.kept_tets_share > 0.9);
    check_valid(*result.part_mesh);
}

TEST_CASE("a mesh from before an edit is brought up to the part") {
    const auto check = [](const RawDocument& was, const RawDocument& is, const char* reason) {
        const Mesh foreign = foreign_copy(meshed(was, 1)->mesh);
        const auto result = adopted(is, foreign);
        REQUIRE_FALSE(result.report.fallbacks.empty());
        CHECK(result.report.fallbacks[0].in_english().find(reason) != std::string::npos);
        CHECK(result.report.kept_tets_share > 0.1);
        check_kept(foreign, *result.part_mesh);
        check_valid(*result.part_mesh);
    };
    check(plain_plate(), plate_with_hole(20), "not covered");
    check(plate_with_hole(20), plain_plate(), "boundary");
    check(plate_with_hole(20), plate_with_hole(40), "not followed");
    check(plate_with_hole(20), plate_with_hole(20, 1.0), "off the surface");
    check(plain_plate(), plate_with_hole(31, 0.4), "not followed");
}

TEST_CASE("a mesh without tets is refused") {
    Mesh foreign = foreign_copy(meshed(plate_with_hole(20), 1)->mesh);
    foreign.tets.clear(), foreign.tet_solids.clear(), foreign.tet_numbers.clear();
    CHECK_THROWS_AS(adopted(plate_with_hole(20), foreign), InputError);
    CHECK_THROWS_AS(adopted(plate_with_hole(20), Mesh{}), InputError);
}

TEST_CASE("nothing is taken from the mesh of another part") {
    const Mesh foreign = foreign_copy(meshed(plate_with_hole(20), 1)->mesh);
    const RawDocument elsewhere = PartDocument().box("Part", {200, 0, 0}, {60, 30, 6}).finish();
    CHECK_THROWS_AS(adopted(elsewhere, foreign), InputError);
}

TEST_CASE("tets on both sides of a face between solids get their solids") {
    const TopoDS_Shape left = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 20, 20, 20).Shape();
    const TopoDS_Shape right = BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 0), 10, 20, 20).Shape();
    const RawDocument document = PartDocument().add("Part", "Part::Feature", glued(left, right)).finish();
    const auto ours = meshed(document, 1);
    REQUIRE(ours->part.brep.solid_count() == 2);
    const auto result = adopted(document, foreign_copy(ours->mesh));
    CHECK(result.report.fallbacks.empty());
    CHECK(result.report.kept_tets_share == 1);
    CHECK(result.part_mesh->mesh.tet_solids == ours->mesh.tet_solids);
    CHECK(result.part_mesh->mesh.triangles.size() == ours->mesh.triangles.size());
    check_valid(*result.part_mesh);
}

TEST_CASE("of solids that overlap each gets its own tets") {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 30, 20, 20).Shape());
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(4, 2, 2), 24, 15, 20).Shape());
    const RawDocument document = PartDocument().add("Part", "Part::Feature", both).finish();
    const auto ours = meshed(document, 1);
    const auto result = adopted(document, foreign_copy(ours->mesh));
    CHECK(result.report.fallbacks.empty());
    CHECK(result.report.kept_tets_share == 1);
    CHECK(result.part_mesh->mesh.tet_solids == ours->mesh.tet_solids);
    check_valid(*result.part_mesh);
}
