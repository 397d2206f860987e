// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Common.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "update/feature_groups.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

RawDocument block_and_cylinder(double x) {
    return PartDocument()
        .box("Block", {0, 0, 0}, {60, 30, 8})
        .cylinder("Boss", {x, 15, 8}, 8, 16)
        .fuse("Part", "Block", "Boss")
        .finish();
}

/// A tube with a step of 0.005 mm around its middle, whose halves have their seams 40 degrees apart.
RawDocument stepped_tube(double wall) {
    gp_Ax2 axes(gp_Pnt(0, 0, 10), gp_Dir(0, 0, 1));
    axes.Rotate(axes.Axis(), 40 * M_PI / 180);
    PartDocument document;
    document.cylinder("Thick", {0, 0, 0}, 14, 10)
        .add("Thin", "Part::Cylinder", BRepPrimAPI_MakeCylinder(axes, 13.995, 10).Shape());
    return document.fuse("Shaft", "Thick", "Thin")
        .cylinder("Bore", {0, 0, 0}, 14 - wall, 20)
        .cut("Part", "Shaft", "Bore")
        .finish();
}

/// A plate with two bosses, whose feet are given.
RawDocument two_bosses(Vec3 a, Vec3 b) {
    PartDocument document;
    document.box("Plate", {0, 0, 0}, {60, 30, 8}).cylinder("A", a, 5, 10).fuse("WithA", "Plate", "A");
    return document.cylinder("B", b, 5, 10).fuse("WithB", "WithA", "B").finish();
}

RawDocument plate_at(Vec3 p) {
    return PartDocument()
        .box("Plate", p, {60, 30, 8})
        .cylinder("Hole", p + Vec3{15, 15, -1}, 4, 10)
        .cut("Part", "Plate", "Hole")
        .finish();
}

Expectation expectation_of(const Brep& brep) {
    Expectation expected;
    for (std::size_t s = 0; s < brep.solid_count(); ++s) expected.solid_volumes.push_back(brep.volume_of(SolidId(s)));
    expected.solids_beside_face = brep.solids_beside_faces();
    return expected;
}

void check_valid(const PartMesh& part) { CHECK(broken_invariants(part.mesh, expectation_of(part.part.brep)).empty()); }

/// Kept nodes and tets have their numbers, their bits (moved by `motion` where one is given) and their corners.
void check_kept(const PartMesh& old, const PartMesh& now) {
    for (std::size_t n = 0; n < now.node_origin.size(); ++n) {
        if (now.node_origin[n] < 0) {
            CHECK(now.mesh.node_numbers[n] >= old.mesh.next_node_number);
            continue;
        }
        const auto o = std::size_t(now.node_origin[n]);
        CHECK(now.mesh.node_numbers[n] == old.mesh.node_numbers[o]);
    }
    for (std::size_t t = 0; t < now.tet_origin.size(); ++t) {
        if (now.tet_origin[t] < 0) continue;
        const auto o = std::size_t(now.tet_origin[t]);
        CHECK(now.mesh.tet_numbers[t] == old.mesh.tet_numbers[o]);
        for (int k = 0; k < 4; ++k) CHECK(now.node_origin[now.mesh.tets[t][k].index()] == old.mesh.tets[o][k].value);
    }
}

bool same_bytes(const Mesh& a, const Mesh& b) {
    return a.points == b.points && a.node_numbers == b.node_numbers && a.tets == b.tets &&
           a.tet_numbers == b.tet_numbers && a.triangles == b.triangles && a.segments == b.segments &&
           a.tet_mids == b.tet_mids;
}

}  // namespace

TEST_CASE("a plate with a hole is meshed") {
    for (int order : {1, 2}) {
        const auto result = meshed(plate_with_hole(20), options_of(2.5, order));
        check_valid(*result.part_mesh);
        CHECK(result.report.tets == result.part_mesh->mesh.tets.size());
        CHECK(result.report.fallbacks.empty());
        CHECK(result.report.quality.min_dihedral > 15);
    }
}

