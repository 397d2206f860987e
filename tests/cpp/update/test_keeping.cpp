// SPDX-License-Identifier: GPL-3.0-or-later
// What an update leaves alone: mid-side nodes, other solids, places where the wanted size stays.
#include <BOPAlgo_Builder.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <map>
#include <vector>

#include "catch.h"
#include "difference/followed_faces.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "update/keep.h"
#include "update/kept_tets.h"

using namespace featuremesh;

namespace {

/// With a hole that asks for shorter edges around it; without one for no radius.
RawDocument pierced_block(double x, double radius) {
    PartDocument document;
    document.box("Block", {0, 0, 0}, {80, 50, 20});
    if (radius > 0) document.cylinder("Hole", {x, 12, -1}, radius, 22).cut("Part", "Block", "Hole");
    return document.finish();
}

RawDocument thick_plate(double x) {
    return PartDocument()
        .box("Plate", {0, 0, 0}, {60, 30, 20})
        .cylinder("Hole", {x, 15, -1}, 4, 22)
        .cut("Part", "Plate", "Hole")
        .finish();
}

/// A disk with a hub, a bore and a bolt hole, of other measures after each edit.
RawDocument flange(int edit) {
    const auto change = [&](int period) { return double((edit * 7) % period) / period; };
    PartDocument document;
    document.cylinder("Disk", {0, 0, 0}, 30, 7)
        .cylinder("Hub", {2 * change(5), 0, 7}, 16 + 2 * change(3), 18)
        .fuse("Body", "Disk", "Hub");
    document.cylinder("Bore", {0, 0, -1}, 11 + change(4), 40).cut("Bored", "Body", "Bore");
    return document.cylinder("Bolt", {24, 3 * change(7), -1}, 2.5, 20).cut("Part", "Bored", "Bolt").finish();
}

TopoDS_Shape together(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    builder.Add(compound, a);
    builder.Add(compound, b);
    return compound;
}

/// A plate with a pocket that leaves a wall of this thickness above the plate's bottom.
RawDocument pocketed_plate(double wall) {
    return PartDocument()
        .box("Plate", {0, 0, 0}, {60, 40, 8})
        .box("Pocket", {15, 10, wall}, {30, 20, 10})
        .cut("Part", "Plate", "Pocket")
        .finish();
}

/// The triangles of a mesh in a plane, by number: the places of their nodes.
std::map<Number, std::vector<Vec3>> triangles_at_height(const Mesh& mesh, double z) {
    std::map<Number, std::vector<Vec3>> found;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::vector<Vec3> places;
        for (const NodeId n : mesh.triangles[t]) places.push_back(mesh.point(n));
        if (mesh.order == 2)
            for (const NodeId n : mesh.triangle_mids[t]) places.push_back(mesh.point(n));
        if (std::all_of(places.begin(), places.end(), [&](const Vec3& p) { return p.z == z; }))
            found[mesh.triangle_numbers[t]] = std::move(places);
    }
    return found;
}

/// Two plates with a hole each, one above the other; the upper one stays.
RawDocument two_plates(double x, double z = 20) {
    PartDocument document;
    document.box("PlateA", {0, 0, 0}, {40, 20, 6}).cylinder("HoleA", {x, 10, -1}, 4, 8).cut("A", "PlateA", "HoleA");
    document.box("PlateB", {0, 0, z}, {40, 20, 6}).cylinder("HoleB", {20, 10, z - 1}, 4, 8).cut("B", "PlateB", "HoleB");
    return document
        .add("Part", "Part::Compound", together(document.shape("A"), document.shape("B")),
             {{"Links", "A", ""}, {"Links", "B", ""}})
        .finish();
}

