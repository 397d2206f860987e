// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/followed_faces.h"

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <cstdint>
#include <utility>

#include "asked_memory.h"
#include "brep/occt_geometry.h"
#include "catch.h"
#include "difference/sample_parts.h"
#include "difference/underlying_geometry.h"

using namespace featuremesh;
using namespace featuremesh::test;

namespace {
struct Bore {
    double x, y, radius;
};

/// A plate with holes through it, as a file tells it: without features.
PartState imported(const std::vector<Bore>& bores, const std::vector<Primitive>& more = {}) {
    std::vector<Primitive> steps{{"Plate", Effect::adds, {box({0, 0, 0}, {60, 40, 10})}, {}}};
    for (const Bore& bore : bores)
        steps.push_back({"Bore", Effect::removes, {cylinder({bore.x, bore.y, -1}, {0, 0, 1}, bore.radius, 12)}, {}});
    steps.insert(steps.end(), more.begin(), more.end());
    PartState state = part({{"Import", Effect::adds, {evaluate(steps)}, {}}});
    state.tree.features[0].role = Role::base;
    state.tree.features[0].volume_source = "shape";
    return state;
}

/// The same solid with its round faces, or with all of one kind and direction, the other way round, as another program
/// may list them.
PartState in_another_order(PartState state, bool only_round) {
    std::vector<TopoDS_Face> faces;
    for (std::size_t f = 0; f < state.brep.face_count(); ++f) faces.push_back(state.brep.face(FaceId(f)));
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = faces.size() - 1; j > i; --j) {
            const UnderlyingSurface a = underlying_of(faces[i]), b = underlying_of(faces[j]);
            if (only_round && a.kind == SurfaceKind::plane) continue;
            if (a.kind != b.kind || !a.position.Direction().IsEqual(b.position.Direction(), 1e-9)) continue;
            std::swap(faces[i], faces[j]);
            break;
        }
    BRep_Builder builder;
    TopoDS_Shell shell;
    TopoDS_Solid solid;
    builder.MakeShell(shell);
    for (const TopoDS_Face& face : faces) builder.Add(shell, face);
    shell.Closed(true);
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    state.tree.features[0].volumes[0].shape = state.tree.final_shape = solid;
    return {state.tree, Brep(solid), CellModel{}};
}

std::vector<FaceId> walls_of(const PartState& state) {
    std::vector<FaceId> walls;
    for (std::size_t f = 0; f < state.brep.face_count(); ++f)
        if (underlying_of(state.brep.face(FaceId(f))).kind == SurfaceKind::cylinder) walls.push_back(FaceId(f));
    return walls;
}

/// Radii of what the one hole of an import became.
std::vector<double> radii_of_followed(const std::vector<Bore>& olds, const std::vector<Bore>& news,
                                      const std::vector<Primitive>& more = {}) {
    const PartState was = imported(olds), is = imported(news, more);
    const std::vector<FollowedFace> followed = follow_faces(was, {}, is, {});
    std::vector<double> radii;
    for (const FaceId f : followed[walls_of(was).at(0).index()].new_faces)
        radii.push_back(underlying_of(is.brep.face(f)).radius);
    return radii;
}
using Radii = std::vector<double>;
}  // namespace

TEST_CASE("a hole of an import is followed to one as large or where it was") {
    CHECK(radii_of_followed({{20, 20, 6}}, {{22, 20, 6}}) == Radii{6});
    CHECK(radii_of_followed({{20, 20, 6}}, {{22, 20, 5}}) == Radii{5});
    CHECK(radii_of_followed({{20, 20, 6}}, {{45, 20, 6}}) == Radii{6});
    CHECK(radii_of_followed({{20, 20, 6}}, {{45, 20, 4}}) == Radii{});
    CHECK(radii_of_followed({{20, 20, 6}}, {{45, 20, 4}, {50, 10, 3}}) == Radii{});
}

TEST_CASE("a hole of an import is not followed to two") {
    CHECK(radii_of_followed({{20, 20, 6}}, {{22, 20, 6}, {50, 10, 3}}) == Radii{6});
    CHECK(radii_of_followed({{20, 20, 6}}, {{20.5, 20, 6}, {45, 10, 6}}) == Radii{6});
    CHECK(radii_of_followed({{20, 20, 6}}, {{40, 20, 6}, {50, 10, 6}}) == Radii{});
}

