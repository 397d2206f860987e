// SPDX-License-Identifier: GPL-3.0-or-later
// What an update does when what it kept cannot be filled around: it keeps less, and at last nothing, and says so.
#include <BRepAlgoAPI_Common.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt.hxx>
#include <string>

#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "update/fill_part.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

constexpr double size = 2, margin = 1.2, radius = 4;

RawDocument plate(double x) {
    return PartDocument()
        .box("Plate", {0, 0, 0}, {60, 30, 6})
        .cylinder("Hole", {x, 15, -1}, radius, 8)
        .cut("Part", "Plate", "Hole")
        .finish();
}

MeshOptions options_of(int order) {
    MeshOptions options;
    options.sizing.size = size;
    options.keep_margin = margin;
    options.order = order;
    return options;
}

/// Far from the hole at `x` by no more than `reach`, which is where tets are there twice: nothing fits between them.
PartMesh damaged(const PartMesh& part, double x, double reach) {
    PartMesh twice = part;
    Mesh& mesh = twice.mesh;
    const std::size_t count = mesh.tets.size();
    for (std::size_t t = 0; t < count; ++t) {
        const Vec3& p = mesh.point(mesh.tets[t][0]);
        if (std::hypot(p.x - x, p.y - 15) > radius + reach) continue;
        mesh.tets.push_back(mesh.tets[t]);
        mesh.tet_solids.push_back(mesh.tet_solids[t]);
        mesh.tet_numbers.push_back(mesh.next_element_number++);
        if (mesh.order == 2) mesh.tet_mids.push_back(mesh.tet_mids[t]);
    }
    return twice;
}

std::string findings(const PartMesh& part) {
    Expectation expected;
    for (std::size_t s = 0; s < part.part.brep.solid_count(); ++s)
        expected.solid_volumes.push_back(part.part.brep.volume_of(SolidId(s)));
    expected.solids_beside_face = part.part.brep.solids_beside_faces();
    return several(broken_invariants(part.mesh, expected)).in_english();
}

bool has(const std::vector<featuremesh::Message>& lines, std::size_t i, const std::string& text) {
    return i < lines.size() && lines[i].in_english().find(text) != std::string::npos;
}

}  // namespace

TEST_CASE(
    "where nothing that was kept can be filled around, the part is meshed anew, and the report counts each attempt "
    "with its reason") {
    const MeshOptions options = options_of(GENERATE(1, 2));
    RunContext context;
    const auto old = mesh_part(plate(15), options, context).part_mesh;
    const PartMesh bad = damaged(*old, 15, 100);
    const PartMeshResult result = update_part(bad, plate(17), options, context);
    const auto& fallbacks = result.report.fallbacks;
    CHECK(fallbacks.size() == 3);
    CHECK(has(fallbacks, 0, "further than 1.2"));
    CHECK(has(fallbacks, 0, "the kept elements overlap"));
    CHECK(has(fallbacks, 1, "further than 2.4"));
    CHECK(has(fallbacks, 2, "full mesh: nothing could be kept"));
    CHECK(result.report.kept_nodes_share == 0);
    CHECK(result.report.kept.empty());
    const PartMesh& now = *result.part_mesh;
    CHECK(findings(now) == "");
    const auto full = mesh_part(plate(17), options, context).part_mesh;
    CHECK(now.mesh.points == full->mesh.points);
    CHECK(now.mesh.tets == full->mesh.tets);
    CHECK(std::all_of(now.node_origin.begin(), now.node_origin.end(), [](std::int32_t o) { return o < 0; }));
    CHECK(*std::min_element(now.mesh.node_numbers.begin(), now.mesh.node_numbers.end()) >= bad.mesh.next_node_number);
    CHECK(*std::min_element(now.mesh.tet_numbers.begin(), now.mesh.tet_numbers.end()) >= bad.mesh.next_element_number);
    // and it is updated locally from there
    CHECK(update_part(now, plate(18), options, context).report.fallbacks.empty());
}

