// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <random>

#include "box_mesh.h"
#include "catch.h"
#include "mesh/quality.h"

using namespace featuremesh;

namespace {

Mesh random_tets(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(0, 1);
    Mesh mesh;
    while (mesh.tets.size() < static_cast<std::size_t>(count)) {
        std::array<Vec3, 4> p;
        for (Vec3& q : p) q = {coordinate(random), coordinate(random), coordinate(random)};
        if (signed_volume(p[0], p[1], p[2], p[3]) < 1e-4) continue;
        std::array<NodeId, 4> tet;
        for (int i = 0; i < 4; ++i) tet[i] = mesh.add_node(p[i], entity_of(SolidId(0)));
        mesh.add_tet(tet, SolidId(0));
    }
    mesh.corner_count = mesh.points.size();
    return mesh;
}

/// The angle between the two faces at edge (a, b), seen along the edge.
double angle_at_edge(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 e = normalized(b - a);
    const Vec3 to_c = c - a - dot(c - a, e) * e, to_d = d - a - dot(d - a, e) * e;
    return std::acos(dot(to_c, to_d) / length(to_c) / length(to_d)) * 180 / std::numbers::pi;
}

std::array<double, 6> angles_of(const Mesh& mesh, std::size_t t) {
    const auto& n = mesh.tets[t];
    const Vec3 &a = mesh.point(n[0]), &b = mesh.point(n[1]), &c = mesh.point(n[2]), &d = mesh.point(n[3]);
    return {angle_at_edge(a, b, c, d), angle_at_edge(a, c, b, d), angle_at_edge(a, d, b, c),
            angle_at_edge(b, c, a, d), angle_at_edge(b, d, a, c), angle_at_edge(c, d, a, b)};
}

}  // namespace

TEST_CASE("the regular tet has equal dihedral angles and radius ratio 1") {
    const Vec3 a{1, 1, 1}, b{1, -1, -1}, c{-1, 1, -1}, d{-1, -1, 1};
    const auto range = dihedral_range(a, b, c, d);
    CHECK(range.smallest_deg == Approx(70.528779365509308));
    CHECK(range.largest_deg == Approx(70.528779365509308));
    CHECK(radius_ratio(a, b, c, d) == Approx(1.0));
}

TEST_CASE("the corner tet has right angles and the inradius of its inscribed sphere") {
    const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
    const auto range = dihedral_range(a, b, c, d);
    CHECK(range.smallest_deg == Approx(54.735610317245346));
    CHECK(range.largest_deg == Approx(90.0));
    const double r = 1 / (3 + std::sqrt(3.0)), R = std::sqrt(3.0) / 2;
    CHECK(radius_ratio(a, b, c, d) == Approx(3 * r / R));
}

TEST_CASE("a flat tet has radius ratio 0 and angles 0 and 180") {
    const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0};
    CHECK(radius_ratio(a, b, c, d) == 0.0);
    CHECK(dihedral_range(a, b, c, d).largest_deg == Approx(180.0));
    CHECK(dihedral_range(a, b, c, d).smallest_deg == Approx(0.0));
}

TEST_CASE("the report agrees with angles taken edge by edge") {
    const Mesh mesh = random_tets(3000, 7);
    double smallest = 180, largest = 0, sum = 0, ratios = 0;
    std::array<std::int64_t, 36> histogram{};
    std::int64_t below_20 = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const auto angles = angles_of(mesh, t);
        const double low = *std::min_element(angles.begin(), angles.end());
        smallest = std::min(smallest, low);
        largest = std::max(largest, *std::max_element(angles.begin(), angles.end()));
        sum += low;
        below_20 += low < 20;
        for (double angle : angles) ++histogram[static_cast<std::size_t>(angle / 5)];
        const auto& n = mesh.tets[t];
        ratios += radius_ratio(mesh.point(n[0]), mesh.point(n[1]), mesh.point(n[2]), mesh.point(n[3]));
    }
    const QualityReport report = measure_quality(mesh);
    CHECK(report.min_dihedral == Approx(smallest));
    CHECK(report.max_dihedral == Approx(largest));
    CHECK(report.mean_min_dihedral == Approx(sum / 3000));
    CHECK(report.mean_radius_ratio == Approx(ratios / 3000));
    CHECK(report.below_20 == below_20);
    CHECK(report.histogram == histogram);
}

TEST_CASE("quality is the same for any number of threads, and after a motion and a scaling") {
    Mesh mesh = box_mesh(16);
    RunContext one, three;
    three.threads = 3;
    const QualityReport a = measure_quality(mesh, one), b = measure_quality(mesh, three);
    CHECK(a.mean_radius_ratio == b.mean_radius_ratio);
    CHECK(a.mean_min_dihedral == b.mean_min_dihedral);
    CHECK(a.histogram == b.histogram);
    for (Vec3& p : mesh.points) p = Vec3{p.y, p.z, p.x} * 0.01 + Vec3{5, -3, 2};
    const QualityReport moved = measure_quality(mesh);
    CHECK(moved.mean_radius_ratio == Approx(a.mean_radius_ratio));
    CHECK(moved.min_dihedral == Approx(a.min_dihedral));
}

TEST_CASE("triangles: regular, with sides 3, 4 and 5, and flat") {
    CHECK(radius_ratio({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(3.0) / 2, 0}) == Approx(1));
    CHECK(radius_ratio({0, 0, 0}, {3, 0, 0}, {0, 4, 0}) == Approx(2 * 1 / 2.5));
    CHECK(radius_ratio({0, 0, 0}, {1, 0, 0}, {2, 0, 0}) == Approx(0).margin(1e-12));
}

TEST_CASE("a mesh without tets is judged by the angles of its triangles, but for those between edges") {
    Mesh mesh;
    for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{10, 0, 0}, Vec3{10, 1, 0}, Vec3{0, 8, 0}})
        mesh.add_node(p, entity_of(FaceId(0)));
    mesh.corner_count = 4;
    const std::array<NodeId, 4> n{NodeId(0), NodeId(1), NodeId(2), NodeId(3)};
    mesh.add_triangle({n[0], n[1], n[2]}, FaceId(0));
    mesh.add_triangle({n[0], n[2], n[3]}, FaceId(0));
    const double sharp = std::atan(0.1) * 180 / std::numbers::pi;
    const QualityReport free = measure_quality(mesh);
    CHECK(free.min_dihedral == Approx(sharp));
    CHECK(free.min_dihedral_unforced == Approx(sharp));
    CHECK(free.below_10 == 1);
    mesh.add_segment({n[0], n[1]}, EdgeId(0)), mesh.add_segment({n[0], n[2]}, EdgeId(1));
    const QualityReport between = measure_quality(mesh);
    CHECK(between.forced_by_cad == 1);
    CHECK(between.min_dihedral_unforced > 40);
}
