// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/relocate_points.h"

#include <algorithm>
#include <array>

#include "catch.h"
#include "volume/filled_parts.h"
#include "volume/recovery/polygon_cut.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

void check_positive(const CavityFill& fill) {
    for (const auto& c : fill.triangulation.tets)
        CHECK(signed_volume(fill.points[c[0]], fill.points[c[1]], fill.points[c[2]], fill.points[c[3]]) > 0);
}

/// Relocates what the constraints add to the cavity of a part and checks that its triangles are back as they were.
void check_relocated(const TopoDS_Shape& shape, double size) {
    SizingOptions options;
    options.size = options.min_size = size;  // or the bottom of a slot would get shorter pieces
    const Part part = prepare(shape, options);
    const Cavity cavity = find_cavity(part.surface, part.brep.solids_beside_faces());
    const ConstrainedTriangulation recovered = constrained_delaunay(cavity, {}, 0);
    REQUIRE(!recovered.split.added.empty());
    RunContext context;
    const auto fill = relocate_points(cavity, recovered, {}, context);
    REQUIRE(fill.has_value());
    CHECK(fill->is_complete());
    CHECK(std::equal(cavity.points.begin(), cavity.points.end(), fill->points.begin()));
    check_positive(*fill);
    for (std::size_t s = 0; s < part.brep.solid_count(); ++s)
        CHECK(volume_of(*fill, static_cast<int>(s)) == Approx(part.brep.volume_of(SolidId(s))).epsilon(1e-9));
}

}  // namespace

TEST_CASE("added points leave the boundary as it was") {
    check_relocated(slotted_block(), 2.0);
    check_relocated(turned(slotted_block(), 0.7, {3, 4, 5}), 2.0);
    check_relocated(box_part({0, 0, 0}, {40, 40, 0.2}), 5.0);
}

TEST_CASE("a point on an edge goes into every region round it") {
    // Two tets' worth of space on either side of the inner triangle 0 1 2, whose edge 0 1 is cut by the added point.
    Cavity cavity;
    cavity.points = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 0.5, 2}, {1, 0.5, -2}};
    cavity.facets = {{{0, 1, 2}, {1, 0}},  {{0, 1, 3}, {0, -1}}, {{1, 2, 3}, {0, -1}}, {{2, 0, 3}, {0, -1}},
                     {{1, 0, 4}, {1, -1}}, {{2, 1, 4}, {1, -1}}, {{0, 2, 4}, {1, -1}}};
    ConstrainedTriangulation recovered;
    recovered.split.added = {{{1, 0, 0}, {0, 1}, -1}};
    recovered.split.pieces = {{{0, 5, 2}, 0}, {{5, 1, 2}, 0}, {{0, 5, 3}, 1},
                              {{5, 1, 3}, 1}, {{5, 0, 4}, 4}, {{1, 5, 4}, 4}};
    recovered.triangulation.tets = {{0, 5, 2, 3}, {5, 1, 2, 3}, {0, 2, 5, 4}, {5, 2, 1, 4}};
    recovered.triangulation.neighbours = {{1, -1, -1, 2}, {-1, 0, -1, 3}, {3, -1, -1, 0}, {-1, -1, 2, 1}};
    RunContext context;
    const auto fill = relocate_points(cavity, recovered, {}, context);
    REQUIRE(fill.has_value());
    CHECK(fill->is_complete());
    CHECK(fill->points.size() == 7);
    check_positive(*fill);
    for (const int region : {0, 1}) CHECK(volume_of(*fill, region) == Approx(4.0 / 3).epsilon(1e-12));
}

TEST_CASE("a polygon is cut into triangles that turn as it does") {
    const std::vector<Vec3> points{{0, 0, 1}, {2, 0, 1}, {4, 0, 1}, {4, 3, 1}, {2, 0.5, 1}, {0, 3, 1}};
    std::vector<std::array<int, 3>> triangles;
    REQUIRE(cut_polygon(points, {0, 1, 2, 3, 4, 5}, {0, 0, 1}, triangles));
    REQUIRE(triangles.size() == 4);
    double area = 0;
    for (const auto& t : triangles) {
        const double part = 0.5 * cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]).z;
        CHECK(part > 0);
        area += part;
    }
    CHECK(area == Approx(7.0));
    CHECK_FALSE(cut_polygon(points, {0, 1, 2}, {0, 0, 1}, triangles));
}