TEST_CASE("a first mesh is numbered from 1 without gaps, triangles, tets, then segments") {
    // Facets are cut while it is meshed, which left gaps.
    const auto part = PartDocument()
                          .box("Plate", {0, 0, 0}, {60, 40, 10})
                          .cylinder("Boss", {20, 20, 10}, 1, 3)
                          .fuse("Part", "Plate", "Boss")
                          .finish();
    for (int order : {1, 2}) {
        const auto mesh = meshed(part, options_of(4, order)).part_mesh->mesh;
        Number next = 1;
        for (const auto* numbers : {&mesh.triangle_numbers, &mesh.tet_numbers, &mesh.segment_numbers})
            for (const Number number : *numbers) CHECK(number == next++);
        CHECK(next == mesh.next_element_number);
        for (std::size_t n = 0; n < mesh.node_count(); ++n) CHECK(mesh.node_numbers[n] == Number(n + 1));
    }
}

TEST_CASE("an update without a change gives the same bytes") {
    const auto old = meshed(plate_with_hole(20), options_of(2.5)).part_mesh;
    const auto now = updated(*old, plate_with_hole(20), options_of(2.5));
    CHECK(same_bytes(old->mesh, now.part_mesh->mesh));
    CHECK(now.report.kept_nodes_share == 1.0);
    CHECK(now.report.kept_tets_share == 1.0);
    CHECK(now.report.fallbacks.empty());
}

TEST_CASE("moving a hole keeps the rest bit for bit") {
    for (int order : {1, 2}) {
        const MeshOptions options = options_of(2, order);
        const auto old = meshed(plate_with_hole(15), options).part_mesh;
        const auto now = updated(*old, plate_with_hole(19), options);
        check_valid(*now.part_mesh);
        check_kept(*old, *now.part_mesh);
        CHECK(now.report.fallbacks.empty());
        CHECK(now.report.kept_nodes_share > 0.4);
        for (std::size_t n = 0; n < now.part_mesh->node_origin.size(); ++n)
            if (now.part_mesh->node_origin[n] >= 0)
                CHECK(now.part_mesh->mesh.points[n] == old->mesh.points[std::size_t(now.part_mesh->node_origin[n])]);
    }
}

TEST_CASE("no number is ever given twice and setting back keeps the kept part") {
    const MeshOptions options = options_of(2.5);
    const auto first = meshed(plate_with_hole(15), options).part_mesh;
    const auto second = updated(*first, plate_with_hole(18), options).part_mesh;
    const auto third = updated(*second, plate_with_hole(15), options).part_mesh;
    check_valid(*third);
    std::map<Number, Vec3> seen;
    for (const auto& state : {first, second, third})
        for (std::size_t n = 0; n < state->mesh.node_count(); ++n) {
            const auto [it, is_new] = seen.emplace(state->mesh.node_numbers[n], state->mesh.points[n]);
            CHECK(it->second == state->mesh.points[n]);
        }
}

TEST_CASE("the nodes of a feature that moved are carried along") {
    const MeshOptions options = options_of(2);
    const auto old = meshed(block_and_cylinder(15), options).part_mesh;
    const auto now = updated(*old, block_and_cylinder(25), options);
    check_valid(*now.part_mesh);
    check_kept(*old, *now.part_mesh);
    REQUIRE(now.report.kept.size() == 2);
    CHECK(now.report.kept[0].tets > 0);
    CHECK(now.report.kept[1].tets > 0);
    CHECK(now.report.kept[1].motion.translation.x == Approx(10));
    const auto in_boss =
        std::count_if(old->mesh.points.begin(), old->mesh.points.end(), [](const Vec3& p) { return p.z > 8.001; });
    CHECK(double(now.report.kept[1].nodes) > 0.6 * double(in_boss));
    CHECK(now.report.fallbacks.empty());
}

