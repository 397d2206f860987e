// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/detours.h"

#include <algorithm>

#include "box_of_tets.h"
#include "catch.h"
#include "core/errors.h"
#include "filled_parts.h"
#include "volume/edge_removal.h"
#include "volume/optimise.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A part's tets, of which single operations can help none any more.
struct StuckPart {
    Part part;
    Projector projector;
    TetComplex complex;
    std::vector<BoundaryVertex> vertices;
    BoundaryMoveOptions options{.least_volume = 1e-9};
    RunContext context;

    StuckPart(const TopoDS_Shape& shape, double size) : part(prepare(shape, size)), projector(part.brep) {
        VolumeOptions rough;
        rough.target_dihedral_deg = 5;
        const Mesh mesh = fill_solids(part.brep, part.sizing, part.surface, {}, rough, context).mesh;
        for (int v = 0; v < static_cast<int>(mesh.node_count()); ++v) {
            const Entity on = mesh.entities[v];
            complex.points.push_back(mesh.points[v]);
            complex.is_fixed.push_back(on.dim < 3);
            if (on.dim == 1 || on.dim == 2) vertices.push_back({v, on, mesh.parameters[v]});
        }
        for (const auto& tet : mesh.tets)
            complex.tets.push_back({tet[0].value, tet[1].value, tet[2].value, tet[3].value});
        complex.regions.assign(complex.tets.size(), 0);
        connect(complex);
        for (std::size_t changes = 1; changes > 0;) {
            const SliverReport slivers = remove_slivers(complex, {}, context);
            changes = slivers.edge_removals + slivers.face_flips + slivers.moves + slivers.insertions +
                      slivers.collapses + move_on_boundary(complex, vertices, projector, options, context).size();
        }
    }
    std::size_t detour() { return take_detours(complex, vertices, projector, options, context); }
    double burden() const {
        std::vector<Tet> tets;
        for (const Tet& tet : complex.tets)
            if (tet[0] >= 0) tets.push_back(tet);
        return burden_of(complex, tets, flatness_of_angle(30));
    }
    Vec3 place_of(const BoundaryVertex& v) const {
        return v.on.dim == 1 ? projector.on_edge(EdgeId(v.on.index), v.parameters[0])
                             : projector.on_face(FaceId(v.on.index), v.parameters);
    }
    double worst_deg() const { return angle_of_flatness(worst_flatness(complex)); }
};

}  // namespace

TEST_CASE("detours help tets that no single operation helps") {
    double before = 0, after = 0;
    for (const double width : {0.3, 0.5})
        for (const double size : {4.0, 3.0, 2.0}) {
            INFO(width << " " << size);
            StuckPart stuck(cut_corner(width), size);
            const double volume = total_volume(stuck.complex), worst = stuck.worst_deg();
            before += stuck.burden();
            stuck.detour();
            after += stuck.burden();
            CHECK(stuck.worst_deg() > worst - 1e-9);
            CHECK(find_flaws(stuck.complex).empty());
            CHECK(total_volume(stuck.complex) == Approx(volume));
            for (const BoundaryVertex& v : stuck.vertices)
                CHECK(distance(stuck.place_of(v), stuck.complex.points[v.vertex]) < 1e-9);
        }
    CHECK(after < 0.7 * before);
}

TEST_CASE("detours are the same each time, and none are taken where all tets are good") {
    StuckPart first(cut_corner(0.5), 4), second(cut_corner(0.5), 4), good(cut_corner(0.8), 4);
    CHECK(first.detour() > 0);
    CHECK(second.detour() > 0);
    CHECK(are_same_bytes(first.complex, second.complex));
    const TetComplex start = good.complex;
    CHECK(good.detour() == 0);
    CHECK(are_same_bytes(start, good.complex));
}

TEST_CASE("what may not move stays where it is on a detour") {
    StuckPart stuck(cut_corner(0.5), 4);
    const TetComplex start = stuck.complex;
    stuck.vertices.clear();
    stuck.detour();
    for (std::size_t v = 0; v < start.points.size(); ++v)
        if (start.is_fixed[v]) CHECK(start.points[v] == stuck.complex.points[v]);
    CHECK(outside_of(start) == outside_of(stuck.complex));
}

TEST_CASE("detours can be cancelled") {
    StuckPart stuck(cut_corner(0.5), 4);
    stuck.context.cancel();
    CHECK_THROWS_AS(stuck.detour(), Cancelled);
}
