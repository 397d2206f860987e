// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/feature_difference.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gp_Ax2.hxx>
#include <map>
#include <set>

#include "asked_memory.h"
#include "brep/occt_geometry.h"
#include "catch.h"
#include "core/errors.h"
#include "difference/face_owners.h"
#include "difference/sample_parts.h"

using namespace featuremesh;
using namespace featuremesh::test;

namespace {
FeatureDifference diff(const PartState& a, const PartState& b, double resolution = 1.0) {
    RunContext context;
    return compare(a, b, resolution, context);
}

const FeatureChange& change_of(const FeatureDifference& d, const std::string& name) {
    for (const FeatureChange& f : d.features)
        if (f.name == name) return f;
    FAIL("no feature " << name);
    return d.features.front();
}

TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
    return compound;
}

int count(const FeatureDifference& d, BoundaryVerdict verdict) {
    return int(
        std::count_if(d.faces.begin(), d.faces.end(), [&](const FaceChange& f) { return f.verdict == verdict; }));
}

/// Of many points of a curved face the largest distance to the changed boundary; 0 for a plane.
double furthest_of_wall(const TopoDS_Face& face, const ChangedBoundary& changed) {
    const BRepAdaptor_Surface wall(face);
    if (wall.GetType() == GeomAbs_Plane) return 0;
    const BRepTopAdaptor_FClass2d trim(face, 1e-9);
    constexpr int columns = 150, rows = 60;
    double furthest = 0;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            const gp_Pnt2d uv(std::lerp(wall.FirstUParameter(), wall.LastUParameter(), (i + 0.5) / columns),
                              std::lerp(wall.FirstVParameter(), wall.LastVParameter(), (j + 0.5) / rows));
            if (trim.Perform(uv) == TopAbs_IN)
                furthest = std::max(furthest, changed.distance(to_vec3(wall.Value(uv.X(), uv.Y())), 10));
        }
    return furthest;
}
}  // namespace

TEST_CASE("equal parts made twice have no difference") {
    const FeatureDifference d = diff(part(bracket({12, 12, 0})), part(bracket({12, 12, 0})));
    CHECK(d.is_empty());
    REQUIRE(d.regions.size() == 1);
    CHECK(d.regions[0].motion.is_identity());
    CHECK(d.regions[0].changed.is_empty());
    CHECK(d.regions[0].features.size() == 10);
    for (std::size_t f = 0; f < d.regions[0].new_face_of.size(); ++f) CHECK(d.regions[0].new_face_of[f] == FaceId(f));
    for (std::size_t e = 0; e < d.regions[0].new_edge_of.size(); ++e) CHECK(d.regions[0].new_edge_of[e] == EdgeId(e));
    for (std::size_t v = 0; v < d.regions[0].new_vertex_of.size(); ++v)
        CHECK(d.regions[0].new_vertex_of[v] == VertexId(v));
}

TEST_CASE("solids that touch have partners of their own") {
    // The edges of either lie on those of the other, and so do their corners.
    const TopoDS_Shape blocks =
        together({box({0, 0, 0}, {10, 10, 5}), box({0, 0, 5}, {10, 10, 5}), box({2, 0, 10}, {6, 10, 5})});
    const PartState one = part({{"Blocks", Effect::adds, {blocks}, {}}});
    const FeatureDifference d = diff(one, one);
    for (std::size_t e = 0; e < d.regions[0].new_edge_of.size(); ++e) CHECK(d.regions[0].new_edge_of[e] == EdgeId(e));
    for (std::size_t v = 0; v < d.regions[0].new_vertex_of.size(); ++v)
        CHECK(d.regions[0].new_vertex_of[v] == VertexId(v));
}

TEST_CASE("a face stays when another solid comes to lie against it") {
    const TopoDS_Shape block = box({0, 0, 0}, {10, 10, 10});
    const auto beside = [&](double from) {
        return part({{"Blocks", Effect::adds, {together({block, box({from, 2, 2}, {20 - from, 6, 6})})}, {}}});
    };
    const PartState apart = beside(12), touching = beside(10);
    for (const auto& [was, is] : {std::pair(&apart, &touching), std::pair(&touching, &apart)}) {
        const FeatureDifference d = diff(*was, *is);
        // All of the block's; of the other solid the far end, and of its sides the length changes.
        CHECK(count(d, BoundaryVerdict::kept) == 7);
        CHECK(count(d, BoundaryVerdict::trimmed_differently) == 4);
        CHECK(count(d, BoundaryVerdict::vanished) == 1);
        CHECK(count(d, BoundaryVerdict::appeared) == 1);
    }
}

