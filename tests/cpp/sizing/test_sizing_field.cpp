// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <numbers>
#include <random>

#include "catch.h"
#include "core/errors.h"
#include "sizing/sizing_field.h"

using namespace featuremesh;

namespace {

Brep block() { return Brep(BRepPrimAPI_MakeBox(60, 40, 20).Shape()); }
Brep block_with_hole() {
    return Brep(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(60, 40, 20).Shape(),
                                BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(30, 20, 0), gp_Dir(0, 0, 1)), 3, 20).Shape())
                    .Shape());
}

SizingOptions of_size(double size) {
    SizingOptions options;
    options.size = size;
    return options;
}

SizingField sizing_of(const Brep& brep, const SizingOptions& options, std::span<const SizeSource> kept = {}) {
    RunContext context;
    return make_sizing(brep, options, kept, context);
}

FaceId curved_face(const Brep& brep) {
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        if (brep.edges_of(FaceId(f)).size() == 3) return FaceId(f);
    return {};
}

std::vector<Vec3> random_points(const Brep& brep, int count) {
    std::mt19937 random(23);
    const Box box = brep.box().grown(5);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const Vec3 s = box.size();
        points.push_back(box.low + Vec3{share(random) * s.x, share(random) * s.y, share(random) * s.z});
    }
    return points;
}

