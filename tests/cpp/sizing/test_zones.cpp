// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.h"
#include "core/errors.h"
#include "sizing/sizing_field.h"
#include "sizing/zone_field.h"
#include "sizing/zone_notes.h"

using namespace featuremesh;

namespace {

constexpr double size = 6;

Brep block() { return Brep(BRepPrimAPI_MakeBox(60, 40, 20).Shape()); }

SizeZone zone_of(decltype(SizeZone::shape) shape, const Vec3& at = {}, double inner = 1) {
    SizeZone zone;
    zone.name = "Zone";
    zone.placement.translation = at;
    zone.shape = std::move(shape);
    zone.inner = inner;
    return zone;
}

SizingOptions with(std::vector<SizeZone> zones) {
    SizingOptions options;
    options.size = size;
    options.zones = std::move(zones);
    return options;
}

SizingField field_of(const Brep& brep, std::vector<SizeZone> zones) {
    RunContext context;
    return make_sizing(brep, with(std::move(zones)), {}, context);
}

RigidMotion turned(double angle, const Vec3& to) {  // around y
    RigidMotion motion;
    motion.rotation = {std::cos(angle), 0, std::sin(angle), 0, 1, 0, -std::sin(angle), 0, std::cos(angle)};
    motion.translation = to;
    return motion;
}

std::vector<Vec3> random_points(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-10, 70), y(-10, 50), z(-10, 30);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back({x(random), y(random), z(random)});
    return points;
}

std::string refusal(SizeZone zone) {
    try {
        field_of(block(), {std::move(zone)});
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

std::string note(SizeZone zone, std::vector<Vec3> nodes = {{30, 20, 10}, {1, 1, 1}}) {
    const auto notes = notes_on_zones(block(), with({std::move(zone)}), nodes);
    return notes.empty() ? std::string() : notes[0].in_english();
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("a box asks for its size inside, and for more the further one is from it, however it is turned") {
    SizeZone zone = zone_of(BoxZone{{10, 8, 6}}, {20, 10, 5});
    const SizingField field = field_of(block(), {zone});
    CHECK(field.smallest() == 1);
    CHECK(field.at({25, 14, 8}) == 1.0);
    CHECK(field.at({30, 18, 11}) == 1.0);
    CHECK(field.at({33, 14, 8}) == Approx(1 + 0.3 * 3));
    CHECK(field.at({33, 22, 8}) == Approx(1 + 0.3 * 5));
    CHECK(field.at({60, 40, 20}) == size);

    zone.placement = turned(std::numbers::pi / 6, {20, 10, 5});
    const SizingField other = field_of(block(), {zone});
    for (const Vec3& local : {Vec3{1, 1, 1}, Vec3{9.9, 7.9, 5.9}, Vec3{5, 4, 0.01}})
        CHECK(other.at(zone.placement.apply(local)) == 1.0);
    CHECK(other.at(zone.placement.apply({12, 4, 3})) == Approx(1.6));
}

TEST_CASE("spheres and cylinders are measured exactly") {
    const SizingField sphere = field_of(block(), {zone_of(SphereZone{5}, {30, 20, 10})});
    CHECK(sphere.at({30, 20, 15}) == 1.0);
    CHECK(sphere.at({30, 27, 10}) == Approx(1.6));
    SizeZone zone = zone_of(CylinderZone{4, 10}, {30, 20, 5});
    const SizingField cylinder = field_of(block(), {zone});
    CHECK(cylinder.at({33.9, 20, 14.9}) == 1.0);
    CHECK(cylinder.at({30, 20, 17}) == Approx(1.6));
    CHECK(cylinder.at({37, 20, 19}) == Approx(1 + 0.3 * 5));
}

TEST_CASE("the size grows evenly to the outer size over the transition, then as everywhere") {
    SizeZone zone = zone_of(SphereZone{5}, {30, 20, 10});
    zone.outer = 3, zone.transition = 20;
    const SizingField field = field_of(block(), {zone});
    CHECK(field.at({30 - 15, 20, 10}) == Approx(2));
    CHECK(field.at({30 - 25, 20, 10}) == Approx(3));
    CHECK(field.at({30 - 28, 20, 10}) == Approx(3.9));
    zone.outer = 1;  // the same size for a while
    const SizingField flat = field_of(block(), {zone});
    CHECK(flat.at({30 - 24, 20, 10}) == 1.0);
    CHECK(flat.at({30 - 27, 20, 10}) == Approx(1.6));
}

TEST_CASE("no transition is steeper than the growth") {
    SizeZone zone = zone_of(SphereZone{5}, {30, 20, 10});
    zone.outer = 4, zone.transition = 2;
    const SizingField field = field_of(block(), {zone});
    CHECK(field.at({30 - 15, 20, 10}) == Approx(4));
    CHECK(field.at({30 - 7, 20, 10}) == Approx(1.6));
    const auto points = random_points(1000);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        REQUIRE(std::abs(field.at(points[i]) - field.at(points[i + 1])) <=
                0.3 * distance(points[i], points[i + 1]) + 1e-12);
}

TEST_CASE("a distance from a face, an edge and a vertex is that to the nearest of them") {
    const Brep brep = block();
    for (const Entity entity : {entity_of(FaceId(0)), entity_of(EdgeId(4)), entity_of(VertexId(2))}) {
        NearZone near;
        near.entities = {entity};
        near.reach = 3;
        const ZoneField field(brep, zone_of(near), size, 0.3);
        Box box;  // of the entity, which is axis-aligned
        if (entity.dim == 0) box.add(brep.point_of(VertexId(2)));
        if (entity.dim == 1)
            for (const VertexId v : brep.ends_of(EdgeId(4))) box.add(brep.point_of(v));
        if (entity.dim == 2)
            for (const EdgeId e : brep.edges_of(FaceId(0)))
                for (const VertexId v : brep.ends_of(e)) box.add(brep.point_of(v));
        for (const Vec3& p : random_points(500)) {
            const Vec3 inside{std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y),
                              std::clamp(p.z, box.low.z, box.high.z)};
            const double exact = std::max(0.0, distance(p, inside) - 3);
            CHECK(field.distance(p) <= exact + 1e-6);
            CHECK(field.distance(p) >= exact - 1.5);  // balls of about the inner size
        }
    }
}

TEST_CASE("of several zones in one place the smallest size counts") {
    const SizeZone coarse = zone_of(SphereZone{10}, {30, 20, 10}, 2),
                   fine = zone_of(BoxZone{{5, 5, 5}}, {30, 20, 10}, 0.7);
    const SizingField both = field_of(block(), {coarse, fine}), one = field_of(block(), {coarse}),
                      other = field_of(block(), {fine});
    for (const Vec3& p : random_points(300)) CHECK(both.at(p) == std::min(one.at(p), other.at(p)));
}

TEST_CASE("fields with other zones differ only where it is said") {
    const Brep before = block(), after(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(60, 40, 22)).Shape());
    NearZone near;
    near.entities = {entity_of(VertexId(0)), entity_of(VertexId(1))};
    const SizeZone moved = zone_of(SphereZone{2}, {12, 10, 5}), at_vertices = zone_of(near);
    const SizingField a = field_of(before, {zone_of(SphereZone{2}, {10, 10, 5}), at_vertices}),
                      b = field_of(before, {moved, at_vertices}), c = field_of(after, {moved, at_vertices});
    CHECK(where_different(a, a).empty());
    for (const auto& [first, second] : {std::pair{&a, &b}, std::pair{&b, &c}}) {
        const std::vector<Box> boxes = where_different(*first, *second);
        int outside = 0, different = 0;
        for (const Vec3& p : random_points(4000)) {
            const bool is_different = first->at(p) != second->at(p);
            different += is_different;
            if (std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return box.contains(p); })) continue;
            ++outside;
            CHECK_FALSE(is_different);
        }
        CHECK(outside > 500);
        CHECK(different > 50);
    }
}

