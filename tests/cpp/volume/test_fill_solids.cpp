// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <span>

#include "catch.h"
#include "core/errors.h"
#include "filled_parts.h"
#include "mesh/quality.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// The mesh with some of its tets, as an update hands it over: nodes that only dropped tets had are gone.
Mesh kept_part(const Mesh& mesh, const std::vector<bool>& is_kept) {
    Mesh part = mesh;
    part.tets.clear(), part.tet_solids.clear(), part.tet_numbers.clear();
    part.points.clear(), part.entities.clear(), part.parameters.clear(), part.node_numbers.clear();
    std::vector<bool> is_used(mesh.node_count(), false);
    for (std::size_t n = 0; n < mesh.node_count(); ++n) is_used[n] = mesh.entities[n].dim < 3;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
        if (is_kept[t])
            for (const NodeId n : mesh.tets[t]) is_used[n.index()] = true;
    std::vector<NodeId> moved(mesh.node_count());
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
        if (!is_used[n]) continue;
        moved[n] = NodeId(part.points.size());
        part.points.push_back(mesh.points[n]);
        part.entities.push_back(mesh.entities[n]);
        part.parameters.push_back(mesh.parameters[n]);
        part.node_numbers.push_back(mesh.node_numbers[n]);
    }
    for (auto& segment : part.segments)
        for (NodeId& n : segment) n = moved[n.index()];
    for (auto& triangle : part.triangles)
        for (NodeId& n : triangle) n = moved[n.index()];
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (!is_kept[t]) continue;
        auto tet = mesh.tets[t];
        for (NodeId& n : tet) n = moved[n.index()];
        part.tets.push_back(tet);
        part.tet_solids.push_back(mesh.tet_solids[t]);
        part.tet_numbers.push_back(mesh.tet_numbers[t]);
    }
    part.corner_count = part.points.size();
    return part;
}

Vec3 center_of(const Mesh& mesh, std::size_t t) {
    Vec3 sum;
    for (const NodeId n : mesh.tets[t]) sum += mesh.point(n);
    return sum / 4;
}

/// Of two triangles in the middle of the face, whose tets stay as they are.
bool change_a_diagonal(Mesh& mesh, FaceId face) {
    const auto is_inner = [&](std::size_t t) {
        return mesh.triangle_faces[t] == face &&
               std::all_of(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                           [&](NodeId n) { return mesh.entities[n.index()].dim == 2; });
    };
    for (std::size_t s = 0; s < mesh.triangles.size(); ++s)
        for (std::size_t t = s + 1; t < mesh.triangles.size() && is_inner(s); ++t)
            for (int i = 0; i < 9 && is_inner(t); ++i) {
                auto& one = mesh.triangles[s];
                auto& other = mesh.triangles[t];
                const NodeId a = one[i / 3], b = one[(i / 3 + 1) % 3], c = one[(i / 3 + 2) % 3];
                if (other[i % 3] != c || other[(i % 3 + 1) % 3] != b) continue;
                const NodeId d = other[(i % 3 + 2) % 3];
                one = {a, b, d};
                other = {a, d, c};
                return true;
            }
    return false;
}

/// What was kept is there, bit for bit and in order, but for what the result says it released.
void check_kept(const Mesh& before, const VolumeResult& result) {
    const Mesh& after = result.mesh;
    REQUIRE(after.node_count() >= before.node_count());
    const std::set<NodeId> moved(result.moved.begin(), result.moved.end());
    for (std::size_t n = 0; n < before.node_count(); ++n) {
        const bool is_moved = moved.contains(NodeId(n));
        REQUIRE((after.points[n] == before.points[n]) == !is_moved);
        REQUIRE((after.node_numbers[n] == before.node_numbers[n]) == !is_moved);
        if (is_moved) REQUIRE(before.entities[n].dim == 3);
    }
    const std::set<TetId> released(result.released.begin(), result.released.end());
    CHECK(released.size() == result.report.released_tets);
    std::size_t place = 0;
    bool is_same = true;
    for (std::size_t t = 0; t < before.tets.size(); ++t) {
        if (released.contains(TetId(t))) continue;
        is_same = is_same && after.tets[place] == before.tets[t] && after.tet_numbers[place] == before.tet_numbers[t];
        ++place;
    }
    CHECK(is_same);
    const std::set<Number> numbers(after.tet_numbers.begin(), after.tet_numbers.end());
    CHECK(numbers.size() == after.tet_numbers.size());
}

}  // namespace