std::string message_of(const Brep& brep, const SizingOptions& options) {
    try {
        sizing_of(brep, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("where nothing asks for less, the field is uniform") {
    const SizingField field = sizing_of(block(), of_size(3));
    CHECK(field.is_uniform());
    CHECK(field.at({1, 2, 3}) == 3.0);
    CHECK(field.smallest() == 3.0);
    // twelve elements around a hole of radius 3 are 1.57 long
    CHECK(sizing_of(block_with_hole(), of_size(1.5)).is_uniform());
    CHECK_FALSE(sizing_of(block_with_hole(), of_size(1.6)).is_uniform());
    SizingOptions off = of_size(6);
    off.elements_per_circle = 0;
    CHECK(sizing_of(block_with_hole(), off).is_uniform());
}

TEST_CASE("a wrong size is refused with the figure and the part's size") {
    for (double wrong :
         {0.0, -1.0, 61.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        CHECK_THROWS_AS(sizing_of(block(), of_size(wrong)), InputError);
    CHECK(message_of(block(), of_size(200)).find("200") != std::string::npos);
    CHECK(message_of(block(), of_size(200)).find("60 x 40 x 20 mm") != std::string::npos);
    CHECK(message_of(block(), of_size(59)).empty());
    SizingOptions options = of_size(3);
    options.growth = 0.9;
    CHECK(message_of(block(), options).find("growth") != std::string::npos);
    options = of_size(3);
    options.min_size = 4;
    CHECK(message_of(block(), options).find("smallest") != std::string::npos);
    options = of_size(3);
    options.local = {{entity_of(FaceId(3)), 0}};
    CHECK(message_of(block(), options).find("Face4") != std::string::npos);
    options.local = {{entity_of(EdgeId(0)), -2}};
    CHECK(message_of(block(), options).find("Edge1") != std::string::npos);
}

TEST_CASE("a part as small as the kernel's tolerance is refused") {
    const auto cube = [](double side) { return Brep(BRepPrimAPI_MakeBox(side, side, side).Shape()); };
    CHECK(message_of(cube(0.0005), of_size(0.0001)).find("0.0005 x 0.0005 x 0.0005 mm") != std::string::npos);
    CHECK(message_of(cube(0.002), of_size(0.0005)).empty());
}

TEST_CASE("curvature puts the elements around the circle") {
    const SizingField field = sizing_of(block_with_hole(), of_size(8));
    const double wanted = 2 * std::numbers::pi * 3 / 12;
    CHECK(field.smallest() == Approx(wanted));
    for (double angle = 0; angle < 6.2; angle += 0.37)
        for (double z : {0.0, 3.3, 11.0, 20.0})
            CHECK(field.at({30 + 3 * std::cos(angle), 20 + 3 * std::sin(angle), z}) == Approx(wanted));
    CHECK(field.at({0, 0, 0}) == 8.0);

    const SizingField sphere = sizing_of(Brep(BRepPrimAPI_MakeSphere(5).Shape()), of_size(6));
    for (const Vec3& d : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0.6, 0.64, 0.48}})
        CHECK(sphere.at(5.0 * d) == Approx(2 * std::numbers::pi * 5 / 12).epsilon(0.01));

    const SizingField torus = sizing_of(Brep(BRepPrimAPI_MakeTorus(20, 4).Shape()), of_size(10));
    CHECK(torus.at({24, 0, 0}) == Approx(2 * std::numbers::pi * 4 / 12).epsilon(0.01));
    CHECK(torus.at({0, 16, 0}) == Approx(2 * std::numbers::pi * 4 / 12).epsilon(0.01));

    // thick as it is, it curves most where it nearly closes its hole
    const SizingField nearly_closed = sizing_of(Brep(BRepPrimAPI_MakeTorus(10, 9).Shape()), of_size(4));
    CHECK(nearly_closed.at({1, 0, 0}) == Approx(2 * std::numbers::pi * 1 / 12).epsilon(0.01));

    SizingOptions limited = of_size(8);
    limited.min_size = 2.5;
    CHECK(sizing_of(block_with_hole(), limited).smallest() == Approx(2.5));
}

TEST_CASE("the apex of a cone asks for a quarter of its base at least") {
    const SizingField field = sizing_of(Brep(BRepPrimAPI_MakeCone(10, 0, 10).Shape()), of_size(10));
    const double at_base = 2 * std::numbers::pi * 10 / 12;
    CHECK(field.smallest() >= 0.2 * at_base);
    CHECK(field.at({0, 0, 10}) <= 0.5 * at_base);
}

TEST_CASE("local sizes are obeyed on their entities") {
    const Brep brep = block_with_hole();
    SizingOptions options = of_size(8);
    options.elements_per_circle = 0;
    const FaceId hole = curved_face(brep);
    REQUIRE(hole.is_valid());
    options.local = {{entity_of(hole), 0.7}};
    const SizingField on_face = sizing_of(brep, options);
    for (double angle = 0; angle < 6.2; angle += 0.21)
        for (double z : {0.0, 7.7, 20.0})
            CHECK(on_face.at({30 + 3 * std::cos(angle), 20 + 3 * std::sin(angle), z}) == Approx(0.7));
    CHECK(on_face.at({30 + 3 + 10, 20, 10}) > 2.5);

    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        const auto ends = brep.ends_of(EdgeId(e));
        if (ends[0] == ends[1]) continue;
        options.local = {{entity_of(EdgeId(e)), 0.9}};
        const SizingField on_edge = sizing_of(brep, options);
        const Vec3 a = brep.point_of(ends[0]), b = brep.point_of(ends[1]);
        for (double t : {0.0, 0.13, 0.5, 0.77, 1.0}) CHECK(on_edge.at(a + (b - a) * t) == Approx(0.9));
    }
    options.local = {{entity_of(VertexId(0)), 0.5}};
    const SizingField at_vertex = sizing_of(brep, options);
    CHECK(at_vertex.at(brep.point_of(VertexId(0))) == Approx(0.5));
    options.local = {{entity_of(SolidId(0)), 2}};
    CHECK(sizing_of(brep, options).is_uniform());
    CHECK(sizing_of(brep, options).at({1, 1, 1}) == 2.0);
}

TEST_CASE("a local size on a planar face covers all of it and little else") {
    const Brep brep = block();
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        SizingOptions options = of_size(10);
        options.local = {{entity_of(FaceId(f)), 1}};
        const SizingField field = sizing_of(brep, options);
        Box box;
        for (const EdgeId e : brep.edges_of(FaceId(f)))
            for (const VertexId v : brep.ends_of(e)) box.add(brep.point_of(v));
        for (double s : {0.0, 0.21, 0.5, 1.0})
            for (double t : {0.0, 0.4, 0.93}) {
                const Vec3 size = box.size();
                const Vec3 p{box.low.x + s * size.x, box.low.y + (size.x > 0 ? t : s) * size.y, box.low.z + t * size.z};
                CHECK(field.at(p) == Approx(1.0));
            }
        const Vec3 center = brep.box().center();
        const double depth = distance(center, box.center());
        CHECK(field.at(center) >= 1 + 0.3 * (depth - 2.5));
    }
}

TEST_CASE("a local size far too small for a face is taken in bounded work, and asks for too much") {
    const Brep brep = block();
    SizingOptions options = of_size(10);
    options.local = {{entity_of(FaceId(0)), 1e-7}};
    const SizingField field = sizing_of(brep, options);
    CHECK(field.smallest() == 1e-7);
    CHECK(may_ask_for_more_tets(brep, field, 5e7));
    CHECK(estimate_tets(brep, field) > 5e7);
}

TEST_CASE("a local size in one of two solids stays there") {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(20, 20, 20).Shape());
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(60, 0, 0), gp_Pnt(90, 30, 30)).Shape());
    const Brep brep(both);
    SizingOptions options = of_size(10);
    options.local = {{entity_of(SolidId(0)), 2}};
    const SizingField field = sizing_of(brep, options);
    for (const Vec3& p : random_points(Brep(BRepPrimAPI_MakeBox(gp_Pnt(5, 5, 5), gp_Pnt(15, 15, 15)).Shape()), 300))
        CHECK(field.at(p) == Approx(2.0));
    CHECK(field.at({75, 15, 15}) > 9);
}