TEST_CASE("a hole of an import that a slot splits is followed to its pieces alone") {
    const Primitive slot{"Slot", Effect::removes, {box({10, 19.5, -1}, {21, 1, 12})}, {}};
    CHECK(radii_of_followed({{20, 20, 6}}, {{20.5, 20, 6}}, {slot}) == Radii{6, 6});
    CHECK(radii_of_followed({{20, 20, 6}}, {{20.5, 20, 6}, {50, 10, 3}}, {slot}) == Radii{6, 6});
}

TEST_CASE("a file that lists the faces of an import in another order") {
    for (const auto& [first, only_round] : {std::pair(0.0, true), {0.0, false}, {1.0, true}, {1.0, false}}) {
        const PartState was = imported({{20, 20, 6}, {40, 20, 6}}),
                        is = in_another_order(imported({{20 + first, 20, 6}, {41, 20, 6}}), only_round);
        const std::vector<FollowedFace> followed = follow_faces(was, {}, is, {});
        const std::vector<FaceId> walls = walls_of(was);
        REQUIRE(walls.size() == 2);
        for (const FaceId wall : walls) {
            const std::vector<FaceId>& now = followed[wall.index()].new_faces;
            REQUIRE(now.size() == 1);
            const double x = underlying_of(was.brep.face(wall)).position.Location().X();
            CHECK(underlying_of(is.brep.face(now[0])).position.Location().X() == Approx(x > 30 ? 41 : x + first));
        }
    }
}

namespace {
SketchElement circle(int id, const Vec3& centre, double radius) {
    return {id, {centre + Vec3{radius, 0, 0}, centre - Vec3{radius, 0, 0}, centre + Vec3{radius, 0, 0}}, centre};
}

/// A plate with a feature that drills at the two circles of a sketch, and a pattern along the sketch's own axis.
PartState drilled(double radius) {
    const auto bores = [&](double y) {
        return evaluate({{"One", Effect::adds, {cylinder({20, y, -1}, {0, 0, 1}, radius, 12)}, {}},
                         {"Other", Effect::adds, {cylinder({40, y, -1}, {0, 0, 1}, radius, 12)}, {}}});
    };
    PartState state = part({{"Plate", Effect::adds, {box({0, 0, 0}, {60, 60, 10})}, {}},
                            {"Holes", Effect::removes, {bores(15)}, {}},
                            {"Pattern", Effect::removes, {bores(45)}, {}}});
    std::vector<Feature>& features = state.tree.features;
    Feature sketch;
    sketch.name = "Sketch";
    sketch.role = Role::reference;
    features[1].at_centres = true;
    features[2].role = Role::pattern;
    features[2].volumes[0].instance = 1;
    features[2].volumes[0].motion = shift({0, 30, 0});
    for (const std::size_t f : {1, 2}) features[f].depends_on.push_back(FeatureId(3));
    features[2].depends_on.push_back(FeatureId(1));
    features.push_back(sketch);
    return state;
}
}  // namespace

TEST_CASE("holes are known by the centres of circles that are by chance as large") {
    for (const double of_circles : {4.0, 5.0, 6.0}) {
        const SketchElements elements{
            {"Sketch", {circle(1, {20, 15, 0}, of_circles), circle(2, {40, 15, 0}, of_circles)}}};
        const PartState was = drilled(4), is = drilled(5);
        const std::vector<FollowedFace> followed = follow_faces(was, elements, is, elements);
        REQUIRE(walls_of(was).size() == 4);
        for (const FaceId wall : walls_of(was)) {
            const std::vector<FaceId>& now = followed[wall.index()].new_faces;
            REQUIRE(now.size() == 1);
            const gp_Pnt there = underlying_of(was.brep.face(wall)).position.Location(),
                         here = underlying_of(is.brep.face(now[0])).position.Location();
            CHECK(std::abs(there.X() - here.X()) < 1e-9);
            CHECK(std::abs(there.Y() - here.Y()) < 1e-9);
        }
    }
}

TEST_CASE("the first hole of a pattern is no other one where the others are told apart no more") {
    const auto holes = [](const std::vector<double>& places, const char* source) {
        std::vector<TopoDS_Shape> bores;
        for (const double x : places) bores.push_back(cylinder({x, 10, -1}, {0, 0, 1}, 3, 12));
        PartState state = part(
            {{"Plate", Effect::adds, {box({0, 0, 0}, {60, 20, 10})}, {}}, {"Pattern", Effect::removes, bores, {}}});
        state.tree.features[1].role = Role::pattern;
        state.tree.features[1].volume_source = source;
        return state;
    };
    const PartState was = holes({10, 30}, "instances"),
                    is = holes({30}, "before and after");  // without what it repeats
    const std::vector<FollowedFace> followed = follow_faces(was, {}, is, {});
    REQUIRE(walls_of(was).size() == 2);
    for (const FaceId wall : walls_of(was)) {
        const bool is_first = underlying_of(was.brep.face(wall)).position.Location().X() < 20;
        CHECK(followed[wall.index()].new_faces == (is_first ? std::vector<FaceId>{} : walls_of(is)));
    }
}