TEST_CASE("features that move by motions of their own are each carried by its own") {
    const MeshOptions options = options_of(2);
    const auto old = meshed(two_bosses({12, 15, 8}, {45, 15, 8}), options).part_mesh;
    const auto now = updated(*old, two_bosses({16, 15, 8}, {45, 10, 8}), options);
    check_valid(*now.part_mesh);
    check_kept(*old, *now.part_mesh);
    CHECK(now.report.fallbacks.empty());
    REQUIRE(now.report.kept.size() == 3);
    for (const auto& kept : now.report.kept) CHECK(kept.tets > 100);
    CHECK(now.report.kept_nodes_share > 0.6);
}

TEST_CASE("a whole part that moved is carried as it is") {
    const MeshOptions options = options_of(2);
    const auto old = meshed(plate_at({0, 0, 0}), options).part_mesh;
    const auto now = updated(*old, plate_at({12, -7, 3}), options);
    check_valid(*now.part_mesh);
    check_kept(*old, *now.part_mesh);
    CHECK(now.report.fallbacks.empty());
    CHECK(now.report.kept_tets_share == 1);
}

TEST_CASE("a longer plate and a new hole are updated") {
    const MeshOptions options = options_of(2.5);
    const auto old = meshed(plate_with_hole(15), options).part_mesh;
    const auto longer = updated(*old, plate_with_hole(15, 4, 66), options);
    check_valid(*longer.part_mesh);
    CHECK(longer.report.kept_nodes_share > 0.6);
    const RawDocument drilled = PartDocument()
                                    .box("Plate", {0, 0, 0}, {60, 30, 6})
                                    .cylinder("Hole", {15, 15, -1}, 4, 8)
                                    .cut("Cut", "Plate", "Hole")
                                    .cylinder("Second", {45, 15, -1}, 3, 8)
                                    .cut("Part", "Cut", "Second")
                                    .finish();
    const auto two = updated(*old, drilled, options);
    check_valid(*two.part_mesh);
    CHECK(two.report.kept_nodes_share > 0.4);
    CHECK(two.report.fallbacks.empty());
}

TEST_CASE("what an edit adds is as fine as in a full mesh") {
    const auto block = [](double length) {
        return PartDocument()
            .box("Block", {0, 0, 0}, {length, 30, 20})
            .cylinder("Hole", {12, 15, -1}, 4, 22)
            .cut("Part", "Block", "Hole")
            .finish();
    };
    const MeshOptions options = options_of(2.2);
    const auto longer = updated(*meshed(block(40), options).part_mesh, block(60), options);
    const auto full = meshed(block(60), options);
    CHECK(double(longer.report.tets) < 1.01 * double(full.report.tets));
    CHECK(double(longer.report.tets) > 0.98 * double(full.report.tets));
}

TEST_CASE("the same edit gives the same bytes for any number of threads, live or restored") {
    const MeshOptions options = options_of(2.5);
    const auto one = meshed(plate_with_hole(15), options, 1).part_mesh,
               two = meshed(plate_with_hole(15), options, 2).part_mesh;
    CHECK(same_bytes(one->mesh, two->mesh));
    RunContext context;
    const auto restored = restore_part(one->document, options, one->mesh, context);
    CHECK(same_bytes(updated(*one, plate_with_hole(18), options, 1).part_mesh->mesh,
                     updated(*restored, plate_with_hole(18), options, 2).part_mesh->mesh));
}

TEST_CASE("start positions are told only where they were of use") {
    const auto old = meshed(plate_with_hole(15), options_of(2)).part_mesh;
    const auto now = updated(*old, plate_with_hole(40), options_of(2)).part_mesh;
    CHECK(now->active_points.size() > 0);
    for (const Vec3& p : now->active_points) CHECK(std::hypot(p.x - 40, p.y - 15) > 4);
}