TEST_CASE("an entity that is gone is left out and logged") {
    RunContext context;
    std::string log;
    context.on_log = [&](std::string_view line) { log += line; };
    SizingOptions options = of_size(4);
    options.local = {{entity_of(FaceId(77)), 1}};
    CHECK(make_sizing(block(), options, {}, context).is_uniform());
    CHECK(log.find("Face78") != std::string::npos);
}

TEST_CASE("the field grows no faster than asked") {
    const Brep brep = block_with_hole();
    for (double growth : {1.1, 1.3, 2.0}) {
        SizingOptions options = of_size(9);
        options.growth = growth;
        options.local = {{entity_of(VertexId(2)), 0.3}, {entity_of(EdgeId(4)), 0.8}};
        const SizingField field = sizing_of(brep, options);
        const auto points = random_points(brep, 1500);
        std::mt19937 random(9);
        std::uniform_real_distribution<double> shift(-1, 1);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec3 near = points[i] + Vec3{shift(random), shift(random), shift(random)};
            REQUIRE(std::abs(field.at(points[i]) - field.at(near)) <= (growth - 1) * distance(points[i], near) + 1e-12);
            REQUIRE(std::abs(field.at(points[i]) - field.at(points[i + 1])) <=
                    (growth - 1) * distance(points[i], points[i + 1]) + 1e-12);
            REQUIRE(field.at(points[i]) <= 9.0);
            REQUIRE(field.at(points[i]) >= field.smallest());
        }
    }
}

TEST_CASE("kept nodes anchor the field where their mesh is finer, and only there") {
    const std::vector<SizeSource> like_the_field{{{10, 10, 10}, 3.3}, {{20, 10, 10}, 4.4}, {{5, 5, 5}, 5.5}};
    CHECK(sizing_of(block(), of_size(4), like_the_field).is_uniform());
    const std::vector<SizeSource> finer{{{10, 10, 10}, 1.0}};
    const SizingField field = sizing_of(block(), of_size(4), finer);
    CHECK(field.at({10, 10, 10}) == Approx(1.0));
    CHECK(field.at({15, 10, 10}) == Approx(2.5));
    CHECK(field.at({40, 10, 10}) == 4.0);
}