TEST_CASE("a moved hole") {
    const FeatureDifference d = diff(part_with_cells(bracket({12, 12, 0})), part_with_cells(bracket({17, 12, 0})));
    CHECK_FALSE(d.is_empty());
    const FeatureChange& hole = change_of(d, "Hole0");
    CHECK(hole.verdict == Verdict::moved);
    CHECK(hole.detail.in_english() == "moved by (5, 0, 0) mm");
    CHECK(hole.old_volume == Approx(M_PI * 16 * 15));
    CHECK(hole.old_faces.size() == 1);
    CHECK(change_of(d, "Plate").verdict == Verdict::interaction_changed);
    CHECK(change_of(d, "Boss").verdict == Verdict::same);
    CHECK(change_of(d, "Hole3").verdict == Verdict::same);
    CHECK(count(d, BoundaryVerdict::trimmed_differently) == 2);
    CHECK(count(d, BoundaryVerdict::vanished) == 1);
    CHECK(count(d, BoundaryVerdict::appeared) == 1);

    const ChangedBoundary& changed = d.regions[0].changed;
    CHECK(changed.distance({8, 12, 7}, 1) < 0.3);   // the old wall
    CHECK(changed.distance({21, 12, 7}, 1) < 0.3);  // the new wall
    CHECK(changed.distance({9, 12, 15}, 1) < 0.3);  // closed
    CHECK(changed.distance({30, 12, 15}, 5) == 5);
    CHECK(changed.distance({12, 12, 7}, 10) == Approx(1).margin(0.3));

    REQUIRE(d.regions.size() == 2);
    CHECK(d.regions[1].motion == shift({5, 0, 0}));
    CHECK(d.regions[1].features == std::vector<std::string>{"Hole0"});
    CHECK(d.regions[1].volumes.empty());
    CHECK(d.regions[1].new_face_of[hole.old_faces[0].index()] == hole.new_faces[0]);
    CHECK(d.regions[1].changed.distance({21, 12, 7}, 3) == 0);  // it carries nothing, so nothing was looked at
}

TEST_CASE("areas of faces that changed are those of the kernel") {
    const auto area = [](const TopoDS_Face& face) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties, 1e-9);
        return properties.Mass();
    };
    const PartState was = part_with_cells(bracket({12, 12, 0})), is = part_with_cells(bracket({17, 12, 0}));
    std::vector<FaceChange> faces = diff(was, is).faces;
    tell_areas(faces, was.brep, is.brep);
    const auto check = [&](const std::optional<double>& told, const Brep& brep, FaceId face) {
        REQUIRE(told.has_value() == face.is_valid());
        if (told) CHECK(*told == Approx(area(brep.face(face))).epsilon(1e-9));
    };
    for (const FaceChange& change : faces) {
        if (change.verdict == BoundaryVerdict::kept) continue;
        check(change.old_area, was.brep, change.old_face);
        check(change.new_area, is.brep, change.new_face);
    }
}

TEST_CASE("one moved hole among 150 features") {
    const auto before = many_features(150);
    auto after = before;
    const auto hole = std::find_if(after.begin(), after.end(), [](const Primitive& f) { return f.name == "Hole1"; });
    hole->instances = {test::moved(hole->instances[0], shift({0.5, 0.2, 0}))};
    const PartState was = part_with_cells(before), is = part_with_cells(after);
    const FeatureDifference d = diff(was, is, 1.5);
    for (const FeatureChange& f : d.features) {
        INFO(f.name);
        CHECK(f.verdict == (f.name == "Hole1"   ? Verdict::moved
                            : f.name == "Plate" ? Verdict::interaction_changed
                                                : Verdict::same));
    }
    CHECK(count(d, BoundaryVerdict::trimmed_differently) == 2);
    CHECK(count(d, BoundaryVerdict::vanished) == 1);
    CHECK(count(d, BoundaryVerdict::appeared) == 1);
}