/// A plate with a hole and another one on it, which moves with the thickness of the first.
RawDocument stacked_plates(double thickness) {
    PartDocument document;
    document.box("PlateA", {0, 0, 0}, {40, 20, thickness})
        .cylinder("HoleA", {12, 10, -1}, 4, thickness + 2)
        .cut("A", "PlateA", "HoleA");
    document.box("PlateB", {0, 0, thickness}, {40, 20, 6})
        .cylinder("HoleB", {26, 10, thickness - 1}, 4, 8)
        .cut("B", "PlateB", "HoleB");
    return document
        .add("Part", "Part::Compound", together(document.shape("A"), document.shape("B")),
             {{"Links", "A", ""}, {"Links", "B", ""}})
        .finish();
}

/// Two blocks that share a face, at x = 20; the first one with a hole near it.
RawDocument glued_blocks(double y) {
    PartDocument document;
    document.box("BlockA", {0, 0, 0}, {20, 30, 10}).cylinder("HoleA", {17, y, -1}, 2, 12).cut("A", "BlockA", "HoleA");
    document.box("B", {20, 0, 0}, {20, 30, 10});
    BOPAlgo_Builder glue;
    glue.AddArgument(document.shape("A"));
    glue.AddArgument(document.shape("B"));
    glue.Perform();
    return document.add("Part", "Part::FeaturePython", glue.Shape(), {{"Objects", "A", ""}, {"Objects", "B", ""}})
        .finish();
}

double volume_of(const Mesh& mesh, std::size_t tet) {
    const auto& [a, b, c, d] = mesh.tets[tet];
    const Vec3 p = mesh.point(a);
    return dot(mesh.point(b) - p, cross(mesh.point(c) - p, mesh.point(d) - p)) / 6;
}

}  // namespace

TEST_CASE("kept 10-node elements keep their mid-side nodes bit for bit") {
    const auto first = meshed(plate_with_hole(20), options_of(2.5, 2));
    const auto second = updated(*first.part_mesh, plate_with_hole(22), options_of(2.5, 2));
    const PartMesh &old = *first.part_mesh, &now = *second.part_mesh;
    std::size_t kept = 0, curved = 0;
    for (std::size_t t = 0; t < now.tet_origin.size(); ++t) {
        if (now.tet_origin[t] < 0) continue;
        ++kept;
        for (int s = 0; s < 6; ++s) {
            const std::size_t was = old.mesh.tet_mids[std::size_t(now.tet_origin[t])][s].index(),
                              is = now.mesh.tet_mids[t][s].index();
            REQUIRE(now.mesh.points[is] == old.mesh.points[was]);
            REQUIRE(now.mesh.node_numbers[is] == old.mesh.node_numbers[was]);
            curved += now.mesh.entities[is].dim < 3;
        }
    }
    CHECK(kept > 0.5 * double(now.mesh.tets.size()));
    CHECK(curved > 100);
}

TEST_CASE("an edit in one solid leaves the mesh of the other alone") {
    const auto first = meshed(two_plates(12), options_of(2.5));
    const auto second = updated(*first.part_mesh, two_plates(15), options_of(2.5));
    const PartMesh& now = *second.part_mesh;
    REQUIRE(now.part.brep.solid_count() == 2);
    CHECK(second.report.fallbacks.empty());
    std::size_t in_second = 0;
    for (std::size_t t = 0; t < now.mesh.tets.size(); ++t) {
        if (now.mesh.point(now.mesh.tets[t][0]).z < 15) continue;
        ++in_second;
        REQUIRE(now.tet_origin[t] >= 0);
    }
    const auto& old = first.part_mesh->mesh;
    CHECK(in_second == std::size_t(std::count_if(old.tets.begin(), old.tets.end(),
                                                 [&](const auto& tet) { return old.point(tet[0]).z > 15; })));
    CHECK(second.report.kept_tets_share < 1);
}

TEST_CASE("an edit in one solid leaves the mesh of another alone, however near that is") {
    for (const double z : {6.0, 7.0}) {  // that of the first one's top, and a little above
        const auto first = meshed(two_plates(12, z), options_of(2.5));
        const auto second = updated(*first.part_mesh, two_plates(15, z), options_of(2.5));
        const PartMesh& now = *second.part_mesh;
        CHECK(second.report.fallbacks.empty());
        std::size_t released = 0;
        for (std::size_t t = 0; t < now.mesh.tets.size(); ++t) {
            const auto& [a, b, c, d] = now.mesh.tets[t];
            const double middle =
                (now.mesh.point(a).z + now.mesh.point(b).z + now.mesh.point(c).z + now.mesh.point(d).z) / 4;
            released += middle > 0.5 * (6 + z) && now.tet_origin[t] < 0;
        }
        CHECK(released == 0);
        CHECK(second.report.kept_tets_share < 0.95);
    }
}