TEST_CASE(
    "kept nodes whose mesh is coarser than the global size let the field be as coarse, but for what the shape asks "
    "for") {
    const std::vector<SizeSource> coarser{{{10, 10, 10}, 9.0}, {{12, 10, 10}, 8.0}};
    SizingOptions options = of_size(4);
    const SizingField field = sizing_of(block(), options, coarser);
    CHECK_FALSE(field.is_uniform());
    CHECK(field.largest() == 9.0);
    CHECK(field.at({10, 10, 10}) == Approx(9.0));
    CHECK(field.at({22, 10, 10}) == Approx(9.0 - 0.3 * (12 - 9)));
    CHECK(field.at({39, 10, 10}) == 4.0);
    CHECK(where_different(field, sizing_of(block(), options, coarser)).empty());
    CHECK(where_different(field, sizing_of(block(), options)).size() == 1);
    options.local = {{entity_of(FaceId(0)), 1}};
    const SizingField local = sizing_of(block(), options, coarser), plain = sizing_of(block(), options);
    for (const Vec3& p : random_points(block(), 200)) {
        CHECK(local.at(p) <= field.at(p));
        CHECK(local.at(p) >= plain.at(p));
    }
}

TEST_CASE("the same sizes give the same field, and a moved part a moved one") {
    const Brep brep = block_with_hole();
    const SizingField a = sizing_of(brep, of_size(8)), b = sizing_of(brep, of_size(8));
    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(100, -50, 20));
    const SizingField moved = sizing_of(Brep(brep.shape().Moved(TopLoc_Location(shift))), of_size(8));
    for (const Vec3& p : random_points(brep, 200)) {
        CHECK(a.at(p) == b.at(p));
        CHECK(moved.at(p + Vec3{100, -50, 20}) == Approx(a.at(p)));
    }
}

TEST_CASE("the estimate follows the volume and the field") {
    const Brep brep = block();
    const double coarse = estimate_tets(brep, sizing_of(brep, of_size(4))),
                 fine = estimate_tets(brep, sizing_of(brep, of_size(2)));
    CHECK(fine > 8 * coarse);  // the boundary has its share
    CHECK(fine < 9 * coarse);
    SizingOptions options = of_size(4);
    options.local = {{entity_of(FaceId(0)), 1}};
    const SizingField graded = sizing_of(brep, options);
    // the same integral by brute force
    double sum = 0;
    const int n = 60;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                const double h = graded.at({60 * (i + 0.5) / n, 40 * (j + 0.5) / n, 20 * (k + 0.5) / n});
                sum += 1 / (h * h * h);
            }
    const double finer = (sum / (n * n * n) - 1.0 / 64) * brep.volume();
    const double per_cube = (estimate_tets(brep, graded) - coarse) / finer;
    CHECK(per_cube > 7);
    CHECK(per_cube < 10.5);
}

TEST_CASE("an estimate of few tets may be too large, as if all of the box were inside") {
    const Brep brep(BRepPrimAPI_MakeCylinder(20, 20).Shape());
    SizingOptions options = of_size(4);
    for (std::size_t f = 0; f < brep.face_count(); ++f) options.local.push_back({entity_of(FaceId(f)), 1});
    const SizingField graded = sizing_of(brep, options);
    const double tets = estimate_tets(brep, graded);
    CHECK(estimate_tets(brep, graded, {}, tets) == tets);
    CHECK(estimate_tets(brep, graded, {}, 10 * tets) > 1.05 * tets);
}

TEST_CASE("few looks tell that a field does not ask for too much") {
    const Brep brep = block();
    SizingOptions options = of_size(4);
    options.min_size = 1e-4;
    options.local = {{entity_of(VertexId(0)), 1e-3}};  // one tiny place, which a bound by the smallest size overrates
    const SizingField graded = sizing_of(brep, options);
    const double tets = estimate_tets(brep, graded);
    CHECK_FALSE(may_ask_for_more_tets(brep, graded, 20 * tets));
    CHECK(may_ask_for_more_tets(brep, graded, tets));
    CHECK(may_ask_for_more_tets(brep, sizing_of(brep, of_size(0.01)), 5e7));
}

