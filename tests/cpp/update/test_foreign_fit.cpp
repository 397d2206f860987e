// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/foreign_fit.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <gp_Ax2.hxx>

#include "catch.h"
#include "core/errors.h"
#include "foreign_copy.h"
#include "part_documents.h"
#include "update/part_mesh.h"
#include "update/shape_coverage.h"

using namespace featuremesh;

namespace {

std::shared_ptr<const PartMesh> meshed_plate(int order) {
    const RawDocument document = PartDocument()
                                     .box("Plate", {0, 0, 0}, {40, 30, 6})
                                     .cylinder("Hole", {20, 15, -1}, 5, 8)
                                     .cut("Part", "Plate", "Hole")
                                     .finish();
    MeshOptions options;
    options.sizing.size = 3;
    options.order = order;
    RunContext context;
    return mesh_part(document, options, context).part_mesh;
}

ForeignFit fitted(const Brep& brep, const Mesh& foreign, int layers = 0) {
    RunContext context;
    return fit_to_shape(brep, foreign, layers, context);
}

std::size_t node_inside_a_face(const Mesh& mesh) {
    const auto end = mesh.entities.begin() + std::ptrdiff_t(mesh.corner_count);
    const auto found = std::find_if(mesh.entities.begin(), end, [](const Entity& entity) { return entity.dim == 2; });
    REQUIRE(found != end);
    return std::size_t(found - mesh.entities.begin());
}

std::size_t tets_at(const Mesh& mesh, NodeId node) {
    return std::size_t(std::count_if(mesh.tets.begin(), mesh.tets.end(), [&](const auto& tet) {
        return std::find(tet.begin(), tet.end(), node) != tet.end();
    }));
}

}  // namespace

TEST_CASE("of a foreign mesh that fits every element stays, on the entities it had") {
    for (const int order : {1, 2}) {
        const auto ours = meshed_plate(order);
        const ForeignFit fit = fitted(ours->part.brep, foreign_copy(ours->mesh));
        CHECK(fit.released_tets == 0);
        CHECK(fit.moved_mids == 0);
        CHECK(fit.reasons.empty());
        CHECK((fit.kept.curved != nullptr) == (order == 2));
        const Mesh& kept = fit.kept.mesh;
        REQUIRE(kept.tets.size() == ours->mesh.tets.size());
        REQUIRE(kept.node_count() == ours->mesh.corner_count);
        CHECK(kept.triangles.size() == ours->mesh.triangles.size());
        CHECK(kept.segments.size() == ours->mesh.segments.size());
        for (std::size_t n = 0; n < kept.node_count(); ++n) {
            const auto origin = std::size_t(fit.kept.node_origin[n]);
            REQUIRE(kept.points[n] == ours->mesh.points[origin]);
            REQUIRE(kept.entities[n] == ours->mesh.entities[origin]);
            REQUIRE(kept.node_numbers[n] == ours->mesh.node_numbers[origin]);
        }
        for (const auto& tet : kept.tets)
            REQUIRE(signed_volume(kept.point(tet[0]), kept.point(tet[1]), kept.point(tet[2]), kept.point(tet[3])) > 0);
    }
}

TEST_CASE("what touches a node off the surface is released, and the layers around it on request") {
    const auto ours = meshed_plate(1);
    Mesh foreign = foreign_copy(ours->mesh);
    const std::size_t moved = node_inside_a_face(ours->mesh);
    foreign.points[moved] += Vec3{0.01, 0.01, 0.01};
    const ForeignFit fit = fitted(ours->part.brep, foreign);
    CHECK(fit.released_tets >= tets_at(foreign, NodeId(moved)));
    REQUIRE_FALSE(fit.reasons.empty());
    CHECK(fit.reasons[0].in_english() == "1 boundary node is off the surface");
    const auto& origins = fit.kept.node_origin;
    CHECK(std::find(origins.begin(), origins.end(), std::int32_t(moved)) == origins.end());
    const ForeignFit less = fitted(ours->part.brep, foreign, 1);
    CHECK(less.released_tets > fit.released_tets);
    CHECK(less.kept.mesh.tets.size() + less.released_tets == foreign.tets.size());
}

TEST_CASE("straight mid-side nodes on a curved face are moved onto it, and nothing is released") {
    const auto ours = meshed_plate(2);
    Mesh foreign = foreign_copy(ours->mesh);
    for (std::size_t t = 0; t < foreign.triangles.size(); ++t)
        for (std::size_t s = 0; s < 3; ++s)
            foreign.points[foreign.triangle_mids[t][s].index()] =
                (foreign.point(foreign.triangles[t][s]) + foreign.point(foreign.triangles[t][(s + 1) % 3])) / 2;
    const ForeignFit fit = fitted(ours->part.brep, foreign);
    CHECK(fit.moved_mids > 10);
    CHECK(fit.released_tets == 0);
}

TEST_CASE("a mesh of which nothing fits is refused with its reason") {
    const auto ours = meshed_plate(1);
    const Brep elsewhere(BRepPrimAPI_MakeBox(gp_Pnt(100, 0, 0), 10, 10, 10).Shape());
    CHECK_THROWS_WITH(fitted(elsewhere, foreign_copy(ours->mesh)),
                      Catch::Matchers::StartsWith("No element of the mesh fits the part: "));
}

TEST_CASE("a mesh in other units is refused, too, however much of the part it leaves bare") {
    Mesh metres = foreign_copy(meshed_plate(1)->mesh);
    for (Vec3& p : metres.points) p *= 1e-3;
    const Brep rod(BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 0), 100, 2, 2).Shape());
    CHECK_THROWS_AS(fitted(rod, metres), InputError);
}

TEST_CASE("looking for bare places can be cancelled") {
    const Brep brep(BRepPrimAPI_MakeBox(100, 100, 100).Shape());
    std::vector<FaceId> open;
    std::vector<Vec3> points;
    RunContext context;
    context.cancel();
    CHECK_THROWS_AS(sample_open_faces(brep, {}, {}, 1, open, points, context), Cancelled);
}