TEST_CASE("another size or order means a full mesh, and the report says so") {
    const auto old = meshed(plate_with_hole(15), options_of(3)).part_mesh;
    for (const double size : {2.0, 2.9}) {
        const auto finer = updated(*old, plate_with_hole(15), options_of(size));
        CHECK(finer.report.kept_nodes_share == 0);
        REQUIRE(finer.report.fallbacks.size() == 1);
        CHECK_THAT(finer.report.fallbacks[0].in_english(), Catch::Matchers::Contains("size"));
        CHECK(finer.report.tets > old->mesh.tets.size());
    }
    const auto curved = updated(*old, plate_with_hole(15), options_of(3, 2));
    CHECK_THAT(curved.report.fallbacks.at(0).in_english(), Catch::Matchers::Contains("order"));
    check_valid(*curved.part_mesh);
}

TEST_CASE("a mesh of another part is not restored") {
    const auto old = meshed(plate_with_hole(15), options_of(3)).part_mesh;
    RunContext context;
    CHECK_THROWS_AS(restore_part(block_and_cylinder(15), options_of(3), old->mesh, context), StateError);
}

TEST_CASE("a mesh with nodes on vertices or edges that there are not is not restored") {
    const auto old = meshed(plate_with_hole(15), options_of(3)).part_mesh;
    RunContext context;
    for (const std::int32_t dim : {0, 1}) {
        Mesh damaged = old->mesh;
        const auto on_it = std::find_if(damaged.entities.begin(), damaged.entities.end(),
                                        [&](const Entity& e) { return e.dim == dim; });
        on_it->index = 1000;
        CHECK_THROWS_AS(restore_part(plate_with_hole(15), options_of(3), damaged, context), StateError);
    }
}

TEST_CASE("a size that is none is refused as what it is") {
    for (const double size : {0.0, -5.0, std::nan("")})
        for (const double ignored : {-1.0, 0.0, 1.0}) {
            MeshOptions options;
            options.sizing.size = size;
            options.ignore_below = ignored;
            RunContext context;
            try {
                mesh_part(plate_with_hole(20), options, context);
                FAIL("it was meshed");
            } catch (const InputError& refusal) {
                CHECK(refusal.message.code() == Code::size_not_positive);
            }
        }
}

TEST_CASE("every tet belongs to a feature") {
    const auto part = meshed(block_and_cylinder(15), options_of(3)).part_mesh;
    RunContext context;
    const auto groups = tets_of_features(*part, context);
    std::map<std::string, std::size_t> sizes;
    for (const auto& [name, tets] : groups) sizes[name] = tets.size();
    CHECK(sizes["Block"] > sizes["Boss"]);
    CHECK(sizes["Block"] + sizes["Boss"] > 0.99 * part->mesh.tets.size());
}

TEST_CASE("a detail much smaller than the size is told of, by its name and size") {
    const auto step = PartDocument()
                          .box("Block", {0, 0, 0}, {60, 30, 8})
                          .box("Step", {20, 10, 8}, {20, 10, 0.02})
                          .fuse("Part", "Block", "Step")
                          .finish();
    const auto is_told = [](const featuremesh::Message& w) {
        return w.in_english().find("Details of the part") != std::string::npos &&
               w.in_english().find("Edge") != std::string::npos &&
               w.in_english().find("(0.02 mm ") != std::string::npos;
    };
    const PartMeshResult thin = meshed(step, options_of(4));
    CHECK(thin.report.quality.min_dihedral < 2);
    CHECK(thin.report.quality.forced_by_cad > 0);
    CHECK(std::any_of(thin.report.warnings.begin(), thin.report.warnings.end(), is_told));
    const PartMeshResult good = meshed(plate_with_hole(30), options_of(4));
    CHECK(std::none_of(good.report.warnings.begin(), good.report.warnings.end(), is_told));
}