TEST_CASE("few looks tell it of a part with many fine edges, too") {
    const Brep brep = block();
    SizingOptions options = of_size(4);
    options.min_size = 1e-3;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) options.local.push_back({entity_of(EdgeId(e)), 0.2});
    const SizingField graded = sizing_of(brep, options);
    CHECK_FALSE(may_ask_for_more_tets(brep, graded, 5 * estimate_tets(brep, graded)));
}

TEST_CASE("two fields differ only where it is said") {
    const auto drilled = [](std::initializer_list<double> places) {
        TopoDS_Shape shape = BRepPrimAPI_MakeBox(60, 40, 20).Shape();
        for (const double x : places)
            shape = BRepAlgoAPI_Cut(shape,
                                    BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 20, 0), gp_Dir(0, 0, 1)), 3, 20).Shape())
                        .Shape();
        return Brep(shape);
    };
    const Brep before = drilled({10, 30}), after = drilled({10, 33});
    const SizingField a = sizing_of(before, of_size(4)), b = sizing_of(after, of_size(4));
    const std::vector<Box> boxes = where_different(a, b);
    int outside = 0, different = 0;
    for (const Vec3& p : random_points(before, 5000)) {
        different += a.at(p) != b.at(p);
        if (std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return box.contains(p); })) continue;
        ++outside;
        CHECK(a.at(p) == b.at(p));
    }
    CHECK(outside > 1000);
    CHECK(different > 100);
    CHECK(where_different(a, a).empty());
    const auto everywhere = where_different(a, sizing_of(after, of_size(3)));
    REQUIRE(everywhere.size() == 1);
    CHECK(everywhere[0].contains({1e6, -1e6, 0}));
}

TEST_CASE("asking again for what is asked for asks for half of it, however often") {
    const Brep brep = block();
    const Vec3 p{20, 10, 10};
    for (const double size : {4.9, 4.4, 3.6}) {  // longer than what would be felt
        std::vector<SizeSource> sources;
        SizingField field = sizing_of(brep, of_size(5));
        double expected = 5;
        for (int again = 0; again < 4; ++again) {
            const SizeSource source = shorter_than_asked(field, {p, size});
            expected = 0.5 * expected;
            CHECK(source.size == Approx(expected));
            sources.push_back(source);
            field = sizing_of(brep, of_size(5), sources);
            CHECK(field.at(p) == Approx(expected));
        }
        CHECK(shorter_than_asked(field, {p, 0.2}).size == 0.2);
    }
}

// Halving all of the part down to such sizes takes minutes.
TEST_CASE("a size far too small is soon told to make too many tets") {
    const Brep brep = block_with_hole();
    SizingOptions options = of_size(0.01);
    options.local = {{entity_of(VertexId(0)), 0.002}};
    const double tets = estimate_tets(brep, sizing_of(brep, options)),
                 plain = estimate_tets(brep, sizing_of(brep, of_size(0.01)));
    CHECK(tets >= plain);
    CHECK(tets < 1.01 * plain);
}

TEST_CASE("a ball has its size, which grows around it, and only there is the field another one") {
    const Brep brep = block();
    SizingOptions options = of_size(8);
    const SizingField plain = sizing_of(brep, options);
    options.balls = {{{30, 20, 10}, 2, 1}, {{5, 5, 5}, 1, 20}};  // what is coarser than the size asks for nothing
    const SizingField field = sizing_of(brep, options);
    CHECK(field.at({30, 20, 11}) == 1);
    CHECK(field.at({36, 20, 10}) == Approx(1 + 0.3 * 4));
    CHECK(field.at({5, 5, 5}) == 8);
    CHECK(field.smallest() == 1);
    const std::vector<Box> boxes = where_different(plain, field);
    REQUIRE(boxes.size() == 1);
    CHECK(boxes[0].contains({30, 20, 10}));
    CHECK(boxes[0].size().x == Approx(2 * (2 + 7 / 0.3)));
    CHECK(where_different(field, sizing_of(brep, options)).empty());
}
