// SPDX-License-Identifier: GPL-3.0-or-later
// Parts with what is far smaller than the size: thin rods.
#include "catch.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "update/fill_part.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

MeshOptions options_of(double size, int order = 1) {
    MeshOptions options;
    options.sizing.size = size;
    options.order = order;
    return options;
}

PartMeshResult meshed(const RawDocument& document, const MeshOptions& options) {
    RunContext context;
    return mesh_part(document, options, context);
}

PartMeshResult updated(const PartMesh& old, const RawDocument& document, const MeshOptions& options) {
    RunContext context;
    return update_part(old, document, options, context);
}

void check_valid(const PartMesh& part) { CHECK(broken_invariants(part.mesh, expectation_of(part.part.brep)).empty()); }

}  // namespace

TEST_CASE("a rod that is far thinner than the size is meshed in both orders, which is said once") {
    const auto rod = [](double length) { return PartDocument().cylinder("Rod", {0, 0, 0}, 1, length).finish(); };
    for (const int order : {1, 2}) {
        MeshOptions options = options_of(80, order);
        options.sizing.min_size = 8;
        const PartMeshResult result = meshed(rod(300), options);
        check_valid(*result.part_mesh);
        CHECK(result.report.rounds.empty());
        CHECK(result.report.quality.min_dihedral > 20);
        REQUIRE(result.report.warnings.size() == 1);
        CHECK(result.report.warnings[0].starts_with("The part is 2 mm thick at Face1: elements are smaller there"));
        const PartMeshResult longer = updated(*result.part_mesh, rod(310), options);
        check_valid(*longer.part_mesh);
        CHECK(longer.report.kept_nodes_share > 0.9);
    }
}
