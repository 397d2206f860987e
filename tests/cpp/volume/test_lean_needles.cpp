// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/lean_needles.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <cmath>
#include <set>

#include "catch.h"
#include "volume/filled_parts.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

std::set<std::pair<NodeId, NodeId>> sides_of_triangles(const Mesh& mesh) {
    std::set<std::pair<NodeId, NodeId>> sides;
    for (const auto& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) sides.insert(std::minmax(t[i], t[(i + 1) % 3]));
    return sides;
}

/// Edges along which all surface nodes within reach, sorted by parameter and number, are not a chain of sides.
std::string broken_chains(const Brep& brep, const Mesh& mesh, double reach) {
    const Projector projector(brep);
    const auto sides = sides_of_triangles(mesh);
    std::string names;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        std::vector<std::pair<double, NodeId>> along;
        for (std::size_t n = 0; n < mesh.node_count(); ++n) {
            if (mesh.entities[n].dim == 3) continue;
            const OnEdge nearest = projector.nearest(EdgeId(e), mesh.points[n]);
            if (nearest.distance < reach) along.emplace_back(std::round(nearest.t * 1e7) * 1e-7, NodeId(n));
        }
        std::sort(along.begin(), along.end());
        for (std::size_t i = 1; i < along.size(); ++i)
            if (!sides.count(std::minmax(along[i - 1].second, along[i].second))) {
                names += name_of(entity_of(EdgeId(e))) + " ";
                break;
            }
    }
    return names;
}

}  // namespace

TEST_CASE("beside a strip of needles the nodes along every edge are a chain, whichever edge they are of") {
    int meshes = 0, whole = 0;  // where leaning the other way would leave no volume, a needle stays as it is
    for (const double width : {1e-4, 2e-4})
        for (const double size : {5.0, 4.0, 3.0, 2.0, 1.5}) {
            INFO(width << " " << size);
            const Part part = prepare(cut_corner(width), size);
            const Mesh mesh = fill(part).mesh;
            CHECK(findings(part.brep, mesh).empty());
            ++meshes, whole += broken_chains(part.brep, mesh, 1e-5 * part.brep.tolerances().diagonal).empty();
        }
    CHECK(2 * whole >= meshes);
}

TEST_CASE("a triangle with other corners than before has another number") {
    const Part part = prepare(cut_corner(1e-4), 3);
    const Mesh mesh = fill(part).mesh;
    std::size_t turned = 0;
    for (std::size_t t = 0; t < part.surface.triangles.size(); ++t) {
        if (mesh.triangles[t] == part.surface.triangles[t]) continue;
        ++turned;
        CHECK(mesh.triangle_numbers[t] != part.surface.triangle_numbers[t]);
    }
    CHECK(turned > 0);
}

TEST_CASE("beside needles no seam is turned") {
    // so nearly of one radius, and on one axis, that the seams end at an edge of 0.0003
    const double radius = 2.4962530422968414, branch = 2.4961641691652887, off = 0.00034305351232783696;
    const TopoDS_Shape tee =
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-15, 0, 0), gp::DX()), radius, 30).Shape(),
                         BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, off, 0), gp::DZ()), branch, 15).Shape())
            .Shape();
    for (const double size : {0.8, 0.877}) {
        INFO(size);
        SizingOptions options;
        options.size = size;
        const Part part = prepare(tee, options);
        CHECK(findings(part.brep, fill(part).mesh).empty());
    }
}

TEST_CASE("where there are no needles nothing is turned") {
    const Part part = prepare(drilled_part(), 3);
    const Mesh before = fill(part).mesh;
    Mesh mesh = before;
    std::vector<TriangleId> triangles;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) triangles.emplace_back(t);
    CHECK(lean_needles(part.brep, Projector(part.brep), triangles, 0, mesh) == 0);
    CHECK(are_same_bytes(mesh, before));
}