namespace {
RawDocument overlapping(double hole, double height, double x = 5) {
    PartDocument document;
    document.box("Block", {0, 0, 0}, {40, 30, 10}).cylinder("Hole", {hole, 25, -1}, 2, 12).cut("A", "Block", "Hole");
    document.box("B", {x, 2, 1}, {30, 16, height});
    return document
        .add("Part", "Part::Compound", together(document.shape("A"), document.shape("B")),
             {{"Links", "A", ""}, {"Links", "B", ""}})
        .finish();
}
}  // namespace

TEST_CASE("where solids overlap each keeps the tets that it had") {
    for (const double height : {12.0, 14.0}) {  // the second solid is left alone, or changed
        const auto first = meshed(overlapping(10, 12), options_of(2.5));
        const auto second = updated(*first.part_mesh, overlapping(12, height), options_of(2.5));
        const PartMesh& now = *second.part_mesh;
        CHECK(second.report.fallbacks.empty());
        CHECK(second.report.kept_tets_share > 0.5);
        const Mesh& old = first.part_mesh->mesh;
        std::array<double, 2> volumes{};
        for (std::size_t t = 0; t < now.mesh.tets.size(); ++t) {
            volumes[now.mesh.tet_solids[t].index()] += volume_of(now.mesh, t);
            if (now.tet_origin[t] >= 0)
                REQUIRE(now.mesh.tet_solids[t] == old.tet_solids[std::size_t(now.tet_origin[t])]);
        }
        CHECK(volumes[1] == Approx(30 * 16 * height));
    }
}

TEST_CASE("a solid that moves as a whole leaves one that it overlaps alone") {
    for (const int order : {1, 2}) {
        const auto first = meshed(overlapping(10, 12), options_of(3, order));
        const auto second = updated(*first.part_mesh, overlapping(10, 12, 8), options_of(3, order));
        CHECK(second.report.fallbacks.empty());
        CHECK(second.report.kept_nodes_share == 1);
        CHECK(second.report.kept_tets_share == 1);
    }
}

TEST_CASE("solids with faces and edges in one place keep their own") {
    const auto coinciding = [](double hole, bool is_first) {
        PartDocument document;
        document.box("Block", {0, 0, 0}, {40, 30, 10})
            .cylinder("Hole", {10, 15, -1}, hole, 12)
            .cut("A", "Block", "Hole");
        document.box("B", {0, 0, 0}, {40, 30, 10});
        const std::string one = is_first ? "A" : "B", other = is_first ? "B" : "A";
        return document
            .add("Part", "Part::Compound", together(document.shape(one), document.shape(other)),
                 {{"Links", one, ""}, {"Links", other, ""}})
            .finish();
    };
    for (const bool is_first : {true, false}) {  // the solid that changes
        const auto first = meshed(coinciding(3, is_first), options_of(2.5));
        const auto second = updated(*first.part_mesh, coinciding(4, is_first), options_of(2.5));
        const PartMesh& now = *second.part_mesh;
        CHECK(second.report.fallbacks.empty());
        CHECK(second.report.kept_nodes_share > 0.6);
        for (std::size_t t = 0; t < now.mesh.tets.size(); ++t)
            if (now.tet_origin[t] >= 0)
                REQUIRE(now.mesh.tet_solids[t] == first.part_mesh->mesh.tet_solids[std::size_t(now.tet_origin[t])]);
    }
}

