// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include "catch.h"
#include "core/errors.h"
#include "part_documents.h"
#include "update/field_transfer.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

using Field = std::function<double(const Vec3&)>;

struct Pair {
    std::shared_ptr<const PartMesh> before, after;
};

Pair edited(int order) {
    MeshOptions options;
    options.sizing.size = 2.5;
    options.order = order;
    RunContext context;
    const auto before = mesh_part(plate_with_hole(20), options, context).part_mesh;
    return {before, update_part(*before, plate_with_hole(22), options, context).part_mesh};
}

std::vector<double> sampled(const Mesh& mesh, const Field& field) {
    std::vector<double> values;
    for (const Vec3& p : mesh.points) values.push_back(field(p));
    return values;
}

TransferredField carried(const Mesh& before, const Mesh& after, const std::vector<double>& values) {
    RunContext context;
    return transfer_field(before, after, values, 0, context);
}

/// Largest difference from the field at nodes that got their value in this way.
double largest_difference(const Mesh& mesh, const TransferredField& found, const Field& field, ValueSource source) {
    double largest = 0;
    for (std::size_t n = 0; n < mesh.node_count(); ++n)
        if (found.sources[n] == source) largest = std::max(largest, std::abs(found.values[n] - field(mesh.points[n])));
    return largest;
}

double linear(const Vec3& p) { return 3 + 0.2 * p.x - 0.7 * p.y + 1.1 * p.z; }
double quadratic(const Vec3& p) {
    return 1 + 0.1 * p.x * p.x - 0.3 * p.x * p.y + 0.2 * p.z * p.z + 0.4 * p.y * p.z - p.x;
}

}  // namespace

TEST_CASE("kept nodes keep their values bit for bit") {
    for (const int order : {1, 2}) {
        const auto [before, after] = edited(order);
        const std::vector<double> values = sampled(before->mesh, [](const Vec3& p) { return std::sin(p.x) + p.y; });
        const TransferredField found = carried(before->mesh, after->mesh, values);
        std::size_t same = 0;
        for (std::size_t n = 0; n < after->mesh.node_count(); ++n) {
            const std::int32_t origin = after->node_origin[n];
            CHECK((found.sources[n] == ValueSource::same_node) == (origin >= 0));
            if (origin < 0) continue;
            ++same;
            REQUIRE(found.values[n] == values[std::size_t(origin)]);
            REQUIRE(found.errors[n] == 0);
        }
        CHECK(same > 100);
        CHECK(same < after->mesh.node_count());
    }
}

TEST_CASE("a mesh that was numbered anew, as those of results are, has the same nodes") {
    for (const int order : {1, 2}) {
        const auto [before, after] = edited(order);
        Mesh renumbered = before->mesh;
        for (std::size_t n = 0; n < renumbered.node_count(); ++n) {
            renumbered.node_numbers[n] = Number(renumbered.node_count() - n);
            renumbered.points[n] = renumbered.points[n] + Vec3{3e-5, -2e-5, 1e-5};
        }
        const std::vector<double> values = sampled(before->mesh, quadratic);
        RunContext context;
        const TransferredField found = transfer_field(renumbered, after->mesh, values, 1e-4, context);
        for (std::size_t n = 0; n < after->mesh.node_count(); ++n) {
            const std::int32_t origin = after->node_origin[n];
            const bool is_known = std::any_of(renumbered.points.begin(), renumbered.points.end(), [&](const Vec3& p) {
                return distance(p, after->mesh.points[n]) <= 1e-4;
            });
            REQUIRE((found.sources[n] == ValueSource::same_node) == is_known);
            REQUIRE((is_known || origin < 0));
            if (origin >= 0) REQUIRE(found.values[n] == values[std::size_t(origin)]);
        }
    }
}

TEST_CASE("linear fields are interpolated exactly, quadratic ones between 10-node tets") {
    for (const int order : {1, 2}) {
        const auto [before, after] = edited(order);
        const TransferredField found = carried(before->mesh, after->mesh, sampled(before->mesh, linear));
        CHECK(largest_difference(after->mesh, found, linear, ValueSource::inside) < 1e-11);
    }
    // The plate without its hole has straight sides only, where the quadratic shape functions hold all quadratic
    // fields.
    MeshOptions options;
    options.sizing.size = 3;
    options.order = 2;
    RunContext context;
    const RawDocument box = PartDocument().box("Part", {0, 0, 0}, {20, 15, 10}).finish();
    const auto coarse = mesh_part(box, options, context).part_mesh;
    options.sizing.size = 2.2;
    const auto fine = mesh_part(box, options, context, {1000000, 1000000}).part_mesh;
    const TransferredField found = carried(coarse->mesh, fine->mesh, sampled(coarse->mesh, quadratic));
    CHECK(std::count(found.sources.begin(), found.sources.end(), ValueSource::same_node) == 0);
    CHECK(std::count(found.sources.begin(), found.sources.end(), ValueSource::inside) > 1000);
    CHECK(largest_difference(fine->mesh, found, quadratic, ValueSource::inside) < 1e-10);
}

