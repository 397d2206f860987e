// SPDX-License-Identifier: GPL-3.0-or-later
// Updates of 10-node meshes with sides that had to stay straight.
#include <algorithm>

#include "catch.h"
#include "core/messages.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "update/fill_part.h"

using namespace featuremesh;

namespace {

/// With a bore that has no room for curved sides between it and a face, where the wall is thin, and a hole far from it.
RawDocument bored_block(double wall, double radius_of_hole) {
    PartDocument document;
    document.box("Block", {0, 0, 0}, {60, 20, 10})
        .cylinder("Bore", {10, 3 + wall, -1}, 3, 12)
        .cut("Bored", "Block", "Bore");
    return document.cylinder("Hole", {50, 10, -1}, radius_of_hole, 12).cut("Part", "Bored", "Hole").finish();
}

constexpr double thin = 0.0002;

bool tells_of_straight_sides(const Report& report) {
    return std::any_of(report.warnings.begin(), report.warnings.end(),
                       [](const auto& line) { return line.code() == Code::sides_stay_straight; });
}

void check_valid(const PartMeshResult& result) {
    CHECK(broken_invariants(result.part_mesh->mesh, expectation_of(result.part_mesh->part.brep)).empty());
    CHECK(result.report.quality.min_scaled_jacobian > 0.05);
    CHECK(result.report.fallbacks.empty());
}

}  // namespace

TEST_CASE("straight sides stay through edits elsewhere, and each mesh tells of them") {
    const MeshOptions options = options_of(6, 2);
    const PartMeshResult first = meshed(bored_block(thin, 3), options);
    REQUIRE(tells_of_straight_sides(first.report));
    const PartMeshResult wider = updated(*first.part_mesh, bored_block(thin, 3.4), options);
    check_valid(wider);
    CHECK(wider.report.kept_nodes_share > 0.6);
    CHECK(tells_of_straight_sides(wider.report));
    const PartMeshResult back = updated(*wider.part_mesh, bored_block(thin, 3), options);
    check_valid(back);
    CHECK(back.report.kept_nodes_share > 0.6);
    CHECK(tells_of_straight_sides(back.report));
}

TEST_CASE("straight sides go where the face that they are off moves") {
    const MeshOptions options = options_of(6, 2);
    const PartMeshResult first = meshed(bored_block(thin, 3), options);
    const PartMeshResult moved = updated(*first.part_mesh, bored_block(2, 3), options);
    check_valid(moved);
    CHECK(moved.report.kept_nodes_share > 0.2);
    CHECK_FALSE(tells_of_straight_sides(moved.report));
}