TEST_CASE("a solid that moves as a whole takes its mesh along, though it lies on one that changes") {
    for (const int order : {1, 2}) {
        const auto first = meshed(stacked_plates(6), options_of(2.5, order));
        const auto second = updated(*first.part_mesh, stacked_plates(8), options_of(2.5, order));
        const Mesh &old = first.part_mesh->mesh, &now = second.part_mesh->mesh;
        CHECK(second.report.fallbacks.empty());
        std::size_t released = 0, carried = 0;
        for (std::size_t t = 0; t < now.tets.size(); ++t) {
            if (now.tet_solids[t] != SolidId(1)) continue;
            const std::int32_t was = second.part_mesh->tet_origin[t];
            ++(was < 0 ? released : carried);
            if (was < 0) continue;
            for (int k = 0; k < 4; ++k) {
                const NodeId before = old.tets[std::size_t(was)][std::size_t(k)], after = now.tets[t][std::size_t(k)];
                CHECK(now.node_numbers[after.index()] == old.node_numbers[before.index()]);
                CHECK(distance(now.point(after), old.point(before) + Vec3{0, 0, 2}) < 1e-9);
            }
        }
        CHECK(released == 0);
        CHECK(carried == std::size_t(std::count(old.tet_solids.begin(), old.tet_solids.end(), SolidId(1))));
        CHECK(second.report.kept_tets_share < 0.95);
    }
}

TEST_CASE("a face stays divided as it was, however near behind it the wall changes") {
    const int order = GENERATE(1, 2);
    const double wall = GENERATE(1.3, 1.8);
    const auto first = meshed(pocketed_plate(1.5), options_of(2, order));
    const auto second = updated(*first.part_mesh, pocketed_plate(wall), options_of(2, order));
    CHECK(second.report.fallbacks.empty());
    const Mesh &old = first.part_mesh->mesh, &now = second.part_mesh->mesh;
    const auto was = triangles_at_height(old, 0), is = triangles_at_height(now, 0);
    CHECK(was.size() > 300);
    CHECK(is.size() == was.size());
    // few nodes have moved for the worst angle of their tets: their triangles have new numbers
    std::size_t left = 0;
    for (const auto& [number, places] : is) {
        left += was.contains(number);
        CHECK((was.contains(number) ? was.at(number) == places : number >= old.next_element_number));
    }
    CHECK(double(left) > 0.9 * double(was.size()));
    // their tets go all the same, and no node that stays is left without an element
    CHECK(second.report.kept_tets_share < 0.9);
    std::vector<char> is_used(now.node_count(), 0);
    for (const auto& tet : now.tets)
        for (const NodeId n : tet) is_used[n.index()] = 1;
    CHECK(std::count(is_used.begin(), is_used.begin() + std::ptrdiff_t(now.corner_count), 0) == 0);
}

TEST_CASE("triangles near a change of their own face go, on another face they stay") {
    const auto plate = [](double depth) {
        return PartDocument()
            .box("Plate", {0, 0, 0}, {60, 30, 2})
            .cylinder("Hole", {20, 15, 2 - depth}, 4, 5)
            .cut("Part", "Plate", "Hole")
            .finish();
    };
    const auto first = meshed(plate(1.0), options_of(3));
    const auto through = updated(*first.part_mesh, plate(4.0), options_of(3));
    const auto top = triangles_at_height(first.part_mesh->mesh, 2),
               top_now = triangles_at_height(through.part_mesh->mesh, 2);
    CHECK(top.size() == top_now.size());
    const auto was = triangles_at_height(first.part_mesh->mesh, 0),
               is = triangles_at_height(through.part_mesh->mesh, 0);
    std::size_t left = 0, near = 0;
    for (const auto& [number, places] : was) {
        const Vec3 from_axis = (places[0] + places[1] + places[2]) / 3 - Vec3{20, 15, 0};
        left += is.contains(number);
        near += is.contains(number) && length(from_axis) < 5;
    }
    CHECK(near == 0);
    CHECK(left > was.size() / 2);
    CHECK(through.report.fallbacks.empty());
}