TEST_CASE("the pieces of a large pattern are not compared each with each") {
    const auto studs = [](int count, double radius) {
        std::vector<TopoDS_Shape> all;
        for (int i = 0; i < count; ++i)
            all.push_back(cylinder({10.0 * (i % 20), 10.0 * (i / 20), 0.1 * i}, {0, 0, 1}, radius, 5));
        PartState state = part({{"Studs", Effect::adds, {together(all)}, {}}});
        state.cells.feature_volumes = {1};
        return state;
    };
    for (const auto& names : names_of_owners(studs(400, 2))) CHECK(names.size() == 1);
    const auto work_for = [&](int count) {
        const PartState was = studs(count, 2), is = studs(count, 2.1);
        return blocks_asked_for_by([&] { CHECK(diff(was, is, 5).features[0].verdict == Verdict::reshaped); });
    };
    const std::uint64_t of_few = work_for(400);
    CHECK(work_for(1600) < 8 * of_few);  // 4 times as many pieces
}

TEST_CASE("faces that cross like a plus are partners") {
    const FeatureDifference d = diff(part({{"A", Effect::adds, {box({0, 10, 0}, {30, 10, 5})}, {}}}),
                                     part({{"A", Effect::adds, {box({10, 0, 0}, {10, 30, 5})}, {}}}));
    CHECK(count(d, BoundaryVerdict::trimmed_differently) == 2);
    CHECK(d.regions[0].changed.distance({15, 15, 5}, 4) > 3);  // both have the middle
    CHECK(d.regions[0].changed.distance({5, 15, 5}, 4) < 0.3);
}

TEST_CASE("what changed between straight edges has few triangles, and ends with it") {
    const auto plate = [](double length) {
        return part({{"Plate", Effect::adds, {box({0, 0, 0}, {length, 40, 10})}, {}},
                     {"Hole", Effect::removes, {cylinder({20, 20, 0}, {0, 0, 1}, 5, 10)}, {}}});
    };
    const ChangedBoundary changed = diff(plate(60), plate(63), 0.1).regions[0].changed;
    CHECK(changed.triangles().size() < 200);
    CHECK(changed.distance({40, 20, 10}, 50) == Approx(20).margin(1e-9));  // from where the plate ended
    CHECK(changed.distance({61, 20, 10}, 50) < 1e-9);
    CHECK(changed.distance({63, 20, 5}, 50) < 1e-9);
    CHECK(changed.distance({61, 20, 5}, 50) == Approx(1).margin(1e-9));
}

TEST_CASE("what changed round a cylinder ends with it") {
    const auto pin = [](double height) {
        return part({{"Pin", Effect::adds, {cylinder({0, 0, 0}, {0, 0, 1}, 5, height)}, {}}});
    };
    const ChangedBoundary changed = diff(pin(20), pin(22), 0.1).regions[0].changed;
    CHECK(changed.distance({5, 0, 15}, 50) == Approx(5).margin(1e-3));
    CHECK(changed.distance({0, -5, 21}, 50) < 0.1 / 4);
    CHECK(changed.distance({0, 0, 21}, 50) == Approx(1).margin(0.1 / 4));
}

TEST_CASE("where a face goes on beyond one period of its free-form surface") {
    const TopoDS_Shape solid =
        GENERATE(as<TopoDS_Shape>(), vase({0, 0, 0}, {0, 0, 1}, 10, 20), blob({0, 0, 0}, 12, 20));
    ShapeUpgrade_UnifySameDomain across_seam(BRepAlgoAPI_Common(solid, box({0, -50, -50}, {50, 100, 100})).Shape());
    across_seam.Build();
    const double angle = GENERATE(-0.4, -0.01, 0.0, 0.4);
    const auto area_of_change = [&](const TopoDS_Shape& body) {
        const auto drilled = [&](double at) {
            const TopoDS_Shape hole = cylinder({0, 0, 10}, {std::cos(at), std::sin(at), 0}, 1, 40);
            return part({{"Body", Effect::adds, {body}, {}}, {"Hole", Effect::removes, {hole}, {}}});
        };
        const FeatureDifference d = diff(drilled(angle), drilled(angle + 0.5), 0.3);
        double area = 0;
        for (const auto& [a, b, c] : d.regions[0].changed.triangles()) area += 0.5 * length(cross(b - a, c - a));
        return area;
    };
    const TopoDS_Shape& half = across_seam.Shape();
    const TopoDS_Shape within_range = BRepBuilderAPI_NurbsConvert(half, true).Shape();
    CHECK(area_of_change(half) == Approx(area_of_change(within_range)).epsilon(0.03));
}

