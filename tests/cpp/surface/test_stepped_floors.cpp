// SPDX-License-Identifier: GPL-3.0-or-later
// Two holes that meet, with floors far thinner than the elements, the one a little deeper than the other.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "catch.h"
#include "surface/opposite_places.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

constexpr double thin = 0.0004, thick = 0.0094, size = 5;

TopoDS_Shape block() {
    const auto hole = [](double x, double radius, double floor) {
        return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 30, floor), gp::DZ()), radius, 40).Shape();
    };
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(60., 60., 30.).Shape();
    return BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(box, hole(25, 5, thin)).Shape(), hole(29.8, 3.6, thick)).Shape();
}

/// Of the nodes on the strip of the wider hole's wall between the two floors, those that are on no edge of it.
std::ptrdiff_t nodes_inside_strip(const Mesh& mesh) {
    std::ptrdiff_t count = 0;
    for (std::size_t n = 0; n < mesh.node_count(); ++n)
        count += mesh.entities[n].dim == 2 && mesh.points[n].z > 1.01 * thin && mesh.points[n].z < 0.99 * thick;
    return count;
}

}  // namespace

TEST_CASE("a strip of a curved face that is narrower than its arcs are high gets nodes opposite one another") {
    const Brep brep(block());
    const SurfaceResult result = mesh_surface(brep, size, NarrowFaces::opposite_nodes);
    CHECK(surface_findings(brep, result.mesh).empty());
    CHECK(result.report.has_opposite_nodes);
    CHECK(nodes_inside_strip(result.mesh) == 0);
    CHECK(nodes_inside_strip(mesh_surface(brep, size, NarrowFaces::own_chains).mesh) > 0);
}

TEST_CASE("places opposite two floors, the one's border above the other's, are one place") {
    FaceBoundary boundary;
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{10, 0}, Vec2{10, 10}, Vec2{0, 10}}) {
        const int p = int(boundary.points.size());
        boundary.nodes.emplace_back(boundary.points.size());
        boundary.points.push_back(corner);
        boundary.segments.push_back({p, (p + 1) % 4, {}});
    }
    const ChartDomain domain(boundary);
    REQUIRE(domain.is_valid());
    const std::vector<Vec2> places{{5, 5}, {3, 5}, {5, 5 + 1e-5}, {5.1, 5}};
    Seeds seeds;
    put_first(places, std::vector<double>(places.size(), 1.0), boundary, domain, seeds);
    REQUIRE(seeds.fixed_count == 3);
    CHECK(seeds.points[2].x == 5.1);
}