TEST_CASE("parts of all kinds are filled") {
    const auto [name, shape, size] = GENERATE(table<std::string, TopoDS_Shape, double>(
        {{"drilled", drilled_part(), 3.0},
         {"drilled, turned, far away", turned(drilled_part(), 0.777, {1e5, 7e4, -1e5}), 3.0},
         {"two solids", two_solids(), 3.0},
         {"hollow", hollow_part(), 2.5},
         {"touching along a line", touching_cylinders(), 2.5},
         {"touching at a point", cylinders_at_a_point(), 2.5},
         {"unglued", unglued_boxes(), 2.5}}));
    INFO(name);
    const Part part = prepare(shape, size);
    const VolumeResult result = fill(part);
    CHECK(findings(part.brep, result.mesh) == "");
    CHECK(result.report.new_tets == result.mesh.tets.size());
    CHECK(result.released.empty());
    const QualityReport quality = measure_quality(result.mesh);
    CHECK(quality.mean_radius_ratio > 0.8);
    CHECK(quality.min_dihedral > 20);
}

TEST_CASE("thin parts are filled, with the boundary recovered") {
    const auto [name, shape, size] = GENERATE(table<std::string, TopoDS_Shape, double>(
        {{"wedge of 15 degrees", wedge_part(15), 4.0},
         {"wedge of 5 degrees", turned(wedge_part(5), 0.4, {}), 6.0},
         {"tube, wall 1, size 6", tube_part(15, 20), 6.0},
         {"plate 0.5 thick, size 5", box_part({0, 0, 0}, {40, 30, 0.5}), 5.0},
         {"plate in a skew place", turned(box_part({0, 0, 0}, {40, 30, 0.5}), 0.6, {3, 4, 5}), 5.0},
         {"walls and slits of 0.1, size 4", comb_part(10, 0.1), 4.0},
         {"walls and slits of 0.03, size 4", comb_part(10, 0.03), 4.0},
         {"walls and slits of 0.05, turned", turned(comb_part(6, 0.05), 0.7, {3, 4, 5}), 4.0}}));
    INFO(name);
    const Part part = prepare(shape, size);
    CHECK(findings(part.brep, fill(part).mesh) == "");
}

TEST_CASE("recovery keeps every boundary node on its entity") {
    const Part part = prepare(tube_part(10, 15), 8.0);
    const VolumeResult result = fill(part);
    CHECK(findings(part.brep, result.mesh) == "");
    for (std::size_t n = 0; n < result.mesh.node_count(); ++n) {
        const Vec3& p = result.mesh.points[n];
        if (result.mesh.entities[n].dim == 3) continue;
        const double radius = std::hypot(p.x, p.y);
        const double off = std::min({std::abs(radius - 10), std::abs(radius - 9), std::abs(p.z), std::abs(p.z - 15)});
        CHECK(off < 1e-7);
    }
}