TEST_CASE("faces of solids that lie on one another are followed each by itself") {
    RunContext context;
    const PartState was = read_part_to_mesh(stacked_plates(6), context),
                    is = read_part_to_mesh(stacked_plates(8), context);
    for (const FollowedFace& followed : follow_faces(was, {}, is, {})) {
        REQUIRE(followed.new_faces.size() == 1);
        const auto solid_of = [](const PartState& part, FaceId f) {
            const auto solids = part.brep.solids_beside(f);
            return solids[0].is_valid() ? solids[0] : solids[1];
        };
        CHECK(solid_of(is, followed.new_faces[0]) == solid_of(was, followed.old_face));
    }
}

TEST_CASE("an edit in one solid leaves the mesh of one that shares a face with it alone") {
    const auto first = meshed(glued_blocks(12), options_of(2.5));
    const auto second = updated(*first.part_mesh, glued_blocks(15), options_of(2.5));
    const PartMesh& now = *second.part_mesh;
    REQUIRE(now.part.brep.solid_count() == 2);
    CHECK(second.report.fallbacks.empty());
    std::size_t released = 0, kept = 0;
    for (std::size_t t = 0; t < now.mesh.tets.size(); ++t) {
        const auto& [a, b, c, d] = now.mesh.tets[t];
        if ((now.mesh.point(a) + now.mesh.point(b) + now.mesh.point(c) + now.mesh.point(d)).x < 4 * 20) continue;
        ++(now.tet_origin[t] < 0 ? released : kept);
    }
    CHECK(released == 0);
    CHECK(kept > 500);
    CHECK(second.report.kept_tets_share < 0.9);
}

TEST_CASE("a mesh that is updated again and again stays as fine and as good as a full one") {
    const MeshOptions options = options_of(3);
    auto part = meshed(thick_plate(20), options).part_mesh;
    for (int i = 1; i <= 24; ++i) part = updated(*part, thick_plate(20 + 0.8 * (i % 7)), options).part_mesh;
    const auto last = updated(*part, thick_plate(20), options);
    const auto full = meshed(thick_plate(20), options);
    CHECK(last.report.quality.mean_radius_ratio > full.report.quality.mean_radius_ratio - 0.01);
    CHECK(double(last.report.tets) > 0.96 * double(full.report.tets));
    CHECK(double(last.report.tets) < 1.06 * double(full.report.tets));
}

TEST_CASE("where sizes are graded, edits in a row leave the mean quality where it is") {
    const MeshOptions options = options_of(GENERATE(5.0, 4.0));
    auto part = meshed(flange(0), options).part_mesh;
    double drift = 0, tets = 0;
    const int edits = 20;
    for (int i = 1; i <= edits; ++i) {
        const auto update = updated(*part, flange(i), options);
        const auto full = meshed(flange(i), options).report;
        CHECK(update.report.fallbacks.empty());
        drift += (update.report.quality.mean_radius_ratio - full.quality.mean_radius_ratio) / edits;
        tets += double(update.report.tets) / double(full.tets) / edits;
        part = update.part_mesh;
    }
    CHECK(drift > -0.003);
    CHECK(tets == Approx(1).margin(0.06));
}

TEST_CASE("a small mesh keeps its mean quality over fifty edits") {
    const MeshOptions options = options_of(GENERATE(6.5, 5.5, 4.5));
    auto part = meshed(thick_plate(20), options).part_mesh;
    double drift = 0;
    const int edits = 50, looks = 10;
    for (int i = 1; i <= edits; ++i) {
        const RawDocument edited = thick_plate(12 + 4.4 * (i % 7) + 0.1 * i);
        const auto update = updated(*part, edited, options);
        CHECK(update.report.fallbacks.empty());
        if (i % (edits / looks) == 0)
            drift +=
                (update.report.quality.mean_radius_ratio - meshed(edited, options).report.quality.mean_radius_ratio) /
                looks;
        part = update.part_mesh;
    }
    CHECK(drift > -0.007);
}

