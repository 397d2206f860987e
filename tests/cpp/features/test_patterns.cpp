// SPDX-License-Identifier: GPL-3.0-or-later
// Instances of patterns, by their numbers.
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "catch.h"
#include "documents.h"
#include "features/feature_tree.h"

using namespace featuremesh;
using namespace featuremesh::test;

namespace {
const Feature& named(const FeatureTree& tree, const std::string& name) { return tree[tree.find(name).value()]; }

/// The number of the instance whose first hole, at (5, 5, 0), went to that place.
std::int64_t instance_at(const Feature& pattern, const Vec3& place) {
    const auto found = std::find_if(pattern.volumes.begin(), pattern.volumes.end(), [&](const FeatureVolume& volume) {
        return distance(volume.motion.apply({5, 5, 0}), place) < 1e-9;
    });
    REQUIRE(found != pattern.volumes.end());
    return found->instance;
}
}  // namespace

TEST_CASE("an instance of a row of rows has the same number when the rows become longer") {
    const TopoDS_Shape pad = box(0, 0, 0, 60, 30, 5), hole = cylinder({5, 5, -1}, {0, 0, 1}, 2, 7),
                       first = cut(pad, hole);
    const auto number_at = [&](int in_a_row, const Vec3& place) {
        TopoDS_Shape after = first;
        for (const double y : {5.0, 15.0})
            for (int i = 0; i < in_a_row; ++i) after = cut(after, cylinder({5.0 + 10 * i, y, -1}, {0, 0, 1}, 2, 7));
        DocumentMaker maker;
        maker.add("Sketch", "Sketcher::SketchObject");
        maker.add("Pad", "PartDesign::Pad", {}, pad, pad);
        maker.add("Hole", "PartDesign::Pocket", {{"BaseFeature", "Pad", ""}}, first, hole);
        maker.add("Row", "PartDesign::LinearPattern", {{"Direction", "Sketch", "H_Axis"}}).numbers = {
            {"Length", 10.0 * (in_a_row - 1)}, {"Occurrences", double(in_a_row)}};
        maker.add("Rows", "PartDesign::LinearPattern", {{"Direction", "Sketch", "V_Axis"}}).numbers = {
            {"Length", 10}, {"Occurrences", 2}};
        maker.add("Multi", "PartDesign::MultiTransform",
                  {{"BaseFeature", "Hole", ""},
                   {"Originals", "Hole", ""},
                   {"Transformations", "Row", ""},
                   {"Transformations", "Rows", ""}},
                  after);
        const FeatureTree tree = interpret(maker.done());
        const Feature& multi = named(tree, "Multi");
        REQUIRE(multi.volumes.size() == 2 * std::size_t(in_a_row) - 1);
        return instance_at(multi, place);
    };
    for (const Vec3& place : {Vec3{25, 5, 0}, Vec3{5, 15, 0}, Vec3{25, 15, 0}})
        CHECK(number_at(3, place) == number_at(4, place));
    CHECK(number_at(4, {35, 5, 0}) != number_at(4, {5, 15, 0}));
}

TEST_CASE(
    "an instance of a pattern in two directions with spacings of its own has the same number when rows become longer") {
    const TopoDS_Shape pad = box(0, 0, 0, 80, 40, 5), hole = cylinder({5, 5, -1}, {0, 0, 1}, 2, 7),
                       first = cut(pad, hole);
    const std::vector<double> gaps{12, 20, 9, 14};  // given, the offset, given, the offset of the pattern
    const auto number_at = [&](int in_a_row, bool is_repeated, const Vec3& place) {
        TopoDS_Shape after = first;
        for (const double y : {5.0, 22.0}) {
            double x = 5;
            for (int i = 0; i < in_a_row; ++i) {
                after = cut(after, cylinder({x, y, -1}, {0, 0, 1}, 2, 7));
                x += is_repeated ? (i % 2 == 0 ? 8 : 14) : gaps[std::size_t(i)];
            }
        }
        DocumentMaker maker;
        maker.add("Sketch", "Sketcher::SketchObject");
        maker.add("Pad", "PartDesign::Pad", {}, pad, pad);
        maker.add("Hole", "PartDesign::Pocket", {{"BaseFeature", "Pad", ""}}, first, hole);
        RawRecord& rows = maker.add("Rows", "PartDesign::LinearPattern",
                                    {{"BaseFeature", "Hole", ""},
                                     {"Originals", "Hole", ""},
                                     {"Direction", "Sketch", "H_Axis"},
                                     {"Direction2", "Sketch", "V_Axis"}},
                                    after);
        rows.numbers = {{"Length", 70},      {"Occurrences", double(in_a_row)},
                        {"Offset", 20},      {"Length2", 17},
                        {"Occurrences2", 2}, {"Offset2", 5}};
        rows.texts = {{"Mode", "Spacing"}, {"Mode2", "Extent"}};
        if (is_repeated)
            rows.numbers["SpacingPattern[0]"] = 8, rows.numbers["SpacingPattern[1]"] = 14;
        else
            rows.numbers["Spacings[0]"] = 12, rows.numbers["Spacings[2]"] = 9, rows.numbers["SpacingPattern[0]"] = 1;
        const FeatureTree tree = interpret(maker.done());
        const Feature& pattern = named(tree, "Rows");
        CHECK(pattern.volume_source == "instances");
        REQUIRE(pattern.volumes.size() == 2 * std::size_t(in_a_row) - 1);
        return instance_at(pattern, place);
    };
    for (const Vec3& place : {Vec3{37, 5, 0}, Vec3{5, 22, 0}, Vec3{37, 22, 0}})
        CHECK(number_at(3, false, place) == number_at(4, false, place));
    for (const Vec3& place : {Vec3{27, 5, 0}, Vec3{27, 22, 0}})
        CHECK(number_at(3, true, place) == number_at(4, true, place));
}