TEST_CASE("any kept part of a mesh is refilled around, bit for bit") {
    const Part part = prepare(drilled_part(), 3.0);
    const Mesh full = fill(part).mesh;
    const unsigned seed = GENERATE(1u, 2u, 3u, 4u);
    const bool is_scattered = GENERATE(false, true);
    INFO("seed " << seed << (is_scattered ? ", scattered" : ", in balls"));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec3> centers;
    for (int i = 0; i < 3; ++i) centers.push_back({30 * unit(random), 20 * unit(random), 20 * unit(random)});
    std::vector<bool> is_kept;
    for (std::size_t t = 0; t < full.tets.size(); ++t) {
        const Vec3 c = center_of(full, t);
        const bool is_dropped =
            std::any_of(centers.begin(), centers.end(), [&](const Vec3& o) { return distance(c, o) < 7; });
        is_kept.push_back(is_scattered ? unit(random) < 0.7 : !is_dropped);
    }
    const Mesh before = kept_part(full, is_kept);
    RunContext context;
    const VolumeResult result = fill_solids(part.brep, part.sizing, before, {}, VolumeOptions{}, context);
    CHECK(findings(part.brep, result.mesh) == "");
    check_kept(before, result);
    if (!is_scattered) CHECK(result.report.released_tets < before.tets.size() / 20);
}

TEST_CASE("kept tets that hold all nodes of a flat cavity are released, and filled anew") {
    const Part part = prepare(box_part({0, 0, 0}, {20, 20, 20}), 4.0);
    Mesh before = fill(part).mesh;
    REQUIRE(change_a_diagonal(before, FaceId(GENERATE(0, 3, 5))));
    RunContext context;
    const VolumeResult result = fill_solids(part.brep, part.sizing, before, {}, VolumeOptions{}, context);
    CHECK(findings(part.brep, result.mesh) == "");
    check_kept(before, result);
    CHECK(result.report.released_tets >= 2);
    CHECK(result.report.released_tets < 20);
}

TEST_CASE("an interface that is nowhere Delaunay is recovered by constraint before all kept tets are released") {
    const double edge = 20;
    const Part part = prepare(box_part({0, 0, 0}, {edge, edge, edge}), 1.5);
    Mesh full = fill(part).mesh;
    for (std::size_t n = 0; n < full.node_count(); ++n) {
        if (full.entities[n].dim < 3) continue;
        Vec3& p = full.points[n];
        const auto wave = [&](double x) { return std::sin(M_PI * x / edge); };
        p.x += 3 * wave(p.x) * wave(p.y) * std::sin(4 * M_PI * p.z / edge);  // shears, with the boundary where it was
    }
    REQUIRE(findings(part.brep, full) == "");
    std::vector<bool> is_kept;
    for (std::size_t t = 0; t < full.tets.size(); ++t)
        is_kept.push_back(distance(center_of(full, t), {10, 10, 10}) > 4);
    const Mesh before = kept_part(full, is_kept);
    RunContext context;
    const VolumeResult result = fill_solids(part.brep, part.sizing, before, {}, VolumeOptions{}, context);
    CHECK(findings(part.brep, result.mesh) == "");
    check_kept(before, result);
    CHECK(result.report.released_tets < before.tets.size() / 4);
}

TEST_CASE("a full mesh is left as it is") {
    const Part part = prepare(two_solids(), 4.0);
    const Mesh full = fill(part).mesh;
    RunContext context;
    const VolumeResult again = fill_solids(part.brep, part.sizing, full, {}, VolumeOptions{}, context);
    CHECK(are_same_bytes(full, again.mesh));
    CHECK(again.report.new_tets == 0);
}

TEST_CASE("active points become nodes where there is room") {
    const Part part = prepare(box_part({0, 0, 0}, {20, 20, 20}), 3.0);
    const std::vector<Vec3> active{{10, 10, 10}, {10.1, 10, 10}, {5, 14, 9}, {0.1, 10, 10}, {40, 10, 10}};
    RunContext context;
    VolumeOptions options;
    options.odt_sweeps = 0;
    const VolumeResult result = fill_solids(part.brep, part.sizing, part.surface, active, options, context);
    CHECK(findings(part.brep, result.mesh) == "");
    const auto is_near = [&](const Vec3& p, double reach) {
        return std::any_of(result.mesh.points.begin(), result.mesh.points.end(),
                           [&](const Vec3& q) { return distance(p, q) < reach; });
    };
    CHECK(is_near(active[0], 1.0));
    CHECK(is_near(active[2], 1.0));
    CHECK_FALSE(is_near(active[4], 1.0));
}