TEST_CASE("faces that no element of the sketch made are not told by the kernel's order") {
    const SketchElements elements{{"Sketch", {circle(1, {20, 20, 0}, 6)}}};
    const auto swept = [](PartState state) {
        Feature sketch;
        sketch.name = "Sketch";
        sketch.role = Role::reference;
        state.tree.features[0].role = Role::pattern;
        state.tree.features[0].depends_on.push_back(FeatureId(1));
        state.tree.features.push_back(sketch);
        sketch.name = "Original";
        sketch.depends_on.push_back(FeatureId(1));
        state.tree.features[0].depends_on.push_back(FeatureId(2));
        state.tree.features.push_back(sketch);
        return state;
    };
    const PartState was = swept(imported({{20, 20, 6}})), is = swept(in_another_order(imported({{20, 20, 6}}), false));
    const std::vector<FollowedFace> followed = follow_faces(was, elements, is, elements);
    for (std::size_t f = 0; f < was.brep.face_count(); ++f) {
        REQUIRE(followed[f].new_faces.size() == 1);
        CHECK(box_of(is.brep.face(followed[f].new_faces[0])).is_close_to(box_of(was.brep.face(FaceId(f))), 1e-9));
    }
}

namespace {
/// Two walls on a floor, both pierced by one square hole, which is made from `begin` to `end` and is `width` wide.
PartState pierced(double begin, double end, double width) {
    return part(
        {{"Holder", Effect::adds, {box({0, 0, 0}, {50, 20, 30})}, {}},
         {"Slot", Effect::removes, {box({10, -1, 10}, {30, 22, 21})}, {}},
         {"Hole", Effect::removes, {box({begin, 10 - width / 2, 20 - width / 2}, {end - begin, width, width})}, {}}});
}

/// A bar with two slots across it, the whole at `x`; `length` of the bar.
PartState slotted(double x, double length) {
    return part({{"Bar", Effect::adds, {box({x, 0, 0}, {length, 10, 10})}, {}},
                 {"Slots", Effect::removes, {box({x + 10, -1, 5}, {2, 12, 6}), box({x + 22, -1, 5}, {2, 12, 6})}, {}}});
}

/// Every face that is all above a height is followed to one alone, the middle of which is `by` away, give and take.
void check_moved(const PartState& was, const PartState& is, const Vec3& by, double give, double above = -1) {
    const std::vector<FollowedFace> followed = follow_faces(was, {}, is, {});
    for (std::size_t f = 0; f < was.brep.face_count(); ++f) {
        if (box_of(was.brep.face(FaceId(f))).low.z < above) continue;
        REQUIRE(followed[f].new_faces.size() == 1);
        const Vec3 there = box_of(is.brep.face(followed[f].new_faces[0])).center();
        CHECK(distance(there, box_of(was.brep.face(FaceId(f))).center() + by) <= give);
    }
}
}  // namespace

TEST_CASE("what a longer hole makes of walls that it crosses stays with its wall") {
    check_moved(pierced(-1000, 3000, 6), pierced(-50, 100, 6.2), {}, 0.2);
    check_moved(pierced(-5, 55, 6), pierced(-5, 295, 6.2), {}, 0.2);
    check_moved(pierced(-5, 55, 6), pierced(-45, 55, 6.2), {}, 0.2);
}

TEST_CASE("pieces of a face go with it where it moves, onto others, too") {
    check_moved(slotted(0, 34), slotted(13, 34), {13, 0, 0}, 1e-6, 9);
    check_moved(slotted(0, 34), slotted(5, 34), {5, 0, 0}, 1e-6, 9);
    check_moved(slotted(0, 34), slotted(0, 36), {}, 2.1, 9);
}

TEST_CASE("of the two pieces beside a slot that moves a little each stays itself") {
    const auto slotted = [](double x) {
        return part({{"Plate", Effect::adds, {box({0, 0, 0}, {60, 40, 10})}, {}},
                     {"Slot", Effect::removes, {box({x, -1, 5}, {1, 42, 10})}, {}}});
    };
    const PartState was = slotted(20), is = slotted(17);
    const auto is_left_on_top = [](const Brep& brep, FaceId face) {
        const Box& box = brep.box_of(face);
        return box.low.z > 9 && box.high.x < 30;
    };
    const std::vector<FollowedFace> followed = follow_faces(was, {}, is, {});
    std::size_t found = 0;
    for (const FollowedFace& face : followed) {
        if (was.brep.box_of(face.old_face).low.z < 9) continue;
        ++found;
        REQUIRE(face.new_faces.size() == 1);
        CHECK(is_left_on_top(is.brep, face.new_faces[0]) == is_left_on_top(was.brep, face.old_face));
    }
    CHECK(found == 2);
}

