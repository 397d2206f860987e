// SPDX-License-Identifier: GPL-3.0-or-later
// They need the program; `./featuremesh test` installs it.
#include "volume/recovery/tetgen.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "catch.h"
#include "volume/filled_parts.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A block with a bore of so many flat sides, as an STL file has bores.
TopoDS_Shape block_with_polygonal_bore(int sides) {
    BRepBuilderAPI_MakePolygon outline;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        outline.Add(gp_Pnt(15 + 8 * std::cos(angle), 15 + 8 * std::sin(angle), -1));
    }
    outline.Close();
    const TopoDS_Shape bore =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 40)).Shape();
    return BRepAlgoAPI_Cut(box_part({0, 0, 0}, {30, 30, 30}), bore).Shape();
}

class WithoutPath {
  public:
    WithoutPath() { setenv("PATH", "/nowhere:", 1); }
    ~WithoutPath() { setenv("PATH", path_.c_str(), 1); }

  private:
    const std::string path_ = std::getenv("PATH");
};

/// A prism over a triangle, its top turned by 30 degrees, that no tets of its corners fill (E. Schoenhardt 1928).
Cavity twisted_prism() {
    Cavity cavity;
    for (const double turn : {0.0, std::numbers::pi / 6})
        for (int i = 0; i < 3; ++i) {
            const double angle = turn + 2 * std::numbers::pi * i / 3;
            cavity.points.push_back({std::cos(angle), std::sin(angle), turn > 0 ? 1.0 : 0.0});
        }
    cavity.facets = {{{0, 2, 1}, {0, -1}}, {{3, 4, 5}, {0, -1}}};
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        cavity.facets.push_back({{i, next, next + 3}, {0, -1}});
        cavity.facets.push_back({{i, next + 3, i + 3}, {0, -1}});
    }
    return cavity;
}

}  // namespace

TEST_CASE("TetGen meets needles by the hundred, with few points of its own") {
    const Part part = prepare(block_with_polygonal_bore(240), 10);
    const Cavity cavity = find_cavity(part.surface, part.brep.solids_beside_faces());
    RunContext context;
    const std::vector<Vec3> seeds{{3, 3, 15}, {27, 27, 15}};
    const auto fill = recover_by_tetgen(cavity, seeds, context);
    REQUIRE(fill.has_value());
    CHECK(fill->is_complete());
    CHECK(std::equal(cavity.points.begin(), cavity.points.end(), fill->points.begin()));
    for (const Vec3& seed : seeds)
        CHECK(std::find(fill->points.begin(), fill->points.end(), seed) != fill->points.end());
    CHECK(fill->relocated->size() < 100);
    CHECK(volume_of(*fill, 0) == Approx(part.brep.volume()).epsilon(1e-9));
    const auto again = recover_by_tetgen(cavity, seeds, context);
    CHECK(again->triangulation.tets == fill->triangulation.tets);
    CHECK(again->points == fill->points);
}

TEST_CASE("where very many triangles are missing TetGen is asked, and the part is meshed without it, too") {
    const Part part = prepare(comb_part(60, 0.248), 2);
    const VolumeResult with = fill(part), threaded = fill(part, 2);
    CHECK(with.report.recovered_triangles > 1000);
    CHECK(findings(part.brep, with.mesh) == "");
    CHECK(are_same_bytes(with.mesh, threaded.mesh));
    const WithoutPath without_program;
    const VolumeResult without = fill(part);
    CHECK(findings(part.brep, without.mesh) == "");
    CHECK_FALSE(are_same_bytes(with.mesh, without.mesh));
}

TEST_CASE("TetGen adds a point where no tets of the corners alone fill a space") {
    const Cavity cavity = twisted_prism();
    RunContext context;
    const auto fill = recover_by_tetgen(cavity, {}, context);
    REQUIRE(fill.has_value());
    CHECK(fill->relocated->size() == 1);
    CHECK(fill->is_complete());
}

TEST_CASE("without the program, and where facets cross, there are no tets of TetGen") {
    RunContext context;
    Cavity crossing = twisted_prism();
    crossing.points.push_back({0.1, 0.1, -1});
    crossing.points.push_back({0.2, 0.1, 2});
    crossing.points.push_back({0.1, 0.2, 2});
    crossing.facets.push_back({{6, 7, 8}, {0, 0}});
    CHECK_FALSE(recover_by_tetgen(crossing, {}, context).has_value());

    const WithoutPath without_program;
    CHECK_FALSE(recover_by_tetgen(twisted_prism(), {}, context).has_value());
}