TEST_CASE(
    "where only what lies near the change cannot be filled around, twice the margin does, and the report says so") {
    const MeshOptions options = options_of(GENERATE(1, 2));
    RunContext context;
    const auto old = mesh_part(plate(15), options, context).part_mesh;
    const PartMeshResult result = update_part(damaged(*old, 16, 1.6 * margin * size), plate(17), options, context);
    CHECK(result.report.fallbacks.size() == 1);
    CHECK(has(result.report.fallbacks, 0, "further than 1.2"));
    CHECK(result.report.kept_nodes_share > 0.5);
    CHECK(findings(*result.part_mesh) == "");
}

TEST_CASE("where what is new needs a finer mesh than was asked for, what is far from it stays") {
    const auto beside = [](const TopoDS_Shape& solid) {
        TopoDS_Compound both;
        BRep_Builder().MakeCompound(both);
        BRep_Builder().Add(both, BRepPrimAPI_MakeBox(gp_Pnt(30, 0, 0), 60, 30, 20).Shape());
        BRep_Builder().Add(both, solid);
        return PartDocument().add("Part", "Part::Compound", both).finish();
    };
    const TopoDS_Shape lens = BRepAlgoAPI_Common(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 10).Shape(),
                                                 BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 19), 10).Shape())
                                  .Shape();
    MeshOptions options = options_of(1);
    options.sizing.size = 5;
    options.sizing.elements_per_circle = 0;
    RunContext context;
    const auto old = mesh_part(beside(BRepPrimAPI_MakeBox(4, 4, 4).Shape()), options, context).part_mesh;
    const PartMeshResult result = update_part(*old, beside(lens), options, context);
    CHECK(result.report.fallbacks.size() == 1);
    CHECK(has(result.report.fallbacks, 0, "further than 1.2"));
    CHECK(result.report.kept_nodes_share > 0.9);
    const auto& rounds = result.report.rounds;
    CHECK(std::any_of(rounds.begin(), rounds.end(), [](const auto& round) { return round.reason == "cannot follow"; }));
    const auto& warnings = result.report.warnings;
    CHECK(std::any_of(warnings.begin(), warnings.end(),
                      [](const auto& line) { return line.code() == Code::finer_to_follow; }));
    CHECK(broken_invariants(result.part_mesh->mesh, expectation_of(result.part_mesh->part.brep)).empty());
}

TEST_CASE("where little would be kept, the part is meshed anew after the first failure, and the report says why") {
    MeshOptions options = options_of(1);
    options.keep_margin = 6;
    RunContext context;
    const auto old = mesh_part(plate(15), options, context).part_mesh;
    const PartMeshResult result = update_part(damaged(*old, 15, 100), plate(17), options, context);
    const auto& fallbacks = result.report.fallbacks;
    CHECK(fallbacks.size() == 2);
    CHECK(has(fallbacks, 0, "further than 6 "));
    CHECK(has(fallbacks, 1, "full mesh: keeping still less would take longer"));
    CHECK(result.report.kept_nodes_share == 0);
    CHECK(findings(*result.part_mesh) == "");
}

TEST_CASE("no other mesh is made where a step fails for want of time or memory") {
    MeshOptions options = options_of(1);
    options.sizing.size = 3;
    RunContext undisturbed;
    const PartMeshResult before = mesh_part(plate_with_ledge(15), options, undisturbed);
    for (const featuremesh::Message& why : {say<Code::step_does_not_end>(), say<Code::step_was_ended>()}) {
        RunContext context;
        int asked = 0;
        context.on_progress = [&](std::string_view step, double) {
            if (step == "volume" && ++asked == 1) throw MeshError(why);
            return true;
        };
        const std::string words = why.in_english();
        const auto says_why = Catch::Matchers::Contains(words);
        CHECK_THROWS_WITH(mesh_part(plate_with_ledge(15), options, context), says_why);
        CHECK(asked == 1);
        asked = 0;
        CHECK_THROWS_WITH(update_part(*before.part_mesh, plate_with_ledge(17), options, context), says_why);
        CHECK(asked == 1);
    }
}
