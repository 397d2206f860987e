// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "box_mesh.h"
#include "catch.h"
#include "mesh/quality.h"
#include "mesh/sharp_angles.h"

using namespace featuremesh;

namespace {

/// The unit box with its y axis leant over until the edges (x=0, y=0) and (x=1, y=1) are `angle` degrees sharp.
Mesh leaning_box(int n, double angle) {
    Mesh mesh = box_mesh(n);
    const double radians = angle * std::numbers::pi / 180;
    for (Vec3& p : mesh.points) p = {p.x + p.y * std::cos(radians), p.y * std::sin(radians), p.z};
    return mesh;
}

bool any_of(const Mesh& mesh, TetId tet, auto holds) {
    return std::any_of(mesh.tets[tet.index()].begin(), mesh.tets[tet.index()].end(),
                       [&](NodeId n) { return holds(n.index()); });
}

}  // namespace

TEST_CASE("a box forces no angle") {
    const Mesh mesh = box_mesh(3);
    const SharpAngles sharp(mesh, 25);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) CHECK(!sharp.force(TetId(t)));
    CHECK(measure_quality(mesh).min_dihedral_unforced == measure_quality(mesh).min_dihedral);
}

TEST_CASE("tets at a sharp edge are forced, the others are not") {
    const Mesh box = box_mesh(4), mesh = leaning_box(4, 15);
    const SharpAngles sharp(mesh, 25);
    const auto x = [&](std::size_t n) { return box.points[n].x; };
    const auto y = [&](std::size_t n) { return box.points[n].y; };
    int forced = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const bool touches =
            any_of(mesh, TetId(t), [&](std::size_t n) { return x(n) == y(n) && (x(n) == 0 || x(n) == 1); });
        const bool spans = !any_of(mesh, TetId(t), [&](std::size_t n) { return x(n) > 0 && y(n) > 0; }) ||
                           !any_of(mesh, TetId(t), [&](std::size_t n) { return x(n) < 1 && y(n) < 1; });
        CHECK(sharp.force(TetId(t)) == (touches || spans));
        forced += touches || spans;
    }
    const QualityReport quality = measure_quality(mesh);
    CHECK(forced > 0);
    CHECK(quality.forced_by_cad <= forced);
    CHECK(quality.forced_by_cad > 0);
    CHECK(quality.min_dihedral < 15.001);
    REQUIRE(quality.worst.is_valid());
    const auto& n = mesh.tets[quality.worst.index()];
    CHECK(dihedral_range(mesh.point(n[0]), mesh.point(n[1]), mesh.point(n[2]), mesh.point(n[3])).smallest_deg ==
          Approx(quality.min_dihedral));
    CHECK(!measure_quality(box).worst.is_valid());
}

TEST_CASE("an edge less sharp than the limit forces nothing") {
    const Mesh mesh = leaning_box(4, 26);
    const SharpAngles sharp(mesh, 25);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) CHECK(!sharp.force(TetId(t)));
    CHECK(measure_quality(mesh).forced_by_cad == 0);
}

TEST_CASE("a face's sharp corner forces the tets that touch it") {
    Mesh mesh;
    const double low = std::tan(20 * std::numbers::pi / 180);
    const std::array<Vec3, 4> corners{Vec3{0, 0, 0}, {1, 0, 0}, {1, low, 0}, {0.7, 0.1, 1}};
    for (int i = 0; i < 4; ++i) mesh.add_node(corners[i], entity_of(VertexId(i)));
    mesh.corner_count = 4;
    mesh.add_triangle({NodeId(0), NodeId(2), NodeId(1)}, FaceId(0));
    mesh.add_tet({NodeId(0), NodeId(1), NodeId(2), NodeId(3)}, SolidId(0));
    CHECK(SharpAngles(mesh, 21).force(TetId(0)));
    CHECK(!SharpAngles(mesh, 19).force(TetId(0)));
}

TEST_CASE("a CAD edge far shorter than the others forces its tets, a short piece of one does not") {
    Mesh mesh;
    const std::array<Vec3, 4> corners{Vec3{0, 0, 0}, {1e-4, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}};
    for (int i = 0; i < 4; ++i) mesh.add_node(corners[i], entity_of(VertexId(i)));
    mesh.corner_count = 4;
    mesh.add_segment({NodeId(0), NodeId(1)}, EdgeId(0));
    mesh.add_tet({NodeId(0), NodeId(1), NodeId(2), NodeId(3)}, SolidId(0));
    CHECK(SharpAngles(mesh, 0.001).force(TetId(0)));
    REQUIRE(ShortSides(mesh).forced_side(TetId(0)));
    mesh.entities[1] = entity_of(EdgeId(0));
    CHECK(!ShortSides(mesh).forced_side(TetId(0)));
    mesh.entities[1] = entity_of(FaceId(0));
    CHECK(!ShortSides(mesh).forced_side(TetId(0)));
    mesh.segments.clear(), mesh.segment_edges.clear();
    mesh.entities[1] = entity_of(EdgeId(1));
    CHECK(ShortSides(mesh).forced_side(TetId(0)));
    mesh.points[1].x = 0.1;
    CHECK(!ShortSides(mesh).forced_side(TetId(0)));
}