TEST_CASE("a zone that contradicts itself is refused by its name") {
    for (const double wrong : {0.0, -1.0, std::nan("")}) {
        CHECK(has(refusal(zone_of(SphereZone{wrong})), "Zone has a radius of"));
        CHECK(has(refusal(zone_of(CylinderZone{3, wrong})), "Zone has a height of"));
        CHECK(has(refusal(zone_of(BoxZone{{1, wrong, 1}})), "Zone has a width of"));
        CHECK(has(refusal(zone_of(SphereZone{3}, {}, wrong)), "Zone has an inner size of"));
    }
    SizeZone zone = zone_of(SphereZone{3}, {}, 2);
    zone.outer = 1;
    CHECK(has(refusal(zone), "coarser inside (2 mm) than outside (1 mm)"));
    zone.outer = 0, zone.transition = -1;
    CHECK(has(refusal(zone), "grows over -1 mm"));
    NearZone near;
    near.reach = -2;
    CHECK(has(refusal(zone_of(near)), "reaches -2 mm"));
}

TEST_CASE("a zone that changes nothing is told by its name") {
    CHECK(note(zone_of(SphereZone{5}, {30, 20, 10})).empty());
    CHECK(has(note(zone_of(SphereZone{5}, {130, 20, 10})), "lies outside the part"));
    CHECK(has(note(zone_of(SphereZone{5}, {30, 20, 10}, 6)), "changes nothing"));
    CHECK(has(note(zone_of(NearZone{})), "nothing of what it refers to"));
    NearZone gone;
    gone.entities = {entity_of(FaceId(77))};
    CHECK(has(note(zone_of(gone)), "nothing of what it refers to"));
    CHECK(field_of(block(), {zone_of(gone)}).is_uniform());
    SizeZone steep = zone_of(SphereZone{5}, {30, 20, 10});
    steep.outer = 4, steep.transition = 2;
    CHECK(has(note(steep), "grows to 4 mm over 10 mm, not over 2 mm"));
}