TEST_CASE("where tets cannot meet a narrow face with nodes opposite one another, other chains are tried") {
    std::vector<std::size_t> longest;
    for (const auto& [wall, order] : {std::pair(4.0, 1), std::pair(2.0, 2), std::pair(1.0, 1)}) {
        const PartMeshResult result = meshed(stepped_tube(wall), options_of(6, order));
        const Mesh& mesh = result.part_mesh->mesh;
        CHECK(broken_invariants(mesh, expectation_of(result.part_mesh->part.brep)).empty());
        std::map<EdgeId, std::size_t> pieces;
        for (const EdgeId edge : mesh.segment_edges) ++pieces[edge];
        std::size_t most = 0;
        for (const auto& [edge, count] : pieces) most = std::max(most, count);
        longest.push_back(most);
        const auto& warnings = result.report.warnings;
        const bool is_told = std::any_of(warnings.begin(), warnings.end(), [](const featuremesh::Message& w) {
            return w.in_english().find("Meshed finer") != std::string::npos;
        });
        CHECK(is_told == (most > 40));
    }
    CHECK(*std::max_element(longest.begin(), longest.end()) < 20);
    PartDocument document;
    document.cylinder("Disc", {0, 0, 0}, 11.39, 7.85).cylinder("Rim", {0.04, 0, 2.61667}, 11.48, 3.925);
    document.fuse("Rimmed", "Disc", "Rim").cylinder("Boss", {13.3263, 4.6699, 3.925}, 9.3398, 9.85);
    document.fuse("WithBoss", "Rimmed", "Boss").cylinder("Band", {0, 0, 2.61667}, 11.44, 3.925);
    const PartMeshResult rimmed = meshed(document.fuse("Part", "WithBoss", "Band").finish(), options_of(3.2));
    CHECK(broken_invariants(rimmed.part_mesh->mesh, expectation_of(rimmed.part_mesh->part.brep)).empty());
}

TEST_CASE("where 10-node tets would stay folded, the part is meshed finer, and the report says where") {
    // without a sixth of it: round a whole ball go small elements in any case
    const TopoDS_Shape most =
        BRepPrimAPI_MakeSphere(10, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi, std::numbers::pi / 0.6);
    const RawDocument ball = PartDocument().add("Ball", "Part::Sphere", most).finish();
    MeshOptions options = options_of(18, 2);
    options.sizing.elements_per_circle = 0;
    const PartMeshResult result = meshed(ball, options);
    Expectation sides = expectation_of(result.part_mesh->part.brep);
    sides.solid_volumes.clear();  // a few elements make a poor ball
    CHECK(broken_invariants(result.part_mesh->mesh, sides).empty());
    CHECK(result.report.quality.min_scaled_jacobian > 0.199);
    const auto& warnings = result.report.warnings;
    CHECK(std::any_of(warnings.begin(), warnings.end(), [](const featuremesh::Message& w) {
        return w.in_english().find("finer than asked at Face1") != std::string::npos;
    }));
    REQUIRE_FALSE(result.report.rounds.empty());
    CHECK(result.report.rounds.size() <= most_rounds);
    CHECK(result.report.rounds.front().reason == "folded");
    CHECK(result.report.rounds.front().place == std::vector{entity_of(FaceId(0))});
}

TEST_CASE("edges that 10-node tets need shorter make no tets without a volume to speak of") {
    const double height = 5 / std::tan(2 * std::numbers::pi / 180);
    const TopoDS_Shape tip =
        BRepAlgoAPI_Common(BRepPrimAPI_MakeCone(5, 0, height).Shape(),
                           BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0.9 * height), 20, 20, 0.12 * height).Shape())
            .Shape();
    const RawDocument document = PartDocument().add("Tip", "Part::Common", tip).finish();
    const PartMeshResult result = meshed(document, options_of(0.5, 2));
    CHECK(result.report.quality.min_scaled_jacobian > 0.199);
    const Mesh& mesh = result.part_mesh->mesh;
    double least = 1e300;
    for (const auto& [a, b, c, d] : mesh.tets)
        least = std::min(least, signed_volume(mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)));
    CHECK(least > result.part_mesh->part.brep.tolerances().least_volume() / 1.1);
}