TEST_CASE("a face whose material changes sides is changed") {
    const FeatureDifference d = diff(part({{"A", Effect::adds, {box({0, 0, 0}, {10, 10, 5})}, {}}}),
                                     part({{"A", Effect::adds, {box({0, 0, 5}, {10, 10, 5})}, {}}}));
    CHECK(d.regions[0].changed.distance({5, 5, 5}, 4) < 0.3);
}

TEST_CASE("the same inputs give the same triangles") {
    const PartState was = part(bracket({12, 12, 0})), is = part(bracket({17, 13, 0}));
    const FeatureDifference a = diff(was, is), b = diff(was, is);
    REQUIRE(a.regions.size() == b.regions.size());
    for (std::size_t r = 0; r < a.regions.size(); ++r)
        CHECK(std::ranges::equal(a.regions[r].changed.triangles(), b.regions[r].changed.triangles()));
}

TEST_CASE("of a boss that moved every place of its curved walls has changed") {
    const std::function<TopoDS_Shape(Vec3)> bosses[] = {[](const Vec3& p) { return blob(p, 8, 12); },
                                                        [](const Vec3& p) {
                                                            return vase(p, {0.1, 0.2, 1}, 5, 12);
                                                        },
                                                        [](const Vec3& p) {
                                                            return ellipsoid(p, {9, 6, 7});
                                                        },
                                                        [](const Vec3& p) {
                                                            return cylinder(p, {0.1, 0.2, 1}, 6, 12);
                                                        },
                                                        [](const Vec3& p) {
                                                            return cone(p, {0.1, 0.2, 1}, 6, 2, 12);
                                                        },
                                                        [](const Vec3& p) { return sphere(p, 7); },
                                                        [](const Vec3& p) {
                                                            return torus(p, {0.1, 0.2, 1}, 7, 2);
                                                        }};
    for (std::size_t kind = 0; kind < std::size(bosses); ++kind) {
        const auto with_boss_at = [&](const Vec3& p) {
            return part({{"Plate", Effect::adds, {box({0, 0, 0}, {40, 40, 5})}, {}},
                         {"Boss", Effect::adds, {bosses[kind](p)}, {}}});
        };
        const PartState before = with_boss_at({15, 20, 4.7}), after = with_boss_at({16.7, 20.6, 4.7});
        for (const double resolution : {0.25, 0.6}) {
            const ChangedBoundary changed = diff(before, after, resolution).regions[0].changed;
            double furthest = 0;
            for (const PartState* state : {&before, &after})
                for (std::size_t f = 0; f < state->brep.face_count(); ++f)
                    furthest = std::max(furthest, furthest_of_wall(state->brep.face(FaceId(f)), changed));
            INFO("boss " << kind << ", resolution " << resolution);
            CHECK(furthest <= resolution / 4);
        }
    }
}

TEST_CASE("a moved boss carries its volume") {
    auto before = bracket({12, 12, 0}), after = before;
    after[3].instances = {test::moved(before[3].instances[0], shift({0, 8, 0}))};
    const FeatureDifference d = diff(part(before), part(after));
    CHECK(change_of(d, "Rib").verdict == Verdict::moved);
    REQUIRE(d.regions.size() == 2);
    CHECK(d.regions[1].volumes.size() == 1);
    CHECK(d.regions[1].changed.distance({40, 48, 25}, 5) == Approx(5).margin(1.6));
}

TEST_CASE("of two equal solids the one that moved is told from the one that grew") {
    const auto blocks = [](double length) {
        return part({{"Blocks",
                      Effect::adds,
                      {together({box({0, 0, 0}, {length, 10, 10}), box({length + 10, 0, 0}, {10, 10, 10})})},
                      {}}});
    };
    const FeatureDifference d = diff(blocks(10), blocks(11));
    REQUIRE(d.regions.size() == 2);
    CHECK(d.regions[1].motion == shift({1, 0, 0}));
}

