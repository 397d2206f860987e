// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "catch.h"
#include "core/entity_names.h"

using namespace featuremesh;

TEST_CASE("entities are named as FreeCAD does, and found by their names") {
    for (const Entity entity : {Entity{0, 0}, Entity{1, 8}, Entity{2, 11}, Entity{3, 0}})
        CHECK(entity_named(name_of(entity)) == entity);
    CHECK(name_of({2, 11}) == "Face12");
    for (const std::string name : {"", "Face", "Face0", "Face-1", "Face1x", "face1", "Face99999999999", "Wire1", "1"}) {
        INFO(name);
        CHECK_FALSE(entity_named(name).has_value());
    }
}