TEST_CASE("a solid whose volume a coarse mesh misses is meshed finer, and the report says where") {
    const TopoDS_Shape lens = BRepAlgoAPI_Common(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 10).Shape(),
                                                 BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 19), 10).Shape())
                                  .Shape();
    const double wanted = Brep(lens).volume_of(SolidId(std::size_t{0}));
    MeshOptions options = options_of(5);
    options.sizing.elements_per_circle = 0;
    const PartMeshResult result = meshed(PartDocument().add("Lens", "Part::Common", lens).finish(), options);
    const Mesh& mesh = result.part_mesh->mesh;
    double volume = 0;
    for (const auto& [a, b, c, d] : mesh.tets)
        volume += signed_volume(mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d));
    CHECK(volume == Approx(wanted).epsilon(0.3));
    const auto& warnings = result.report.warnings;
    CHECK(std::any_of(warnings.begin(), warnings.end(), [](const featuremesh::Message& w) {
        return w.in_english().find("finer than asked at Solid1") != std::string::npos;
    }));
    REQUIRE_FALSE(result.report.rounds.empty());
    CHECK(result.report.rounds.front().reason == "cannot follow");
    CHECK(result.report.rounds.front().refusal.in_english().find("The mesh is not valid") == 0);
}

bool is_finer_than_asked(const PartMeshResult& result) {
    const auto& warnings = result.report.warnings;
    return std::any_of(warnings.begin(), warnings.end(), [](const featuremesh::Message& w) {
        return w.in_english().find("finer than asked") != std::string::npos;
    });
}

TEST_CASE("arcs a twentieth of a millimetre apart are meshed at the size") {
    PartDocument document;
    document.cylinder("Disc", {0, 0, 0}, 9.42, 3.52).cylinder("Rim", {0.01, 0, 1.76}, 9.47, 1.76);
    document.fuse("Rimmed", "Disc", "Rim").box("Lug", {5.181, 4.239, -1}, {6.96, 3.57, 5.52});
    document.fuse("WithLug", "Rimmed", "Lug").box("Notch", {8.1012, -4.6158, 1.76}, {3.86, 5.76, 5.52});
    const PartMeshResult result = meshed(document.cut("Part", "WithLug", "Notch").finish(), options_of(2.3));
    CHECK(broken_invariants(result.part_mesh->mesh, expectation_of(result.part_mesh->part.brep)).empty());
    CHECK_FALSE(is_finer_than_asked(result));
}

TEST_CASE("points that recovery adds leave the boundary where they have next to no room, too") {
    PartDocument document;
    document.cylinder("Disc", {0, 0, 0}, 11.07, 7.33).cylinder("Boss", {9.0774, 6.7527, 0}, 9.963, 9.33);
    document.fuse("WithBoss", "Disc", "Boss").box("Slot", {3.6531, 2.6568, -1}, {3, 2.89, 9.33});
    document.cut("Slotted", "WithBoss", "Slot").cylinder("Cap", {7.4169, 2.4354, 3.665}, 12.3984, 9.33);
    const PartMeshResult result = meshed(document.fuse("Part", "Slotted", "Cap").finish(), options_of(1.7));
    CHECK(broken_invariants(result.part_mesh->mesh, expectation_of(result.part_mesh->part.brep)).empty());
}

TEST_CASE("crescents a twentieth of a millimetre thick are meshed, finer until their faces part") {
    PartDocument document;
    document.cylinder("Disc", {0, 0, 0}, 12.26, 7.51).box("Lug", {10.6662, -8.7046, -1}, {6.84, 6.83, 9.51});
    document.fuse("WithLug", "Disc", "Lug").cylinder("Recess", {0.22, 0, 3.755}, 12.45, 3.755);
    const PartMeshResult result = meshed(document.cut("Part", "WithLug", "Recess").finish(), options_of(4.41));
    CHECK(broken_invariants(result.part_mesh->mesh, expectation_of(result.part_mesh->part.brep)).empty());
    CHECK(is_finer_than_asked(result));
}

