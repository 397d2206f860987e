// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepPrimAPI_MakeBox.hxx>
#include <cmath>

#include "../mesh/box_mesh.h"
#include "catch.h"
#include "sizing/size_conformity.h"

using namespace featuremesh;

namespace {

SizeConformity conformity_of(const Mesh& mesh, double size) {
    RunContext context;
    SizingOptions options;
    options.size = size;
    return measure_size_conformity(mesh, make_sizing(Brep(BRepPrimAPI_MakeBox(1, 1, 1).Shape()), options, {}, context));
}

}  // namespace

TEST_CASE("edge lengths of Kuhn's cubes over the wanted length") {
    // of six sides of each tet three are 1, two are sqrt(2) and one is sqrt(3) times the cube's side
    const Mesh mesh = box_mesh(5);
    const SizeConformity conformity = conformity_of(mesh, 0.2 * 1.1);
    CHECK(conformity.mean == Approx((3 + 2 * std::sqrt(2.0) + std::sqrt(3.0)) / 6 / 1.1));
    CHECK(conformity.share_within == Approx(5.0 / 6));
    const auto sides = static_cast<std::int64_t>(mesh.tets.size());
    CHECK(conformity.histogram[9] == 3 * sides);
    CHECK(conformity.histogram[12] == 2 * sides);
    CHECK(conformity.histogram[15] == sides);
}

TEST_CASE("a mesh half as coarse as wanted obeys nowhere") {
    CHECK(conformity_of(box_mesh(4), 0.5).share_within == Approx(3.0 / 6));
    CHECK(conformity_of(box_mesh(4), 0.9).share_within == 0);
    CHECK(conformity_of(box_mesh(1), 0.25).histogram[19] == 36);
}

TEST_CASE("no more tets than its limit are looked at") {
    std::int64_t count = 0;
    for (const std::int64_t n : conformity_of(box_mesh(12), 0.1).histogram) count += n;
    CHECK(count <= 6 * 900);
    CHECK(count > 6 * 430);
}