TEST_CASE("an update whose active points are no part of the lattice is no coarser than a full mesh") {
    const Part part = prepare(box_part({0, 0, 0}, {20, 20, 20}), 3.0);
    const VolumeResult full = fill(part);
    const double end = GENERATE(10.0, 20.0);  // active points on one side only, or all over
    std::vector<Vec3> active;
    for (const Vec3& p : std::span(full.mesh.points).subspan(part.surface.node_count()))
        if (p.x < end) active.push_back(p + Vec3{1.1, 0.7, 0.9});
    RunContext context;
    const VolumeResult result = fill_solids(part.brep, part.sizing, part.surface, active, VolumeOptions{}, context);
    CHECK(findings(part.brep, result.mesh) == "");
    CHECK(result.used_active.size() > active.size() / 2);
    CHECK(result.report.new_nodes >= full.report.new_nodes);
    CHECK(measure_quality(result.mesh).mean_radius_ratio > measure_quality(full.mesh).mean_radius_ratio - 0.01);
}

TEST_CASE("the same bytes for any number of threads") {
    const Part part = prepare(touching_cylinders(), 2.5);
    CHECK(are_same_bytes(fill(part, 1).mesh, fill(part, 4).mesh));
    const Part drilled = prepare(drilled_part(), 2.5);
    CHECK(are_same_bytes(fill(drilled, 1).mesh, fill(drilled, 3).mesh));
}

TEST_CASE("sizes are obeyed where they are graded") {
    SizingOptions options;
    options.size = 4;
    options.growth = GENERATE(1.2, 1.3, 1.5);
    options.local.push_back({entity_of(FaceId(std::size_t{0})), GENERATE(1.0, 2.0)});
    INFO("growth " << options.growth << ", local size " << options.local[0].size);
    const Part part = prepare(box_part({0, 0, 0}, {20, 20, 20}), options);
    const VolumeResult result = fill(part);
    CHECK(findings(part.brep, result.mesh) == "");
    std::size_t edges = 0, good = 0;
    for (const auto& tet : result.mesh.tets)
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) {
                const Vec3 &p = result.mesh.point(tet[i]), &q = result.mesh.point(tet[j]);
                const double ratio = distance(p, q) / part.sizing.at((p + q) * 0.5);
                ++edges, good += ratio > 0.7 && ratio < 1.4;
            }
    CHECK(static_cast<double>(good) > 0.9 * static_cast<double>(edges));
    CHECK(measure_quality(result.mesh).mean_radius_ratio > 0.84);
}

TEST_CASE("work stops when it is cancelled") {
    const Part part = prepare(box_part({0, 0, 0}, {20, 20, 20}), 1.0);
    RunContext context;
    context.on_progress = [](std::string_view, double) { return false; };
    CHECK_THROWS_AS(fill_solids(part.brep, part.sizing, part.surface, {}, VolumeOptions{}, context), Cancelled);
}

TEST_CASE("a surface that does not close is refused by the name of its face") {
    Part part = prepare(box_part({0, 0, 0}, {20, 20, 20}), 5.0);
    part.surface.triangles.pop_back();
    const FaceId face = part.surface.triangle_faces.back();
    part.surface.triangle_faces.pop_back();
    part.surface.triangle_numbers.pop_back();
    std::string message;
    try {
        fill(part);
    } catch (const MeshError& error) {
        message = error.what();
    }
    CHECK(message.find(name_of(entity_of(face))) != std::string::npos);
}

TEST_CASE("a solid with faces that share a place in part is refused with their names") {
    TopoDS_Solid both;
    const BRep_Builder builder;
    builder.MakeSolid(both);
    for (const TopoDS_Shape& part : {box_part({0, 0, 0}, {10, 10, 10}), box_part({10, 0, 0}, {10, 10, 20})})
        builder.Add(both, TopExp_Explorer(part, TopAbs_SHELL).Current());
    const Part part = prepare(both, 2.5);
    try {
        fill(part);
        FAIL("not refused");
    } catch (const MeshError& error) {
        INFO(error.what());
        CHECK(std::string(error.what()).find("Face2") != std::string::npos);
        CHECK(std::string(error.what()).find("Face7") != std::string::npos);
        CHECK(std::string(error.what()).find("such as (10, ") != std::string::npos);
    }
}

