// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "catch.h"
#include "core/errors.h"
#include "volume/filled_parts.h"
#include "volume/improvement/improved.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A part's tets, of which single operations can help none any more.
struct StuckPart {
    Part part;
    Projector projector;
    TetComplex complex;
    std::vector<SurfaceVertex> vertices;
    Objective objective = objective_for(30, 1e-9);
    RunContext context;

    std::size_t planned_ahead = 0;

    StuckPart(const TopoDS_Shape& shape, double size, int threads = 1)
        : part(prepare(shape, size)), projector(part.brep) {
        context.threads = threads;
        VolumeOptions rough;
        rough.target_dihedral_deg = 5;
        const Mesh mesh = fill_solids(part.brep, part.sizing, part.surface, {}, rough, context).mesh;
        for (int v = 0; v < static_cast<int>(mesh.node_count()); ++v) {
            const Entity on = mesh.entities[v];
            complex.points.push_back(mesh.points[v]);
            complex.mobility.push_back(on.dim < 3 ? Mobility::fixed : Mobility::free);
            if (on.dim == 1 || on.dim == 2) vertices.push_back({v, on, mesh.parameters[v]});
        }
        for (const auto& tet : mesh.tets)
            complex.tets.push_back({tet[0].value, tet[1].value, tet[2].value, tet[3].value});
        complex.regions.assign(complex.tets.size(), 0);
        connect(complex);
        while (run(true) > 0) {
        }
    }
    /// Gives the number of changes.
    std::size_t run(bool is_plain) {
        LocalMesh mesh(complex, {vertices, &projector});
        const Operations operations =
            is_plain ? list_of(edge_ring(mesh, objective), vertex_move(mesh, objective), cone_refill(mesh, objective))
                     : list_of(lookahead(mesh, objective, context));
        const Improvement done = improve(mesh, objective, operations, {}, {}, context);
        vertices = mesh.release_surface();
        planned_ahead += done.planned_ahead;
        return done.changes;
    }
    std::size_t look_ahead() { return run(false); }
    double penalty() const {
        std::vector<Tet> tets = complex.tets;
        std::erase_if(tets, [](const Tet& t) { return t[0] < 0; });
        return objective.value(complex, tets).penalty;
    }
    Vec3 place_of(const SurfaceVertex& v) const {
        return v.on.dim == 1 ? projector.on_edge(EdgeId(v.on.index), v.parameters[0])
                             : projector.on_face(FaceId(v.on.index), v.parameters);
    }
    double worst_deg() const { return angle_of_flatness(worst_flatness(complex)); }
};

}  // namespace

TEST_CASE("looking ahead helps tets that no single operation helps") {
    double before = 0, after = 0;
    for (const double width : {0.3, 0.5})
        for (const double size : {4.0, 3.0, 2.0}) {
            INFO(width << " " << size);
            StuckPart stuck(cut_corner(width), size);
            const double volume = total_volume(stuck.complex), worst = stuck.worst_deg();
            before += stuck.penalty();
            stuck.look_ahead();
            after += stuck.penalty();
            CHECK(stuck.worst_deg() > worst - 1e-9);
            CHECK(find_flaws(stuck.complex).empty());
            CHECK(total_volume(stuck.complex) == Approx(volume));
            for (const SurfaceVertex& v : stuck.vertices)
                CHECK(distance(stuck.place_of(v), stuck.complex.points[v.vertex]) < 1e-9);
        }
    CHECK(after < 0.7 * before);
}

TEST_CASE("looking ahead moves fewer nodes of the surface where these are to stay") {
    std::size_t moved[2] = {0, 0};
    for (const bool are_kept : {false, true})
        for (const double width : {0.3, 0.5})
            for (const double size : {4.0, 3.0, 2.0}) {
                StuckPart stuck(cut_corner(width), size);
                for (SurfaceVertex& v : stuck.vertices) v.is_kept = are_kept;
                const TetComplex start = stuck.complex;
                stuck.look_ahead();
                for (const SurfaceVertex& v : stuck.vertices)
                    moved[are_kept] += start.points[v.vertex] != stuck.complex.points[v.vertex];
            }
    CHECK(moved[true] < moved[false]);
}

TEST_CASE("looking ahead gives the same each time, and nothing where all tets are good") {
    StuckPart first(cut_corner(0.5), 4), second(cut_corner(0.5), 4), good(cut_corner(0.8), 4);
    CHECK(first.look_ahead() > 0);
    CHECK(second.look_ahead() > 0);
    CHECK(are_same_bytes(first.complex, second.complex));
    const TetComplex start = good.complex;
    CHECK(good.look_ahead() == 0);
    CHECK(are_same_bytes(start, good.complex));
}

TEST_CASE("with a surface that moves and with lookahead any number of threads gives the same bytes") {
    StuckPart one(cut_corner(0.5), 2, 1), many(cut_corner(0.5), 2, 4);
    const auto is_same = [&] {
        return are_same_bytes(one.complex, many.complex) &&
               std::equal(one.vertices.begin(), one.vertices.end(), many.vertices.begin(), many.vertices.end(),
                          [](const SurfaceVertex& a, const SurfaceVertex& b) {
                              return a.vertex == b.vertex && a.on == b.on && a.parameters == b.parameters;
                          });
    };
    CHECK(is_same());
    CHECK(many.planned_ahead > 0);
    CHECK(one.look_ahead() == many.look_ahead());
    CHECK(is_same());
}

TEST_CASE("what may not move stays where it is") {
    StuckPart stuck(cut_corner(0.5), 4);
    const TetComplex start = stuck.complex;
    stuck.vertices.clear();
    stuck.look_ahead();
    for (std::size_t v = 0; v < start.points.size(); ++v)
        if (start.mobility[v] == Mobility::fixed || is_on_boundary(start.mobility[v]))
            CHECK(start.points[v] == stuck.complex.points[v]);
    CHECK(outside_of(start) == outside_of(stuck.complex));
}

TEST_CASE("looking ahead can be cancelled") {
    StuckPart stuck(cut_corner(0.5), 4);
    stuck.context.cancel();
    CHECK_THROWS_AS(stuck.look_ahead(), Cancelled);
}