TEST_CASE("of two bores of one feature the one that stays tells which the other one is, but not where it turned") {
    const auto bored = [](const TopoDS_Shape& second) {
        TopoDS_Compound both;
        BRep_Builder().MakeCompound(both);
        BRep_Builder().Add(both, cylinder({20, 20, -1}, {0, 0, 1}, 6, 12));
        BRep_Builder().Add(both, second);
        return part(
            {{"Plate", Effect::adds, {box({0, 0, 0}, {60, 40, 10})}, {}}, {"Bores", Effect::removes, {both}, {}}});
    };
    const auto radii_of = [&](const TopoDS_Shape& now) {
        const PartState was = bored(cylinder({40, 20, -1}, {0, 0, 1}, 4, 12)), is = bored(now);
        Radii radii;
        for (const FollowedFace& face : follow_faces(was, {}, is, {})) {
            const UnderlyingSurface wall = underlying_of(was.brep.face(face.old_face));
            if (wall.kind != SurfaceKind::cylinder || wall.radius > 5) continue;
            for (const FaceId f : face.new_faces) radii.push_back(underlying_of(is.brep.face(f)).radius);
        }
        return radii;
    };
    CHECK(radii_of(cylinder({52, 8, -1}, {0, 0, 1}, 3, 12)) == Radii{3});
    CHECK(radii_of(cylinder({40, -1, 5}, {0, 1, 0}, 3, 42)) == Radii{});
}

TEST_CASE("the kernel may list the faces of a feature in another order, too") {
    const auto made = [](PartState state) {
        state.tree.features[0].role = Role::additive;
        return state;
    };
    const PartState was = made(imported({{20, 20, 6}, {40, 20, 6}})),
                    is = made(in_another_order(imported({{20, 20, 6}, {41, 20, 6}}), true));
    const std::vector<FollowedFace> followed = follow_faces(was, {}, is, {});
    for (const FaceId wall : walls_of(was)) {
        const std::vector<FaceId>& now = followed[wall.index()].new_faces;
        REQUIRE(now.size() == 1);
        const double x = underlying_of(was.brep.face(wall)).position.Location().X();
        CHECK(underlying_of(is.brep.face(now[0])).position.Location().X() == Approx(x > 30 ? 41 : 20));
    }
}

TEST_CASE("what was on a solid that is gone does not come to one that it overlapped, flush with it") {
    const auto file = [](bool has_second) {
        TopoDS_Compound all;
        BRep_Builder().MakeCompound(all);
        BRep_Builder().Add(all, box({0, 0, 0}, {20, 10, 5}));
        if (has_second) BRep_Builder().Add(all, box({5, 3, -4}, {25, 4, 9}));
        PartState state = part({{"Import", Effect::adds, {all}, {}}});
        state.tree.features[0].role = Role::base;
        return state;
    };
    const PartState was = file(true), is = file(false);
    for (const FollowedFace& face : follow_faces(was, {}, is, {})) {
        const bool is_of_first = was.brep.solids_beside(face.old_face)[0] == SolidId(0);
        INFO("Face" << face.old_face.index() + 1);
        CHECK(face.new_faces.size() == (is_of_first ? 1 : 0));
    }
}

TEST_CASE("the faces of many solids of a file are followed where all grew, and not each beside each") {
    const auto blocks = [](int count, double height) {
        TopoDS_Compound all;
        BRep_Builder builder;
        builder.MakeCompound(all);
        for (int i = 0; i < count; ++i) builder.Add(all, box({10.0 * i, 0, 0}, {4, 4, height}));
        PartState state = part({{"Import", Effect::adds, {all}, {}}});
        state.tree.features[0].role = Role::base;
        return state;
    };
    const auto work_for = [&](int count) {
        const PartState was = blocks(count, 4), is = blocks(count, 5);
        std::vector<FollowedFace> followed;
        const std::uint64_t work = blocks_asked_for_by([&] { followed = follow_faces(was, {}, is, {}); });
        for (const FollowedFace& face : followed) CHECK(face.new_faces == std::vector<FaceId>{face.old_face});
        return work;
    };
    const std::uint64_t of_few = work_for(100);
    CHECK(work_for(400) < 8 * of_few);  // 4 times as many solids
}
