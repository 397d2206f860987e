// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "catch.h"
#include "core/errors.h"
#include "mesh/quality.h"
#include "volume/filled_parts.h"
#include "volume/improvement/improved.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A cube of 4 with nothing free, and the vertex there of the lattice.
struct FixedBox {
    Brep brep{box_part({0, 0, 0}, {4, 4, 4})};
    Projector projector{brep};
    TetComplex complex = box_of_tets(4, 0, 1);

    FixedBox() { fix_all(complex); }
    static int vertex_at(int x, int y, int z) { return x + 5 * y + 25 * z; }

    SurfaceVertex on_nearest_face(int vertex) const {
        for (std::size_t f = 0; f < brep.face_count(); ++f)
            if (const OnFace there = projector.nearest(FaceId(f), complex.points[vertex]); there.distance < 1e-9)
                return {vertex, entity_of(FaceId(f)), there.uv};
        return {};
    }
    SurfaceVertex on_nearest_edge(int vertex) const {
        for (std::size_t e = 0; e < brep.edge_count(); ++e)
            if (const OnEdge there = projector.nearest(EdgeId(e), complex.points[vertex]); there.distance < 1e-9)
                return {vertex, entity_of(EdgeId(e)), {there.t, 0}};
        return {};
    }
    double worst_deg() const { return angle_of_flatness(worst_flatness(complex)); }
    double mean_radius_ratio_at(int vertex) const {
        double sum = 0;
        int count = 0;
        for (const auto& t : complex.tets)
            if (const auto& p = complex.points; std::find(t.begin(), t.end(), vertex) != t.end())
                sum += radius_ratio(p[t[0]], p[t[1]], p[t[2]], p[t[3]]), ++count;
        return sum / count;
    }
    /// Gives how often a vertex was moved.
    std::size_t move(std::vector<SurfaceVertex>& vertices, double target_deg = 30) {
        RunContext context;
        return move(vertices, target_deg, context);
    }
    std::size_t move(std::vector<SurfaceVertex>& vertices, double target_deg, RunContext& context) {
        const Objective objective = objective_for(target_deg, 1e-9, 0.6);
        LocalMesh mesh(complex, {vertices, &projector});
        const Improvement done = improve(mesh, objective, list_of(vertex_move(mesh, objective)), {}, {}, context);
        vertices = mesh.release_surface();
        return done.changes;
    }
};

double worst_in(const Mesh& mesh) { return measure_quality(mesh).min_dihedral; }

/// With its surface as it is given.
VolumeResult fill_between_kept_nodes(const Part& part) {
    RunContext context;
    KeptRim rim;
    rim.kept_nodes = part.surface.node_count();
    return fill_solids(part.brep, part.sizing, part.surface, {}, {}, context, rim);
}

}  // namespace

TEST_CASE("a vertex inside a face goes along it to where its tets are good again") {
    FixedBox box;
    const int vertex = FixedBox::vertex_at(2, 2, 0);
    const double good = box.worst_deg();
    box.complex.points[vertex] += {0.55, -0.3, 0};
    REQUIRE(box.worst_deg() < 0.6 * good);
    std::vector<SurfaceVertex> vertices{box.on_nearest_face(vertex)};
    CHECK(box.move(vertices) > 0);
    CHECK(box.worst_deg() > 30);
    CHECK(box.complex.points[vertex].z == Approx(0).margin(1e-12));
    CHECK(distance(box.projector.on_face(FaceId(vertices[0].on.index), vertices[0].parameters),
                   box.complex.points[vertex]) < 1e-9);
    CHECK(find_flaws(box.complex).empty());
    CHECK(total_volume(box.complex) == Approx(64));
}

TEST_CASE("a vertex goes to where most of its tets are rounder, at the cost of no angle") {
    FixedBox box;
    const int on_face = FixedBox::vertex_at(2, 2, 0), on_edge = FixedBox::vertex_at(2, 0, 0);
    const auto [vertex, shift] = GENERATE_COPY(
        table<int, Vec3>({{on_face, {0.85, 0.6, 0}}, {on_face, {0.5, -0.45, 0}}, {on_edge, {0.9, 0, 0}}}));
    box.complex.points[vertex] += shift;
    const double before = box.mean_radius_ratio_at(vertex), angle = box.worst_deg();
    REQUIRE(before < 0.6);
    std::vector<SurfaceVertex> vertices{vertex == on_face ? box.on_nearest_face(vertex) : box.on_nearest_edge(vertex)};
    constexpr double no_angle_matters = 0.5;
    CHECK(box.move(vertices, no_angle_matters) > 0);
    CHECK(box.mean_radius_ratio_at(vertex) > before + 0.05);
    CHECK(box.worst_deg() >= std::min(angle, no_angle_matters));
    CHECK(box.complex.points[vertex].z == Approx(0).margin(1e-12));
    CHECK(find_flaws(box.complex).empty());
    CHECK(total_volume(box.complex) == Approx(64));
}