TEST_CASE("a size change names the parameter") {
    auto before = bracket({12, 12, 0}), after = before;
    after[2].instances = {cylinder({85, 40, 0}, {0, 0, 1}, 12, 35)};
    after[2].parameters = {{"Diameter", 24}};
    const FeatureDifference d = diff(part(before), part(after));
    CHECK(change_of(d, "Bore").verdict == Verdict::reshaped);
    CHECK(change_of(d, "Bore").detail.in_english() == "Diameter 20 -> 24");
    CHECK(d.regions.size() == 1);
    CHECK(d.regions[0].changed.distance({85 + 14, 40, 20}, 5) == Approx(2).margin(0.3));
}

TEST_CASE("a part that moves as a whole is carried as a whole") {
    const RigidMotion motion = turn({10, 0, 0}, {1, 2, 3}, 0.7);
    auto before = bracket({12, 12, 0}), after = before;
    for (Primitive& p : after) p.instances[0] = test::moved(p.instances[0], motion);
    const FeatureDifference d = diff(part(before), part(after));
    for (const FeatureChange& f : d.features) CHECK(f.verdict == Verdict::moved);
    REQUIRE(d.regions.size() == 2);
    CHECK(d.regions[1].changed.is_empty());
    for (std::size_t f = 0; f < d.regions[1].new_face_of.size(); ++f) CHECK(d.regions[1].new_face_of[f].is_valid());
    for (const EdgeId e : d.regions[1].new_edge_of) CHECK(e.is_valid());
    for (const VertexId v : d.regions[1].new_vertex_of) CHECK(v.is_valid());
}

TEST_CASE("a notch at an edge changes only where it is") {
    std::vector<Primitive> before{{"Plate", Effect::adds, {box({0, 0, 0}, {100, 50, 10})}, {}}}, after = before;
    after.push_back({"Notch", Effect::removes, {box({40, -1, 5}, {10, 6, 10})}, {}});
    const FeatureDifference d = diff(part(before), part(after));
    CHECK(change_of(d, "Notch").verdict == Verdict::added);
    CHECK(d.regions[0].changed.distance({30, 0, 10}, 20) == Approx(10).margin(1.1));
    CHECK(d.regions[0].changed.distance({45, 0, 7}, 20) < 0.3);
    int split = 0;
    for (const auto& edges : d.regions[0].new_edges_of) split += edges.size() == 2;
    CHECK(split == 1);
}

TEST_CASE("pattern instances are matched by geometry") {
    const auto hole = [](double x) { return cylinder({x, 10, 0}, {0, 0, 1}, 3, 10); };
    std::vector<Primitive> before{{"Plate", Effect::adds, {box({0, 0, 0}, {100, 20, 10})}, {}},
                                  {"Pattern", Effect::removes, {hole(10), hole(40), hole(70)}, {{"Occurrences", 3}}}};
    auto after = before;
    after[1].instances = {hole(10), hole(25), hole(40), hole(70)};
    after[1].parameters = {{"Occurrences", 4}};
    const FeatureDifference d = diff(part(before), part(after));
    CHECK(change_of(d, "Pattern").verdict == Verdict::reshaped);
    CHECK(change_of(d, "Pattern").detail.in_english() == "Occurrences 3 -> 4; 1 hole added at x 25 mm, y 10 mm");
    CHECK(d.regions.size() == 1);
    CHECK(d.regions[0].changed.distance({40, 10, 5}, 50) > 8);
}

TEST_CASE("an instance added in the middle shifts the rest") {
    const auto hole = [](double x) { return cylinder({x, 10, -1}, {0, 0, 1}, 3, 12); };
    std::vector<Primitive> before{{"Plate", Effect::adds, {box({0, 0, 0}, {100, 20, 10})}, {}},
                                  {"Pattern", Effect::removes, {hole(10), hole(40), hole(70)}, {}}};
    auto after = before;
    after[1].instances = {hole(10), hole(30), hole(50), hole(70)};
    const FeatureDifference d = diff(part(before), part(after));
    CHECK(change_of(d, "Pattern").verdict == Verdict::reshaped);
    CHECK(change_of(d, "Pattern").detail.in_english() ==
          "1 of 3 holes moved by (-10, 0, 0) mm from x 40 mm, y 10 mm to x 30 mm, y 10 mm; 1 hole added at x 50 mm, y "
          "10 mm");
    REQUIRE(d.regions.size() == 2);
    CHECK(d.regions[1].motion == shift({-10, 0, 0}));
}