TEST_CASE("a local size on a face that no longer exists is a warning that names it, in a mesh and in an update") {
    MeshOptions options = options_of(5);
    options.sizing.local = {{entity_of(FaceId(6)), 2}, {entity_of(FaceId(41)), 2}};
    const PartMeshResult drilled = meshed(plate_with_hole(20), options);
    const auto is_named = [](const PartMeshResult& result, const std::string& name) {
        const auto& warnings = result.report.warnings;
        return std::any_of(warnings.begin(), warnings.end(), [&](const featuremesh::Message& w) {
            return w.in_english().find("local size at " + name + " ") != std::string::npos;
        });
    };
    CHECK(is_named(drilled, "Face42"));
    CHECK_FALSE(is_named(drilled, "Face7"));
    const PartMeshResult plain =
        updated(*drilled.part_mesh, PartDocument().box("Part", {0, 0, 0}, {60, 30, 6}).finish(), options);
    CHECK(is_named(plain, "Face7"));
}

TEST_CASE("with two elements across asked, no tet spans the walls of an open box, in either order") {
    const RawDocument document = PartDocument()
                                     .box("Block", {0, 0, 0}, {41, 32.8, 4})
                                     .box("Inside", {1, 1, 1}, {39, 30.8, 4})
                                     .cut("Part", "Block", "Inside")
                                     .finish();
    MeshOptions options;
    options.sizing.size = 10;
    options.sizing.min_size = 0.6;  // where half of a wall is 0.5
    options.sizing.elements_across_gap = 2;
    options.order = GENERATE(1, 2);
    const PartMeshResult result = meshed(document, options);
    const Mesh& mesh = result.part_mesh->mesh;
    CHECK(result.report.volume.split_wall_tets > 0);
    const std::array<std::array<std::pair<double Vec3::*, double>, 2>, 5> walls{{{{{&Vec3::x, 0}, {&Vec3::x, 1}}},
                                                                                 {{{&Vec3::x, 40}, {&Vec3::x, 41}}},
                                                                                 {{{&Vec3::y, 0}, {&Vec3::y, 1}}},
                                                                                 {{{&Vec3::y, 31.8}, {&Vec3::y, 32.8}}},
                                                                                 {{{&Vec3::z, 0}, {&Vec3::z, 1}}}}};
    CHECK(std::none_of(mesh.tets.begin(), mesh.tets.end(), [&](const auto& tet) {
        return std::any_of(walls.begin(), walls.end(), [&](const auto& wall) {
            const auto on = [&](int side) {
                return std::count_if(tet.begin(), tet.end(), [&](NodeId n) {
                    return std::abs(mesh.point(n).*wall[side].first - wall[side].second) < 1e-6;
                });
            };
            return on(0) > 0 && on(1) > 0 && on(0) + on(1) == 4;
        });
    }));
}

TEST_CASE("of the edge lengths of graded meshes nine in ten are within 0.7 and 1.4 of the wanted ones") {
    const RawDocument rod = PartDocument().cylinder("Part", {0, 0, 0}, 2, 30).finish();
    const RawDocument block = PartDocument().box("Part", {0, 0, 0}, {40, 30, 20}).finish();
    const RawDocument drilled = PartDocument()
                                    .box("Block", {0, 0, 0}, {40, 30, 20})
                                    .cylinder("Hole", {15, 12, -1}, 1, 22)
                                    .cut("Part", "Block", "Hole")
                                    .finish();
    const auto with_local = [](double size, Entity entity, double fine) {
        MeshOptions options = options_of(size);
        options.sizing.local = {{entity, fine}};
        return options;
    };
    const std::pair<RawDocument, MeshOptions> graded[] = {
        {rod, options_of(4)},
        {drilled, options_of(3)},
        {block, with_local(4, entity_of(FaceId(0)), 1)},
        {block, with_local(4, entity_of(EdgeId(0)), 0.5)},
        {block, with_local(4, entity_of(VertexId(0)), 0.3)},
    };
    for (std::size_t i = 0; i < std::size(graded); ++i) {
        INFO("part " << i);
        CHECK(meshed(graded[i].first, graded[i].second).report.lengths.share_within > 0.9);
    }
}