TEST_CASE("holes that come and go with their short edges leave the mean quality where it is") {
    const MeshOptions options = options_of(5);
    const double radius = 2.5;
    auto part = meshed(pierced_block(12, radius), options).part_mesh;
    double drift = 0, worst = 1;
    const int edits = 24;
    for (int i = 1; i <= edits; ++i) {
        const RawDocument edited = pierced_block(12 + (i * 17) % 55, i % 2 ? 0 : radius);
        const auto update = updated(*part, edited, options);
        const double full = meshed(edited, options).report.quality.mean_radius_ratio;
        drift += (update.report.quality.mean_radius_ratio - full) / edits;
        worst = std::min(worst, update.report.quality.mean_radius_ratio - full);
        part = update.part_mesh;
    }
    CAPTURE(drift);
    CHECK(drift > -0.003);
    CHECK(worst > -0.01);
}

TEST_CASE("of a star that would keep few of its tets beside nodes that go for their size nothing is kept") {
    const auto part = meshed(thick_plate(20), options_of(4)).part_mesh;
    const Mesh& mesh = part->mesh;
    const auto has = [](const auto& tet, NodeId n) { return std::find(tet.begin(), tet.end(), n) != tet.end(); };
    NodeId middle;
    std::vector<std::size_t> star;
    for (std::size_t n = 0; n < mesh.node_count() && star.empty(); ++n) {
        middle = NodeId(n);
        bool is_inside = true;
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            if (!has(mesh.tets[t], middle)) continue;
            star.push_back(t);
            for (const NodeId corner : mesh.tets[t]) is_inside &= mesh.entities[corner.index()].dim == 3;
        }
        if (!is_inside) star.clear();
    }
    REQUIRE(star.size() > 10);
    // all nodes around the middle go but those of one of its tets
    const auto& left = mesh.tets[star.front()];
    std::vector<std::int32_t> motions(mesh.node_count(), 0);
    std::vector<char> is_resized(mesh.node_count(), 0);
    for (const std::size_t t : star)
        for (const NodeId n : mesh.tets[t])
            if (!has(left, n)) motions[n.index()] = dropped, is_resized[n.index()] = 1;
    const std::vector<CarriedRegion> regions(1);
    const Brep& brep = part->part.brep;
    const KeptTets all(mesh, motions, regions, brep, brep);
    CHECK(all.is_kept(star.front()));
    const KeptTets tets(mesh, motions, regions, brep, brep, {}, {}, is_resized);
    CHECK(!tets.is_kept(star.front()));
    CHECK(!tets.has_kept_tet(middle.index()));
    CHECK(tets.is_rim(left[0].index()));
}

TEST_CASE("tets at the interface are as good as elsewhere after every update") {
    const int order = GENERATE(1, 2);
    MeshOptions options = options_of(3, order);
    options.keep_margin = 0.65;  // nearer than good tets need, so that there is something to mend
    auto part = meshed(thick_plate(20), options).part_mesh;
    double worst = 0;
    std::size_t released = 0;
    for (int i = 1; i <= (order == 1 ? 24 : 12); ++i) {
        const RawDocument edited = thick_plate(20 + 0.8 * (i % 7));
        const auto update = updated(*part, edited, options);
        const double full = meshed(edited, options).report.quality.min_dihedral;
        worst = std::max(worst, full - update.report.quality.min_dihedral);
        released += update.report.volume.released_for_quality;
        CHECK(update.report.fallbacks.empty());
        part = update.part_mesh;
    }
    CHECK(worst < 1);
    CHECK(released > 0);
    CHECK(released < 200);
}

TEST_CASE("where only the mid-side node of an edge's piece is near a change, the piece is made anew") {
    const auto part = [](double x, double y) {
        return PartDocument()
            .box("Plate", {0, 0, 0}, {60, 30, 6})
            .cylinder("Hole", {x, y, -1}, 0.3, 8)
            .cut("Part", "Plate", "Hole")
            .finish();
    };
    MeshOptions options;
    options.sizing.size = 2;
    options.sizing.elements_per_circle = 0;
    options.keep_margin = 0.5;
    options.order = 2;
    RunContext context;
    const auto old = mesh_part(part(45, 15), options, context).part_mesh;
    // the nodes of the edge are at even places, further from the hole than the margin; half way between them it is near
    const double y = GENERATE(1.0, 1.1, 1.2, 1.3);
    INFO("hole at y = " << y);
    const PartMeshResult result = update_part(*old, part(21, y), options, context);
    CHECK(result.report.fallbacks.empty());
    const Mesh& mesh = result.part_mesh->mesh;
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        const Vec3 &a = mesh.point(mesh.segments[s][0]), &b = mesh.point(mesh.segments[s][1]);
        CHECK(distance(0.5 * (a + b), mesh.point(mesh.segment_mids[s])) < 0.3 * distance(a, b));
    }
}

