// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepPrimAPI_MakeSphere.hxx>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// The triangles and segments outside a ball, with the nodes they use.
Mesh outside_ball(const Mesh& mesh, const Vec3& centre, double radius) {
    Mesh kept;
    std::vector<NodeId> new_id(mesh.node_count());
    const auto is_out = [&](NodeId n) { return distance(mesh.point(n), centre) > radius; };
    const auto carry = [&](NodeId n) {
        if (new_id[n.index()].is_valid()) return new_id[n.index()];
        const NodeId id(kept.node_count());
        kept.points.push_back(mesh.point(n));
        kept.entities.push_back(mesh.entities[n.index()]);
        kept.parameters.push_back(mesh.parameters[n.index()]);
        kept.node_numbers.push_back(mesh.node_numbers[n.index()]);
        return new_id[n.index()] = id;
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        if (!is_out(a) || !is_out(b) || !is_out(c)) continue;
        kept.triangles.push_back({carry(a), carry(b), carry(c)});
        kept.triangle_faces.push_back(mesh.triangle_faces[t]);
        kept.triangle_numbers.push_back(mesh.triangle_numbers[t]);
    }
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        const auto [a, b] = mesh.segments[s];
        if (!is_out(a) || !is_out(b) || !new_id[a.index()].is_valid() || !new_id[b.index()].is_valid()) continue;
        kept.segments.push_back({new_id[a.index()], new_id[b.index()]});
        kept.segment_edges.push_back(mesh.segment_edges[s]);
        kept.segment_numbers.push_back(mesh.segment_numbers[s]);
    }
    kept.next_node_number = mesh.next_node_number;
    kept.next_element_number = mesh.next_element_number;
    return kept;
}

/// Whether `list` begins with `front`, bit for bit.
template <class T>
bool begins_with(const std::vector<T>& list, const std::vector<T>& front) {
    return list.size() >= front.size() && std::equal(front.begin(), front.end(), list.begin());
}

void check_kept(const Mesh& mesh, const Mesh& kept) {
    CHECK(begins_with(mesh.points, kept.points));
    CHECK(begins_with(mesh.entities, kept.entities));
    CHECK(begins_with(mesh.parameters, kept.parameters));
    CHECK(begins_with(mesh.node_numbers, kept.node_numbers));
    CHECK(begins_with(mesh.segments, kept.segments));
    CHECK(begins_with(mesh.triangles, kept.triangles));
    CHECK(begins_with(mesh.triangle_faces, kept.triangle_faces));
    CHECK(begins_with(mesh.triangle_numbers, kept.triangle_numbers));
}

}  // namespace

TEST_CASE("holes cut into a surface mesh are filled and the rest stays bit for bit") {
    std::mt19937 random(20240607);
    for (const NamedShape& s : named_shapes()) {
        const Brep brep(s.shape);
        const Mesh mesh = mesh_surface(brep, s.size).mesh;
        for (int round = 0; round < 6; ++round) {
            const Vec3 centre = mesh.points[random() % mesh.node_count()];
            const double radius = s.size * (1 + round);
            INFO(s.name << " radius " << radius << " at " << centre.x << " " << centre.y << " " << centre.z);
            const Mesh kept = outside_ball(mesh, centre, radius);
            const SurfaceResult again = mesh_surface(brep, s.size, kept);
            check_kept(again.mesh, kept);
            const auto broken = surface_findings(brep, again.mesh);
            INFO((broken.empty() ? std::string() : broken.front()));
            CHECK(broken.empty());
            CHECK(euler_characteristic(again.mesh) == s.euler);
            CHECK(smallest_angle(again.mesh) > 20);
            CHECK(again.report.new_triangles + kept.triangles.size() == again.mesh.triangles.size());
        }
    }
}

TEST_CASE("a finer surface beside triangles kept at a pole does not reach into them") {
    const double size = GENERATE(4.0, 6.0), finer = GENERATE(0.45, 0.55);
    const Brep brep(BRepPrimAPI_MakeSphere(20).Shape());
    const Mesh mesh = mesh_surface(brep, size).mesh;
    for (int way = 0; way < 12; ++way) {
        const double turn = way * std::numbers::pi / 6 + 0.1, reach = 2 * size, angle = 1.02 * reach / 20;
        const Vec3 centre{20 * std::sin(angle) * std::cos(turn), 20 * std::sin(angle) * std::sin(turn),
                          20 * std::cos(angle)};
        INFO("size " << size << ", then " << finer << " of it, way " << way);
        const Mesh kept = outside_ball(mesh, centre, reach);
        const SurfaceResult again = mesh_surface(brep, finer * size, kept);
        check_kept(again.mesh, kept);
        CHECK(surface_findings(brep, again.mesh) == std::vector<std::string>{});
        CHECK(smallest_angle(again.mesh) > 20);
    }
}

TEST_CASE("a complete surface mesh is given back as it is") {
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        const Mesh mesh = mesh_surface(brep, s.size).mesh;
        const SurfaceResult again = mesh_surface(brep, s.size, mesh);
        check_kept(again.mesh, mesh);
        CHECK(again.report.new_triangles == 0);
        CHECK(again.report.new_nodes == 0);
        CHECK(again.mesh.segments.size() == mesh.segments.size());
    }
}

TEST_CASE("kept nodes without triangles become nodes of the filling") {
    const NamedShape s = named_shapes().front();
    const Brep brep(s.shape);
    const Mesh mesh = mesh_surface(brep, s.size).mesh;
    Mesh kept;
    for (std::size_t n = 0; n < mesh.node_count(); n += 7) {
        kept.points.push_back(mesh.points[n]);
        kept.entities.push_back(mesh.entities[n]);
        kept.parameters.push_back(mesh.parameters[n]);
        kept.node_numbers.push_back(mesh.node_numbers[n]);
    }
    kept.next_node_number = mesh.next_node_number;
    const Mesh again = mesh_surface(brep, s.size, kept).mesh;
    check_kept(again, kept);
    CHECK(surface_findings(brep, again).empty());
    std::vector<char> used(again.node_count(), 0);
    for (const auto& t : again.triangles)
        for (const NodeId n : t) used[n.index()] = 1;
    CHECK(std::count(used.begin(), used.end(), 1) == static_cast<std::ptrdiff_t>(again.node_count()));
}