TEST_CASE("where the shape alone asks for the edge lengths the global size makes no difference") {
    const RawDocument rod = PartDocument().cylinder("Part", {0, 0, 0}, 2, 30).finish();
    std::vector<double> tets;
    for (const double size : {4.0, 4.8, 5.6, 6.4}) tets.push_back(double(meshed(rod, options_of(size)).report.tets));
    const auto [least, most] = std::minmax_element(tets.begin(), tets.end());
    CHECK(*most < 1.1 * *least);
}

TEST_CASE("a part that is refused with shorter pieces along narrow faces is meshed without, and updated so") {
    const auto warned = [](const PartMeshResult& result) {
        return std::count_if(result.report.warnings.begin(), result.report.warnings.end(),
                             [](const featuremesh::Message& line) {
                                 return line.in_english().starts_with(
                                     "Faces far narrower than the size are meshed at the plain size, since shorter");
                             });
    };
    const auto on_ledge = [](const PartMesh& mesh) { return mesh.sizing.at({30, 30, 8}); };
    RunContext context;
    const MeshOptions options = options_of(3);
    const PartMeshResult fine = meshed(plate_with_ledge(15), options);
    CHECK(warned(fine) == 0);
    CHECK(on_ledge(*fine.part_mesh) == Approx(1.2));
    CHECK(on_ledge(*updated(*fine.part_mesh, plate_with_ledge(17), options).part_mesh) == Approx(1.2));

    MeshOptions few = options;
    few.most_tets = 0.8 * double(fine.report.tets);
    const PartMeshResult plain = meshed(plate_with_ledge(15), few);
    REQUIRE(warned(plain) == 1);
    check_valid(*plain.part_mesh);
    CHECK(on_ledge(*plain.part_mesh) == 3);
    CHECK(plain.report.tets < few.most_tets);
    // with the same options nothing is to be done
    CHECK(updated(*plain.part_mesh, plate_with_ledge(15), few).report.kept_nodes_share == 1);

    // the update stays as it is, also where the shorter pieces would not be refused any more, live or restored
    const auto saved = restore_part(plate_with_ledge(15), plain.part_mesh->options, plain.part_mesh->mesh, context);
    for (const MeshOptions& now : {few, options}) {
        const PartMeshResult live = updated(*plain.part_mesh, plate_with_ledge(17), now);
        CHECK(live.report.fallbacks.empty());
        CHECK(live.report.kept_nodes_share > 0.7);
        CHECK(on_ledge(*live.part_mesh) == 3);
        CHECK(warned(live) == 0);
        CHECK(same_bytes(live.part_mesh->mesh, updated(*saved, plate_with_ledge(17), now).part_mesh->mesh));
    }
    // where nothing stays the mesh is one from scratch
    const RawDocument other = PartDocument()
                                  .box("Plate", {0, 0, 40}, {61, 31, 9})
                                  .box("Top", {0, 0, 49}, {61, 30.7, 7})
                                  .fuse("Stepped", "Plate", "Top")
                                  .cylinder("Hole", {15, 12, 39}, 5, 20)
                                  .cut("Part", "Stepped", "Hole")
                                  .finish();
    const PartMeshResult anew = updated(*plain.part_mesh, other, options);
    REQUIRE(anew.report.fallbacks.size() == 1);
    CHECK_THAT(anew.report.fallbacks[0].in_english(), Catch::Matchers::Contains("no element of the old mesh is clear"));
    CHECK(anew.part_mesh->mesh.points == meshed(other, options).part_mesh->mesh.points);
    // a mesh from scratch tries again
    MeshOptions coarser = options;
    coarser.sizing.size = 3.7;
    CHECK(on_ledge(*updated(*plain.part_mesh, plate_with_ledge(17), coarser).part_mesh) == Approx(1.2));
    few.most_tets = 100;
    CHECK_THROWS_AS(meshed(plate_with_ledge(15), few), InputError);
}