TEST_CASE("where faces and edges run the other way than before all stays, and every triangle is turned with its face") {
    const TopoDS_Shape pocket = BRepPrimAPI_MakeBox(gp_Pnt(7, 3, 2), 6, 4, 5).Shape(),
                       block = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 10, 5).Shape(), pocket).Shape();
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(10, 0, 0), gp::DX()));
    const TopoDS_Shape mirrored = BRepBuilderAPI_Transform(block, mirror, true).Shape();
    const auto document_of = [](const TopoDS_Shape& shape) {
        return PartDocument().add("Part", "Part::Feature", shape).finish();
    };
    for (const int order : {1, 2}) {
        const auto first = meshed(document_of(block), options_of(2, order));
        const auto second = updated(*first.part_mesh, document_of(mirrored), options_of(2, order));
        CHECK(second.report.fallbacks.empty());
        CHECK(second.report.kept_tets_share == 1);
        CHECK(second.report.kept_nodes_share == 1);
        CHECK(second.report.triangles == first.report.triangles);
        CHECK(second.part_mesh->mesh.triangle_numbers == first.part_mesh->mesh.triangle_numbers);
    }
}

TEST_CASE("where solids that share a face come in the other order, its triangles are turned and stay") {
    const auto glued = [](bool is_turned) {
        std::vector<TopoDS_Shape> blocks{BRepPrimAPI_MakeBox(20, 10, 5).Shape(),
                                         BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 5), 20, 10, 7).Shape()};
        if (is_turned) std::swap(blocks[0], blocks[1]);
        BOPAlgo_Builder glue;
        for (const TopoDS_Shape& block : blocks) glue.AddArgument(block);
        glue.Perform();
        return PartDocument().add("Part", "Part::Feature", glue.Shape()).finish();
    };
    for (const int order : {1, 2}) {
        const auto first = meshed(glued(false), options_of(2, order));
        const auto second = updated(*first.part_mesh, glued(true), options_of(2, order));
        CHECK(second.report.fallbacks.empty());
        CHECK(second.report.kept_tets_share == 1);
        CHECK(second.report.triangles == first.report.triangles);
        CHECK(second.part_mesh->mesh.triangle_numbers == first.part_mesh->mesh.triangle_numbers);
    }
}

TEST_CASE("a kept node whose elements had to go is not left over") {
    const auto pierced = [](double height, double radius) {
        return PartDocument()
            .box("Plate", {0, 0, 0}, {60, 40, height})
            .cylinder("Hole", {20, 20, -1}, radius, height + 2)
            .cut("Part", "Plate", "Hole")
            .finish();
    };
    for (const double margin : {0.9, 1.0, 1.1, 1.2, 1.3})
        for (const double radius : {4.0, 4.5, 5.0}) {
            MeshOptions options = options_of(10, 2);
            options.keep_margin = margin;
            const auto old = meshed(pierced(10, 6), options).part_mesh;
            const auto now = updated(*old, pierced(12, radius), options).part_mesh;
            std::vector<char> is_used(now->mesh.node_count(), 0);
            for (const auto& tet : now->mesh.tets)
                for (const NodeId n : tet) is_used[n.index()] = 1;
            for (const auto& tet : now->mesh.tet_mids)
                for (const NodeId n : tet) is_used[n.index()] = 1;
            CHECK(std::count(is_used.begin(), is_used.end(), 0) == 0);  // 1 of these updates had one
        }
}