namespace {

using IsOn = std::function<bool(const Vec3&)>;

TopoDS_Shape open_box() {
    return BRepAlgoAPI_Cut(box_part({0, 0, 0}, {41, 32.8, 4}), box_part({1, 1, 1}, {39, 30.8, 3})).Shape();
}

IsOn plane(double Vec3::*axis, double at) {
    return [=](const Vec3& p) { return std::abs(p.*axis - at) < 1e-6; };
}
IsOn cylinder(double radius) {
    return [=](const Vec3& p) { return std::abs(std::hypot(p.x, p.y) - radius) < 1e-6; };
}

/// Tets with all corners on two opposite walls, and some on one of them only.
std::size_t count_spanning(const Mesh& mesh, const std::vector<std::array<IsOn, 2>>& walls) {
    std::size_t count = 0;
    for (const auto& tet : mesh.tets)
        for (const auto& [a, b] : walls) {
            int only_a = 0, only_b = 0, on_any = 0;
            for (const NodeId n : tet) {
                const bool is_on_a = a(mesh.point(n)), is_on_b = b(mesh.point(n));
                only_a += is_on_a && !is_on_b, only_b += is_on_b && !is_on_a, on_any += is_on_a || is_on_b;
            }
            count += on_any == 4 && only_a > 0 && only_b > 0;
        }
    return count;
}

}  // namespace

TEST_CASE("with two elements across, no tet has its corners on two opposite walls only") {
    const std::vector<std::array<IsOn, 2>> box_walls{{plane(&Vec3::x, 0), plane(&Vec3::x, 1)},
                                                     {plane(&Vec3::x, 40), plane(&Vec3::x, 41)},
                                                     {plane(&Vec3::y, 0), plane(&Vec3::y, 1)},
                                                     {plane(&Vec3::y, 31.8), plane(&Vec3::y, 32.8)},
                                                     {plane(&Vec3::z, 0), plane(&Vec3::z, 1)}};
    const auto [name, shape, size, walls] =
        GENERATE_COPY(table<std::string, TopoDS_Shape, double, std::vector<std::array<IsOn, 2>>>(
            {{"plate", box_part({0, 0, 0}, {20, 24, 3}), 6.0, {{plane(&Vec3::z, 0), plane(&Vec3::z, 3)}}},
             {"tube", tube_part(8, 10), 4.0, {{cylinder(8), cylinder(7)}}},
             {"open box", open_box(), 10.0, box_walls}}));
    INFO(name);
    SizingOptions options;
    options.size = size;
    options.elements_across_gap = 2;
    const Part part = prepare(shape, options);
    VolumeOptions volume_options;
    volume_options.splits_wall_tets = true;
    RunContext context;
    const VolumeResult result = fill_solids(part.brep, part.sizing, part.surface, {}, volume_options, context);
    CHECK(findings(part.brep, result.mesh) == "");
    CHECK(count_spanning(result.mesh, walls) == 0);
    CHECK(measure_quality(result.mesh).min_dihedral > 25);
    options.elements_across_gap = 0;
    const Part coarse = prepare(shape, options);
    const Mesh spanned = fill(coarse).mesh;
    CHECK(spanned.tets.size() < result.mesh.tets.size() / 4);
    CHECK(count_spanning(spanned, walls) > spanned.tets.size() / 4);
    const VolumeResult split = fill_solids(coarse.brep, coarse.sizing, coarse.surface, {}, volume_options, context);
    CHECK(findings(coarse.brep, split.mesh) == "");
    CHECK(count_spanning(split.mesh, walls) == 0);
    CHECK(split.report.split_wall_tets > 0);
}
