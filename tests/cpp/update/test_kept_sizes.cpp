// SPDX-License-Identifier: GPL-3.0-or-later
// What an update keeps where other sizes are wanted than the old mesh was made for.
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "catch.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "update/keep.h"

using namespace featuremesh;

namespace {

/// The face whose nodes all have this x.
FaceId face_at(const Mesh& mesh, double x) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& n = mesh.triangles[t];
        if (std::all_of(n.begin(), n.end(), [&](NodeId i) { return std::abs(mesh.point(i).x - x) < 1e-9; }))
            return mesh.triangle_faces[t];
    }
    return {};
}

/// Share of the new tets that are kept, by whether their first node is nearer than `limit` to x = 60.
std::array<double, 2> kept_near_and_far(const PartMesh& part, double limit) {
    std::array<double, 2> all{}, kept{};
    for (std::size_t t = 0; t < part.mesh.tets.size(); ++t) {
        const std::size_t side = 60 - part.mesh.point(part.mesh.tets[t][0]).x > limit;
        ++all[side];
        kept[side] += part.tet_origin[t] >= 0;
    }
    return {kept[0] / all[0], kept[1] / all[1]};
}

/// Two plates of 40 x 20 x 6, one above the other.
RawDocument two_plates() {
    PartDocument document;
    document.box("Lower", {0, 0, 0}, {40, 20, 6}).box("Upper", {0, 0, 20}, {40, 20, 6});
    TopoDS_Compound both;
    BRep_Builder().MakeCompound(both);
    for (const char* name : {"Lower", "Upper"}) BRep_Builder().Add(both, document.shape(name));
    return document.add("Part", "Part::Compound", both, {{"Links", "Lower", ""}, {"Links", "Upper", ""}}).finish();
}

}  // namespace

TEST_CASE("another local size releases what was made for the one before, however little it differs") {
    MeshOptions options = options_of(3);
    const auto plain = meshed(plate_with_hole(20), options);
    const FaceId end = face_at(plain.part_mesh->mesh, 60);
    REQUIRE(end.is_valid());
    options.sizing.local = {{entity_of(end), 1.0}};
    const auto first = meshed(plate_with_hole(20), options);

    std::size_t least = first.part_mesh->mesh.tets.size();
    for (const double size : {1.1, 1.6}) {
        options.sizing.local = {{entity_of(end), size}};
        const auto coarser = updated(*first.part_mesh, plate_with_hole(20), options);
        CHECK(coarser.report.fallbacks.empty());
        CHECK(kept_near_and_far(*coarser.part_mesh, 2)[0] < 0.2);
        CHECK(kept_near_and_far(*coarser.part_mesh, 15)[1] > 0.95);
        CHECK(coarser.part_mesh->mesh.tets.size() < least);
        least = coarser.part_mesh->mesh.tets.size();
    }
}

TEST_CASE("the same lengths at faces of other numbers are no other wish") {
    SizingOptions before;
    before.size = 3;
    before.local = {{entity_of(FaceId(2)), 1}, {entity_of(FaceId(4)), 2}, {entity_of(FaceId(5)), 2}};
    SizingOptions now = before;
    CHECK(compare_asked_sizes(before, now) == AskedSizes::same);
    now.local = {{entity_of(FaceId(7)), 2}, {entity_of(FaceId(3)), 1}};
    CHECK(compare_asked_sizes(before, now) == AskedSizes::same_lengths);
    now.local[0].size = 2.1;
    CHECK(compare_asked_sizes(before, now) == AskedSizes::other_lengths);
    now = before, now.elements_per_circle += 1;
    CHECK(compare_asked_sizes(before, now) == AskedSizes::other_lengths);
}