TEST_CASE("of several holes of one sketch those that moved, grew, came and went are named") {
    const auto hole = [](double x, double radius) { return cylinder({x, 10, -40}, {0, 0, 1}, radius, 80); };
    std::vector<Primitive> before{
        {"Plate", Effect::adds, {box({0, 0, 0}, {100, 20, 10})}, {}},
        {"Holes", Effect::removes, {together({hole(10, 3), hole(40, 3), hole(70, 3), hole(90, 2)})}, {}}};
    auto after = before;
    after[1].instances = {together({hole(15, 3), hole(40, 3), hole(70, 4), hole(55, 2.5)})};
    const FeatureDifference d = diff(part(before), part(after));
    const FeatureChange& change = change_of(d, "Holes");
    CHECK(change.verdict == Verdict::reshaped);
    CHECK(change.detail.in_english() ==
          "1 of 4 holes moved by (5, 0, 0) mm from x 10 mm, y 10 mm to x 15 mm, y 10 mm; 1 of 4 holes reshaped at x 70 "
          "mm, "
          "y 10 mm (radius 3 mm -> 4 mm); 1 hole added at x 55 mm, y 10 mm; 1 of 4 holes removed at x 90 mm, y 10 mm");
}

TEST_CASE("what a fillet takes off is no hole") {
    const auto rounding = [](double x, double radius) {
        const Vec3 axis{x < 50 ? x + radius : x - radius, radius, 0};
        const Vec3 corner{x < 50 ? x : x - radius, 0, 0};
        return evaluate({{"Edge", Effect::adds, {box(corner, {radius, radius, 10})}, {}},
                         {"Round", Effect::removes, {cylinder(axis - Vec3{0, 0, 1}, {0, 0, 1}, radius, 12)}, {}}});
    };
    const auto plate = [&](double radius) {
        return part({{"Plate", Effect::adds, {box({0, 0, 0}, {100, 20, 10})}, {}},
                     {"Fillet", Effect::removes, {together({rounding(0, radius), rounding(100, radius)})}, {}}});
    };
    CHECK(change_of(diff(plate(4), plate(5)), "Fillet").detail.in_english() ==
          "2 of 2 pieces reshaped at x 2.5 mm, y 2.5 mm (radius 4 mm -> 5 mm), at x 97.5 mm, y 2.5 mm (radius 4 mm -> "
          "5 mm)");
}

TEST_CASE("a mirrored instance moves with its original, and is no moved original itself") {
    const TopoDS_Shape corner =
        evaluate({{"A", Effect::adds, {box({10, 2, 10}, {8, 3, 2})}, {}},
                  {"B", Effect::adds, {box({10, 2, 10}, {2, 3, 5}), box({10, 2, 10}, {3, 6, 2})}, {}}});
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(30, 0, 0), gp_Dir(1, 0, 0)));
    const TopoDS_Shape image = BRepBuilderAPI_Transform(corner, mirror, true).Shape();
    const std::vector<Primitive> before{{"Plate", Effect::adds, {box({0, 0, 0}, {100, 20, 10})}, {}},
                                        {"Corner", Effect::adds, {corner}, {}},
                                        {"Mirrored", Effect::adds, {image}, {}}};
    auto moved_image = before, swapped = before;
    moved_image[2].instances = {test::moved(image, shift({6, 0, 0}))};
    swapped[1].instances = {image};
    swapped[2].instances = {corner};
    const FeatureDifference d = diff(part(before), part(moved_image));
    CHECK(change_of(d, "Mirrored").verdict == Verdict::moved);
    CHECK(change_of(d, "Corner").verdict == Verdict::same);
    REQUIRE(d.regions.size() == 2);
    CHECK(d.regions[1].volumes.size() == 1);
    const FeatureDifference other = diff(part(before), part(swapped));
    CHECK(change_of(other, "Corner").verdict == Verdict::reshaped);
    CHECK(other.regions.size() == 1);
    CHECK(other.regions[0].changed.is_empty());
}

