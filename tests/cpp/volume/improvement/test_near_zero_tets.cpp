// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <string>

#include "catch.h"
#include "core/errors.h"
#include "core/tolerances.h"
#include "volume/filled_parts.h"
#include "volume/improvement/improved.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

constexpr double least_volume = 1e-3;

std::size_t count_thin(const TetComplex& complex) {
    const Objective objective = objective_for(5, least_volume);
    return static_cast<std::size_t>(std::count_if(complex.tets.begin(), complex.tets.end(), [&](const Tet& tet) {
        return tet[0] >= 0 && objective.flaw(complex, tet) > 1;
    }));
}

Improvement improve_near_zero_tets(TetComplex& complex, std::size_t most_large_cavities) {
    RunContext context;
    const Objective objective = objective_for(5, least_volume);
    LocalMesh mesh(complex);
    return improve(mesh, objective,
                   list_of(edge_ring(mesh, objective), vertex_move(mesh, objective),
                           cone_refill(mesh, objective, {.most_large_cavities = most_large_cavities})),
                   {}, {}, context);
}

}  // namespace

TEST_CASE("thin tets inside get a volume again, and the outside stays") {
    for (const double left : {1e-3, 1e-6, 1e-10}) {
        TetComplex box = box_of_tets(4, 0.1, 5);
        const int vertex = 2 + 5 * 2 + 25 * 2;
        const Tet& tet = box.tets[box.tet_of_vertex[vertex]];
        const auto& face = opposite_face[corner_of(tet, vertex)];
        const Vec3 middle =
            (1.0 / 3) * (box.points[tet[face[0]]] + box.points[tet[face[1]]] + box.points[tet[face[2]]]);
        box.points[vertex] = middle + left * (box.points[vertex] - middle);
        const TetComplex before = box;
        REQUIRE(count_thin(box) > 0);
        improve_near_zero_tets(box, 0);
        CHECK(count_thin(box) == 0);
        CHECK(find_flaws(box).empty());
        CHECK(outside_of(box) == outside_of(before));
        CHECK(are_fixed_kept(before, box));
        CHECK(total_volume(box) == Approx(64));
    }
}

TEST_CASE("large cavities give room where all vertices are fixed, as often as asked for at most") {
    std::size_t with = 0, without = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        TetComplex start = box_of_tets(4, 0.19, seed);
        for (const int v : {2 + 5 * 1 + 25 * 1, 2 + 5 * 2 + 25 * 1, 2 + 5 * 1 + 25 * 2, 2 + 5 * 2 + 25 * 2})
            start.points[v] = start.points[v + 1] - Vec3{1e-3, 0, 0};
        fix_all(start);
        TetComplex box = start;
        improve_near_zero_tets(box, 0);
        without += count_thin(box);
        improve_near_zero_tets(start, 1000);
        CHECK(find_flaws(start).empty());
        with += count_thin(start);
    }
    CHECK(with < without);
}

TEST_CASE("a complex without thin tets is left as it is") {
    TetComplex box = box_of_tets(3, 0.1, 7);
    const TetComplex before = box;
    CHECK(improve_near_zero_tets(box, 1000).changes == 0);
    CHECK(are_same_bytes(box, before));
}

TEST_CASE("no tet of a part with an edge of a hundred-thousandth of it is without volume") {
    const auto [shape, size] = GENERATE(table<TopoDS_Shape, double>({{cut_corner(5e-4), 2},
                                                                     {cut_corner(2e-3), 2},
                                                                     {wall_with_steps(2e-4), 0.75},
                                                                     {wall_with_steps(2e-4), 0.1},
                                                                     {wall_with_steps(6e-5), 0.1}}));
    const Part part = prepare(shape, size);
    const Mesh mesh = fill(part).mesh;
    CHECK(findings(part.brep, mesh).empty());
    double least = 1e300;
    for (const auto& t : mesh.tets)
        least = std::min(least, signed_volume(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]), mesh.point(t[3])));
    CHECK(least > 0.92 * part.brep.tolerances().least_volume());
}

TEST_CASE("a pocket of a few millionths of the part with short sides is filled") {
    const Part part = prepare(engraved_block(24, 0.06, 8e-5), 0.95);
    CHECK(findings(part.brep, fill(part).mesh).empty());
}

TEST_CASE("what cannot be filled is refused with the names of the short edges there") {
    // a corner cut off so little that the triangle it leaves holds no tet
    const double d = 2e-4;
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(30 - d, 20, 10), gp_Pnt(30, 20 - d, 10), gp_Pnt(30, 20, 10 - d), true);
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(outline.Wire()).Face();
    const TopoDS_Shape corner = BRepPrimAPI_MakePrism(face, gp_Vec(d, d, d)).Shape();
    const Part part = prepare(BRepAlgoAPI_Cut(box_part({0, 0, 0}, {30, 20, 10}), corner).Shape(), 0.5);
    try {
        fill(part);
        FAIL("it was filled");
    } catch (const MeshError& error) {
        CHECK(std::string(error.what()).find(" beside Edge") != std::string::npos);
        CHECK(std::string(error.what()).find("0.00028 mm long") != std::string::npos);
    }
}