TEST_CASE("a local size that changes little by little is followed, saved and restored or not") {
    MeshOptions options = options_of(3);
    const FaceId end = face_at(meshed(plate_with_hole(20), options).part_mesh->mesh, 60);
    options.sizing.local = {{entity_of(end), 1.0}};
    auto live = meshed(plate_with_hole(20), options).part_mesh, restored = live;
    for (int i = 0; i < 10; ++i) {
        options.sizing.local[0].size *= 1.1;
        const auto next = updated(*live, plate_with_hole(20), options);
        CHECK(next.report.kept_tets_share < 1);
        live = next.part_mesh;
        RunContext context;
        const auto saved = updated(*restored, plate_with_hole(20), options).part_mesh;
        restored = restore_part(saved->document, options, saved->mesh, context, saved->made_for);
        REQUIRE(live->mesh.points == restored->mesh.points);
        REQUIRE(live->mesh.tets == restored->mesh.tets);
    }
    const auto full = meshed(plate_with_hole(20), options);
    CHECK(double(live->mesh.tets.size()) < 1.25 * double(full.report.tets));
    CHECK(double(live->mesh.tets.size()) > 0.8 * double(full.report.tets));
}

TEST_CASE("what is carried to where other sizes are wanted gets elements of these") {
    MeshOptions options = options_of(3);
    SizeZone zone;
    zone.shape = BoxZone{{40, 30, 40}};
    zone.inner = 1.2;
    options.sizing.zones = {zone};
    const auto with_boss = [](double x) {
        return PartDocument()
            .box("Plate", {0, 0, 0}, {120, 30, 6})
            .box("Boss", {x, 8, 6}, {14, 14, 20})
            .fuse("Part", "Plate", "Boss")
            .finish();
    };
    for (const auto& [from, to] : {std::pair(10, 90), std::pair(90, 10)}) {
        const auto first = meshed(with_boss(from), options);
        const auto second = updated(*first.part_mesh, with_boss(to), options);
        const auto full = meshed(with_boss(to), options);
        CHECK(second.report.fallbacks.empty());
        CHECK(double(second.report.tets) < 1.05 * double(full.report.tets));
        CHECK(double(second.report.tets) > 0.95 * double(full.report.tets));
    }
}

TEST_CASE("another size at a solid that stayed makes its elements anew, on its surface, too") {
    MeshOptions options = options_of(3);
    const auto first = meshed(two_plates(), options);
    const Brep& brep = first.part_mesh->part.brep;
    options.sizing.local = {{entity_of(SolidId(1)), 1.5}};
    const auto second = updated(*first.part_mesh, two_plates(), options), full = meshed(two_plates(), options);
    const auto triangles_of = [&](const PartMesh& part, SolidId solid) {
        return std::count_if(part.mesh.triangle_faces.begin(), part.mesh.triangle_faces.end(),
                             [&](FaceId face) { return brep.solids_beside(face)[0] == solid; });
    };
    CHECK(triangles_of(*second.part_mesh, SolidId(0)) == triangles_of(*first.part_mesh, SolidId(0)));
    CHECK(double(triangles_of(*second.part_mesh, SolidId(1))) >
          0.95 * double(triangles_of(*full.part_mesh, SolidId(1))));
    CHECK(double(second.report.tets) > 0.95 * double(full.report.tets));
    CHECK(second.report.kept_tets_share > 0);
}

TEST_CASE("a local size is followed, too, where no change of it is worth new elements by itself") {
    MeshOptions options = options_of(4);
    const FaceId end = face_at(meshed(plate_with_hole(20), options).part_mesh->mesh, 60);
    options.sizing.local = {{entity_of(end), 1.5}};
    auto part = meshed(plate_with_hole(20), options).part_mesh;
    for (int i = 0; i < 30; ++i) {
        options.sizing.local[0].size *= 1.009;
        part = updated(*part, plate_with_hole(20), options).part_mesh;
    }
    const auto full = meshed(plate_with_hole(20), options);
    CHECK(double(part->mesh.tets.size()) < 1.15 * double(full.report.tets));
}