TEST_CASE("a vertex inside an edge goes along it") {
    FixedBox box;
    const int vertex = FixedBox::vertex_at(2, 0, 0);
    const double good = box.worst_deg();
    box.complex.points[vertex] += {0.7, 0, 0};
    REQUIRE(box.worst_deg() < 0.6 * good);
    std::vector<SurfaceVertex> vertices{box.on_nearest_edge(vertex)};
    CHECK(box.move(vertices) > 0);
    CHECK(box.worst_deg() > 30);
    CHECK(distance(box.projector.on_edge(EdgeId(vertices[0].on.index), vertices[0].parameters[0]),
                   box.complex.points[vertex]) < 1e-9);
    CHECK(find_flaws(box.complex).empty());
    CHECK(total_volume(box.complex) == Approx(64));
}

TEST_CASE("only the vertices given move, and none where no tet is bad") {
    FixedBox box;
    std::vector<SurfaceVertex> all{box.on_nearest_face(FixedBox::vertex_at(2, 2, 0)),
                                   box.on_nearest_face(FixedBox::vertex_at(2, 0, 2))};
    const TetComplex start = box.complex;
    CHECK(box.move(all) == 0);
    CHECK(box.complex.points == start.points);
    box.complex.points[FixedBox::vertex_at(2, 2, 0)] += {0.55, -0.3, 0};
    const TetComplex bad = box.complex;
    std::vector<SurfaceVertex> second{all[1]};
    CHECK(box.move(second) == 0);
    CHECK(box.complex.points == bad.points);
}

TEST_CASE("for tets that will follow a face a vertex stays where that bends by more than 60 degrees, only there") {
    FixedBox box;
    const int vertex = FixedBox::vertex_at(2, 2, 0);
    const std::vector<SurfaceVertex> vertices{box.on_nearest_face(vertex)};
    const auto [height, is_bent] = GENERATE(table<double, bool>({{0, false}, {-0.3, false}, {-1.5, true}}));
    box.complex.points[vertex].z += height;
    LocalMesh::Star star;
    for (const bool is_for_curved_tets : {false, true}) {
        const LocalMesh mesh(box.complex, {vertices, &box.projector, is_for_curved_tets});
        REQUIRE(mesh.gather(vertex, star));
        CHECK(mesh.is_held(vertex, star) == (is_for_curved_tets && is_bent));
    }
}

TEST_CASE("moves on the boundary can be cancelled") {
    FixedBox box;
    const int vertex = FixedBox::vertex_at(2, 2, 0);
    box.complex.points[vertex] += {0.55, -0.3, 0};
    std::vector<SurfaceVertex> vertices{box.on_nearest_face(vertex)};
    RunContext context;
    context.cancel();
    CHECK_THROWS_AS(box.move(vertices, 30, context), Cancelled);
}

TEST_CASE("a search that gains next to nothing by each step ends") {
    // beside a wall of 0.08: each step made the flattest tet better in the last digit, for hours
    TetComplex star;
    star.points = {{1.6498528668716244, 7.4336566653811174, 14.591324445726412},
                   {1.1397884676530605, 7.6352602334679398, 14.499592838818547},
                   {-1.0371028989081914, 8.5714546086561114, 13.88983705950924},
                   {0.33115956808116653, 7.7706611207905327, 14.365400265788734},
                   {1.6156344634045152, 7.4591685690190488, 14.745526403032185},
                   {1.63274366513807, 7.4464126172000835, 14.668425424379299}};
    star.tets = {{0, 1, 2, 3}, {4, 1, 3, 2}, {3, 1, 4, 0}, {0, 5, 2, 1}, {1, 4, 5, 2}, {1, 5, 4, 0}};
    fix_all(star);
    star.mobility[1] = Mobility::free;
    star.regions.assign(star.tets.size(), 0);
    connect(star);
    improve_inside(star, 30);
    CHECK(find_flaws(star).empty());
}

TEST_CASE("the smallest angle of a part is larger where surface nodes may move, and they stay on their entities") {
    double with = 0, without = 0;
    for (const double width : {0.3, 0.5, 0.8})
        for (const double size : {4.0, 3.0, 2.0}) {
            INFO(width << " " << size);
            SizingOptions options;
            options.size = options.min_size = size;  // or the chamfer would get shorter pieces
            const Part part = prepare(cut_corner(width), options);
            const VolumeResult kept = fill_between_kept_nodes(part), free = fill(part);
            CHECK(std::equal(part.surface.points.begin(), part.surface.points.end(), kept.mesh.points.begin()));
            CHECK(findings(part.brep, free.mesh).empty());
            const double before = worst_in(kept.mesh), after = worst_in(free.mesh);
            CHECK(after > before - 0.1);
            without += before, with += after;
            const Projector projector(part.brep);
            for (std::size_t n = 0; n < free.mesh.node_count(); ++n) {
                const Entity on = free.mesh.entities[n];
                const auto& at = free.mesh.parameters[n];
                if (on.dim == 2) CHECK(distance(projector.on_face(FaceId(on.index), at), free.mesh.points[n]) < 1e-9);
                if (on.dim == 1)
                    CHECK(distance(projector.on_edge(EdgeId(on.index), at[0]), free.mesh.points[n]) < 1e-9);
            }
        }
    CHECK(with > without + 15);
}