TEST_CASE("a new label and another order of features change nothing") {
    std::vector<Primitive> before = bracket({12, 12, 0});
    auto after = before;
    std::swap(after[4], after[7]);
    std::swap(after[3], after[8]);
    PartState renamed = part(after);
    for (Feature& feature : renamed.tree.features) feature.label = "My " + feature.name;
    const FeatureDifference d = diff(part(before), renamed);
    CHECK(d.is_empty());
    CHECK(d.features.size() == before.size());
    CHECK(change_of(d, "Rib").label == "My Rib");
}

TEST_CASE("a feature replaced by another of the same shape keeps the boundary") {
    auto before = bracket({12, 12, 0}), after = before;
    after[4].name = "Pocket";
    const FeatureDifference d = diff(part(before), part(after));
    CHECK(change_of(d, "Hole0").verdict == Verdict::removed);
    CHECK(change_of(d, "Pocket").verdict == Verdict::added);
    CHECK(d.regions[0].changed.is_empty());
    CHECK(count(d, BoundaryVerdict::kept) == int(d.faces.size()));
}

TEST_CASE("a hole beside a rib changes the rib's interaction, not the rib") {
    auto before = bracket({12, 12, 0}), after = before;
    after.push_back({"Notch", Effect::removes, {box({40, 35, 25}, {5, 10, 5})}, {}});
    const FeatureDifference d = diff(part_with_cells(before), part_with_cells(after));
    CHECK(change_of(d, "Rib").verdict == Verdict::interaction_changed);
    CHECK(change_of(d, "Rib").detail.in_english().find("meet") != std::string::npos);
    CHECK(change_of(d, "Boss").verdict == Verdict::same);
    CHECK(change_of(d, "Notch").verdict == Verdict::added);
}

TEST_CASE("boundary that became inner, and inner that became boundary") {
    const std::vector<Primitive> low{{"Block", Effect::adds, {box({0, 0, 0}, {20, 20, 10})}, {}},
                                     {"Post", Effect::adds, {box({5, 5, 10}, {4, 4, 6})}, {}}};
    auto high = low, bare = low;
    high.push_back({"Cover", Effect::adds, {box({5, 5, 16}, {4, 4, 3})}, {}});
    bare.pop_back();
    const auto inner = [](const std::vector<Primitive>& from, const std::vector<Primitive>& to,
                          BoundaryVerdict verdict) {
        const PartState was = part(from), is = part(to);
        FeatureDifference d = diff(was, is);
        tell_inner_faces(d.faces, was.brep, is.brep);
        return std::pair(count(d, verdict), int(std::count_if(d.faces.begin(), d.faces.end(), [&](const FaceChange& f) {
                             return f.verdict == verdict && f.inner;
                         })));
    };
    CHECK(inner(low, high, BoundaryVerdict::vanished) == std::pair(1, 1));  // the post's top, under the cover
    CHECK(inner(high, low, BoundaryVerdict::appeared) == std::pair(1, 1));
    CHECK(inner(low, bare, BoundaryVerdict::vanished) == std::pair(5, 0));  // the post stood in the open
}

