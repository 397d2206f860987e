// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "core/errors.h"
#include "part_documents.h"
#include "part_meshes.h"

using namespace featuremesh;

TEST_CASE("too many tets are refused with their number") {
    for (const double size : {1e-5, 1e-200, 1e-320})
        CHECK_THROWS_WITH(meshed(plate_with_hole(15), options_of(size)), Catch::Matchers::Contains("0 million"));
    CHECK_THROWS_WITH(meshed(plate_with_hole(15), options_of(0.01)), Catch::Matchers::Contains("million"));
    CHECK_THROWS_AS(meshed(plate_with_hole(15), options_of(0)), InputError);
    CHECK_THROWS_AS(meshed(plate_with_hole(15), options_of(-1)), InputError);
    CHECK_THROWS_AS(meshed(plate_with_hole(15), options_of(1e4)), InputError);
}

TEST_CASE("of a local size at several places all are told to ask for too many tets") {
    MeshOptions options = options_of(3);
    options.most_tets = 1e4;
    for (int face = 0; face < 4; ++face) options.sizing.local.push_back({entity_of(FaceId(face)), 0.5});
    options.sizing.local.push_back({entity_of(FaceId(4)), 2.5});
    CHECK_THROWS_WITH(meshed(plate_with_hole(15), options),
                      Catch::Matchers::Contains("The refinement at Face1, Face2, Face3, Face4 with a size of 0.5 mm"));
}