TEST_CASE("the error figure follows the true error") {
    const auto [before, after] = edited(1);
    const TransferredField found = carried(before->mesh, after->mesh, sampled(before->mesh, quadratic));
    double truth = 0, estimate = 0;
    for (std::size_t n = 0; n < after->mesh.node_count(); ++n) {
        if (found.sources[n] != ValueSource::inside) continue;
        truth += std::abs(found.values[n] - quadratic(after->mesh.points[n]));
        estimate += found.errors[n];
    }
    CHECK(estimate > 0.5 * truth);
    CHECK(estimate < 2 * truth);
    const TransferredField straight = carried(before->mesh, after->mesh, sampled(before->mesh, linear));
    CHECK(*std::max_element(straight.errors.begin(), straight.errors.end()) <
          1.0);  // only outside, by what the field changes over that distance
}

TEST_CASE("outside the old mesh the nearest point of its boundary counts") {
    MeshOptions options;
    options.sizing.size = 3;
    RunContext context;
    const auto before =
        mesh_part(PartDocument().box("Part", {0, 0, 0}, {20, 15, 10}).finish(), options, context).part_mesh;
    const auto after =
        mesh_part(PartDocument().box("Part", {0, 0, 0}, {20, 15, 14}).finish(), options, context, {1000000, 1000000})
            .part_mesh;
    const TransferredField found = carried(before->mesh, after->mesh, sampled(before->mesh, linear));
    const auto clamped = [](const Vec3& p) { return linear({p.x, p.y, std::min(p.z, 10.0)}); };
    CHECK(largest_difference(after->mesh, found, clamped, ValueSource::outside) < 1e-11);
    for (std::size_t n = 0; n < after->mesh.node_count(); ++n)
        if (found.sources[n] == ValueSource::outside)
            REQUIRE(std::abs(found.errors[n] - 1.1 * (after->mesh.points[n].z - 10)) < 1e-9);
}

TEST_CASE("old tets without volume, which other makers' meshes may have, tell nothing") {
    MeshOptions coarse, fine;
    coarse.sizing.size = 3, fine.sizing.size = 2.6;
    RunContext context;
    const RawDocument box = PartDocument().box("Part", {0, 0, 0}, {20, 15, 10}).finish();
    Mesh before = mesh_part(box, coarse, context).part_mesh->mesh;
    const auto after = mesh_part(box, fine, context, {1000000, 1000000}).part_mesh;
    std::vector<NodeId> below;
    for (std::size_t n = 0; n < before.node_count(); ++n)
        if (before.points[n].z == 0) below.emplace_back(n);
    REQUIRE(below.size() > 20);
    for (std::size_t i = 0; i + 3 < below.size(); ++i)
        before.add_tet({below[i], below[i + 1], below[i + 2], below[i + 3]}, SolidId(std::size_t{0}));
    const TransferredField found = carried(before, after->mesh, sampled(before, linear));
    const auto is_finite = [](double x) { return std::isfinite(x); };
    CHECK(std::all_of(found.values.begin(), found.values.end(), is_finite));
    CHECK(std::all_of(found.errors.begin(), found.errors.end(), is_finite));
    CHECK(largest_difference(after->mesh, found, linear, ValueSource::inside) < 1e-11);
}

TEST_CASE("an old mesh that has every tet twice has a boundary, too") {
    MeshOptions options;
    options.sizing.size = 3;
    RunContext context;
    const auto block = [&](double height, NextNumbers next) {
        const RawDocument document = PartDocument().box("Part", {0, 0, 0}, {20, 15, height}).finish();
        return mesh_part(document, options, context, next).part_mesh;
    };
    const auto before = block(10, {}), after = block(14, {1000000, 1000000});
    Mesh doubled = before->mesh;
    for (const auto& tet : before->mesh.tets) doubled.add_tet(tet, SolidId(std::size_t{0}));
    const std::vector<double> values = sampled(doubled, linear);
    const TransferredField found = carried(doubled, after->mesh, values);
    CHECK(std::count(found.sources.begin(), found.sources.end(), ValueSource::outside) > 10);
    CHECK(found.values == carried(before->mesh, after->mesh, values).values);

    Mesh both_ways = before->mesh;  // no side of any facet is free
    for (const auto& [a, b, c, d] : before->mesh.tets) both_ways.add_tet({a, c, b, d}, SolidId(std::size_t{0}));
    CHECK_THROWS_AS(carried(both_ways, after->mesh, values), InputError);
}

TEST_CASE("values go along with a feature that moved, and sizes are checked") {
    const auto boss = [](double x) {
        return PartDocument()
            .box("Block", {0, 0, 0}, {60, 30, 8})
            .cylinder("Boss", {x, 15, 8}, 8, 16)
            .fuse("Part", "Block", "Boss")
            .finish();
    };
    MeshOptions options;
    options.sizing.size = 2.5;
    RunContext context;
    const auto before = mesh_part(boss(20), options, context).part_mesh;
    const auto after = update_part(*before, boss(30), options, context).part_mesh;
    const std::vector<double> values = sampled(before->mesh, quadratic);
    const TransferredField found = carried(before->mesh, after->mesh, values);
    std::size_t carried_along = 0;
    for (std::size_t n = 0; n < after->mesh.node_count(); ++n)
        if (const std::int32_t o = after->node_origin[n];
            o >= 0 && !(before->mesh.points[std::size_t(o)] == after->mesh.points[n])) {
            ++carried_along;
            CHECK(found.values[n] == values[std::size_t(o)]);
        }
    CHECK(carried_along > 50);
    CHECK_THROWS_AS(transfer_field(before->mesh, after->mesh, std::span(values).subspan(1), 0, context), InputError);
}