TEST_CASE("what became of every edge") {
    const auto edges = [](const std::vector<Primitive>& from, const std::vector<Primitive>& to) {
        const PartState was = part(from), is = part(to);
        std::vector<EdgeChange> changes = edge_changes(diff(was, is), was.brep, is.brep);
        tell_inner_edges(changes, was.brep, is.brep);
        std::map<BoundaryVerdict, std::pair<int, int>> counts;  // of which inner
        std::set<EdgeId> old_edges, new_edges;
        for (const EdgeChange& e : changes) {
            ++counts[e.verdict].first;
            counts[e.verdict].second += e.inner;
            CHECK((!e.old_edge.is_valid() || old_edges.insert(e.old_edge).second));
            CHECK(e.old_edge.is_valid() == (e.old_length > 0));
            CHECK(e.new_edge.is_valid() == (e.new_length > 0));
            if (e.verdict == BoundaryVerdict::kept) CHECK(e.old_length == Approx(e.new_length));
        }
        CHECK(old_edges.size() == was.brep.edge_count());
        return counts;
    };
    using Counts = std::map<BoundaryVerdict, std::pair<int, int>>;
    const std::vector<Primitive> plate{{"Plate", Effect::adds, {box({0, 0, 0}, {100, 50, 10})}, {}}};
    auto holed = plate, notched = plate, with_post = plate;
    holed.push_back({"Hole", Effect::removes, {cylinder({30, 20, 0}, {0, 0, 1}, 5, 10)}, {}});
    notched.push_back({"Notch", Effect::removes, {box({40, -1, 5}, {10, 6, 10})}, {}});
    with_post.push_back({"Post", Effect::adds, {box({40, 20, 10}, {4, 4, 6})}, {}});
    CHECK(edges(plate, plate) == Counts{{BoundaryVerdict::kept, {12, 0}}});
    // Both rims and the seam, which lies in what was material.
    CHECK(edges(plate, holed) == Counts{{BoundaryVerdict::kept, {12, 0}}, {BoundaryVerdict::appeared, {3, 1}}});
    CHECK(edges(holed, plate) == Counts{{BoundaryVerdict::kept, {12, 0}}, {BoundaryVerdict::vanished, {3, 1}}});
    // The notch splits one edge, which is one change, and has eleven edges of its own, five of them within the block.
    CHECK(edges(plate, notched) == Counts{{BoundaryVerdict::kept, {11, 0}},
                                          {BoundaryVerdict::trimmed_differently, {1, 0}},
                                          {BoundaryVerdict::appeared, {11, 5}}});
    auto covered = with_post;
    covered.push_back({"Cover", Effect::adds, {box({38, 18, 14}, {8, 8, 6})}, {}});
    // The post's upper rim is within the cover; its standing edges are shorter.
    const auto cover = edges(with_post, covered);
    CHECK(cover.at(BoundaryVerdict::vanished) == std::pair(4, 4));
    CHECK(cover.at(BoundaryVerdict::trimmed_differently) == std::pair(4, 0));
    CHECK(edges(covered, with_post).at(BoundaryVerdict::appeared) == std::pair(4, 4));
}

TEST_CASE("unrelated parts are noted") {
    PartState was = part({{"A", Effect::adds, {box({0, 0, 0}, {1, 1, 1})}, {}}}),
              is = part({{"B", Effect::adds, {sphere({9, 9, 9}, 1)}, {}}});
    Feature origin;  // which every document has
    origin.name = origin.label = "XY_Plane";
    origin.role = Role::reference;
    was.tree.features.insert(was.tree.features.begin(), origin);
    is.tree.features.insert(is.tree.features.begin(), origin);
    const FeatureDifference d = diff(was, is, 0.2);
    REQUIRE(d.features.size() == 3);
    CHECK(change_of(d, "A").verdict == Verdict::removed);
    CHECK(change_of(d, "B").verdict == Verdict::added);
    CHECK(d.notes.size() == 1);
}

TEST_CASE("suppressed features and features in error") {
    const auto features = bracket({12, 12, 0});
    const PartState before = part(features);
    PartState after = part({features.begin(), features.end() - 1});
    after.tree.features.push_back(before.tree.features.back());
    after.tree.features.back().suppressed = true;
    after.tree.features[1].error = "recompute failed";
    const FeatureDifference d = diff(before, after);
    CHECK(change_of(d, "Hole5").verdict == Verdict::suppressed);
    CHECK(change_of(d, "Boss").verdict == Verdict::reshaped);
    CHECK(change_of(d, "Boss").detail.in_english().find("recompute failed") != std::string::npos);
}

TEST_CASE("a resolution that is no length is refused") {
    const PartState p = part({{"A", Effect::adds, {box({0, 0, 0}, {1, 1, 1})}, {}}});
    RunContext context;
    CHECK_THROWS_AS(compare(p, p, 0, context), InputError);
}

TEST_CASE("a step named difference is timed") {
    const PartState p = part({{"A", Effect::adds, {box({0, 0, 0}, {1, 1, 1})}, {}}});
    RunContext context;
    compare(p, p, 0.5, context);
    CHECK(context.seconds().count("difference") == 1);
}
