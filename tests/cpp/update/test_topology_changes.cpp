// SPDX-License-Identifier: GPL-3.0-or-later
// Edits that change which faces a part has: each update is valid and keeps what it says it keeps, bit for bit.
#include <BOPAlgo_Builder.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "catch.h"
#include "core/messages.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

bool is_upright(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    const gp_Pnt a = curve.Value(curve.FirstParameter()), b = curve.Value(curve.LastParameter());
    return curve.GetType() == GeomAbs_Line && std::abs(a.Z() - b.Z()) > 1;
}

PartDocument plate() { return PartDocument().box("Plate", {0, 0, 0}, {60, 30, 6}); }

PartDocument& drill(PartDocument& document, const std::string& name, Vec3 foot, double radius,
                    const std::string& base) {
    return document.cylinder(name, foot, radius, 8).cut(name + "Cut", base, name);
}

RawDocument without_hole() { return plate().finish(); }

RawDocument with_hole(double x, double radius = 4) {
    PartDocument document = plate();
    return drill(document, "Hole", {x, 15, -1}, radius, "Plate").finish();
}

RawDocument with_two_holes(double second) {
    PartDocument document = plate();
    drill(document, "Hole", {20, 15, -1}, 4, "Plate");
    return drill(document, "Second", {second, 15, -1}, 4, "HoleCut").finish();
}

RawDocument with_row(int count) {
    PartDocument document = plate();
    std::string base = "Plate";
    for (int i = 0; i < count; ++i) {
        const std::string name = "Hole" + std::to_string(i);
        drill(document, name, {10.0 + 12 * i, 15, -1}, 3, base);
        base = name + "Cut";
    }
    return document.finish();
}

/// The plate with its upright edges rounded; 0 for none.
RawDocument with_fillet(double radius) {
    PartDocument document = plate();
    drill(document, "Hole", {20, 15, -1}, 4, "Plate");
    if (radius == 0) return document.finish();
    BRepFilletAPI_MakeFillet fillet(document.shape("HoleCut"));
    for (TopExp_Explorer it(document.shape("HoleCut"), TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current());
        const gp_Pnt corner = BRepAdaptor_Curve(edge).Value(BRepAdaptor_Curve(edge).FirstParameter());
        if (is_upright(edge) && (corner.X() < 1 || corner.X() > 59) && fillet.Contour(edge) == 0)
            fillet.Add(radius, edge);
    }
    return document.add("Fillet", "Part::Fillet", fillet.Shape(), {{"Base", "HoleCut", ""}}).finish();
}

/// Two pockets in the plate, and a third that joins them.
RawDocument with_pockets(bool joined) {
    PartDocument document = plate();
    document.box("Left", {10, 10, 3}, {10, 10, 4}).cut("LeftCut", "Plate", "Left");
    document.box("Right", {34, 10, 3}, {10, 10, 4}).cut("RightCut", "LeftCut", "Right");
    if (joined) document.box("Joint", {19, 12, 3}, {16, 6, 4}).cut("JointCut", "RightCut", "Joint");
    return document.finish();
}

/// The plate with a groove round the middle of its top.
RawDocument with_ring() {
    PartDocument document = plate();
    document.cylinder("Outer", {30, 15, 3}, 12, 4).cylinder("Inner", {30, 15, 3}, 10, 4).cut("Ring", "Outer", "Inner");
    return document.cut("Part", "Plate", "Ring").finish();
}

/// The plate with a trench of this depth across its middle; 0 for none, 6 and more cut it in two.
RawDocument with_trench(double depth) {
    if (depth == 0) return without_hole();
    return plate().box("Trench", {27, -1, 6 - depth}, {6, 32, depth + 1}).cut("Part", "Plate", "Trench").finish();
}

/// The plate with a counterbored hole, whose narrow ledge a slot may cut into pieces.
RawDocument with_ledge(bool cut) {
    PartDocument document = plate();
    drill(document, "Hole", {30, 15, -1}, 8, "Plate");
    document.cylinder("Bore", {30, 15, 5}, 8.2, 3).cut("BoreCut", "HoleCut", "Bore");
    if (cut) document.box("Slot", {10, 14.5, 4}, {40, 1, 4}).cut("SlotCut", "BoreCut", "Slot");
    return document.finish();
}

/// The plate with a feature that rounds its upright edges, and that may be suppressed.
RawDocument with_switched_fillet(bool suppressed) {
    RawDocument document = with_fillet(5);
    if (!suppressed) return document;
    document.records.back().suppressed = true;
    document.records.back().shape =
        document.records[document.records.size() - 2].shape;  // what is left is the shape before it
    return document;
}

/// The plate with a conical void, whose tip touches the top from within at a height of 6.
RawDocument with_tip(double x, double height) {
    PartDocument document = plate();
    const gp_Ax2 axis(gp_Pnt(x, 15, 0), gp::DZ());
    document.add("Tip", "Part::Cone", BRepPrimAPI_MakeCone(axis, 4, 0, height).Shape());
    return document.cut("TipCut", "Plate", "Tip").finish();
}

/// The plate with a solid cone on it that stands on its tip.
RawDocument under_tip(double x, double height = 8) {
    PartDocument document = plate();
    const gp_Ax2 axis(gp_Pnt(x, 15, 6), gp::DZ());
    document.add("Tip", "Part::Cone", BRepPrimAPI_MakeCone(axis, 0, 4, height).Shape());
    return document.fuse("TipFuse", "Plate", "Tip").finish();
}

/// Two blocks that touch along an edge. A long one on top of both makes them one solid, a short one does not.
RawDocument with_bridge(double length) {
    return PartDocument()
        .box("One", {0, 0, 0}, {30, 20, 10})
        .box("Other", {30, 20, 0}, {30, 20, 10})
        .fuse("Both", "One", "Other")
        .box("Bridge", {15, 15, 10}, {length, 10, 4})
        .fuse("Bridged", "Both", "Bridge")
        .finish();
}

/// A block, and another beside or on it, that share a face, or only touch there.
RawDocument touching(Vec3 low, Vec3 size, bool is_joined) {
    PartDocument document;
    document.box("One", {0, 0, 0}, {20, 30, 10}).box("Other", low, size);
    BOPAlgo_Builder glue;
    TopoDS_Compound apart;
    BRep_Builder().MakeCompound(apart);
    for (const std::string name : {"One", "Other"}) {
        glue.AddArgument(document.shape(name));
        BRep_Builder().Add(apart, document.shape(name));
    }
    glue.Perform();
    return document.add("Part", "Part::FeaturePython", is_joined ? glue.Shape() : apart).finish();
}

PartMeshResult meshed(const RawDocument& document, double size = 2.5) {
    MeshOptions options;
    options.sizing.size = size;
    options.ignore_below = 0;
    RunContext context;
    return mesh_part(document, options, context);
}

/// Triangles stay with the tets behind them: those that do not are without a tet.
bool kept_triangles_are_there(const Mesh& old, const PartMesh& now) {
    std::set<Number> numbers(now.mesh.triangle_numbers.begin(), now.mesh.triangle_numbers.end());
    std::set<std::array<NodeId, 3>> kept_sides;
    for (const std::int32_t o : now.tet_origin)
        for (int k = 0; k < 4 && o >= 0; ++k) {
            const auto& tet = old.tets[std::size_t(o)];
            std::array<NodeId, 3> side{tet[k == 0 ? 3 : 0], tet[k == 1 ? 3 : 1], tet[k == 2 ? 3 : 2]};
            std::sort(side.begin(), side.end());
            kept_sides.insert(side);
        }
    for (std::size_t t = 0; t < old.triangles.size(); ++t) {
        auto side = old.triangles[t];
        std::sort(side.begin(), side.end());
        if (kept_sides.contains(side) && !numbers.contains(old.triangle_numbers[t])) return false;
    }
    return true;
}

/// Updates, checks everything that must hold of any update, and gives the share of nodes kept.
double kept_after(const PartMesh& old, const RawDocument& document, double least_angle) {
    RunContext context;
    const PartMeshResult result = update_part(old, document, old.options, context);
    const PartMesh& now = *result.part_mesh;
    Expectation expected;
    for (std::size_t s = 0; s < now.part.brep.solid_count(); ++s)
        expected.solid_volumes.push_back(now.part.brep.volume_of(SolidId(s)));
    expected.solids_beside_face = now.part.brep.solids_beside_faces();
    CHECK(several(broken_invariants(now.mesh, expected)).in_english() == "");
    CHECK(several(result.report.fallbacks).in_english().empty());
    std::size_t wrong = 0;
    for (std::size_t n = 0; n < now.node_origin.size(); ++n) {
        if (now.node_origin[n] < 0) continue;
        const auto o = std::size_t(now.node_origin[n]);
        wrong += now.mesh.node_numbers[n] != old.mesh.node_numbers[o] || now.mesh.points[n] != old.mesh.points[o];
    }
    CHECK(wrong == 0);
    CHECK(kept_triangles_are_there(old.mesh, now));
    CHECK(result.report.quality.min_dihedral > least_angle);
    return result.report.kept_nodes_share;
}

void check_there_and_back(const RawDocument& one, const RawDocument& other, double at_least, double least_angle = 15) {
    const auto first = meshed(one).part_mesh, second = meshed(other).part_mesh;
    CHECK(kept_after(*first, other, least_angle) > at_least);
    CHECK(kept_after(*second, one, least_angle) > at_least);
}

}  // namespace

TEST_CASE("a hole appears and vanishes") { check_there_and_back(without_hole(), with_hole(20), 0.5); }

TEST_CASE("a hole breaks through a side and comes back") {
    PartDocument document = plate();
    const RawDocument notched = drill(document, "Hole", {20, 28, -1}, 4, "Plate").finish();
    check_there_and_back(with_hole(20), notched, 0.4);
}

TEST_CASE("two holes merge and part") { check_there_and_back(with_two_holes(34), with_two_holes(26), 0.5); }

TEST_CASE("a fillet is added, enlarged and removed") {
    check_there_and_back(with_fillet(0), with_fillet(4), 0.5);
    check_there_and_back(with_fillet(4), with_fillet(6), 0.5);
}

TEST_CASE("a row of holes grows and shrinks") { check_there_and_back(with_row(3), with_row(4), 0.6); }

TEST_CASE("a trench cuts the part in two, and it is joined again") {
    check_there_and_back(with_trench(3), with_trench(8), 0.5);
    check_there_and_back(with_trench(0), with_trench(8), 0.5);
}

TEST_CASE("two blocks that touch along an edge are joined by a third, and parted") {
    check_there_and_back(with_bridge(20), with_bridge(10), 0.5);
}

TEST_CASE("two blocks side by side come to share the face at which they touch, and part") {
    const auto side_by_side = [](bool is_joined) { return touching({20, 0, 0}, {20, 30, 10}, is_joined); };
    check_there_and_back(side_by_side(false), side_by_side(true), 0.5);
}

TEST_CASE("a block on another, flush with its side, comes to share a face with it, and they part") {
    const auto flush = [](bool is_joined) { return touching({4.3, 0, 10}, {9, 12, 6}, is_joined); };
    check_there_and_back(flush(false), flush(true), 0.5);
}

TEST_CASE(
    "a block whose corner lies beside another's edge, nearer than what is ignored, comes to share a face with it") {
    const auto beside = [](bool is_joined) { return touching({20, 0, 0.0016}, {8, 8.777, 8}, is_joined); };
    check_there_and_back(beside(false), beside(true), 0.5);
}

TEST_CASE("two pockets are joined by a third, and parted") {
    check_there_and_back(with_pockets(false), with_pockets(true), 0.5);
}

TEST_CASE("a ring cuts a face into a frame and an island") { check_there_and_back(without_hole(), with_ring(), 0.3); }

TEST_CASE("a tip that touches a face moves along it and comes off") {
    check_there_and_back(with_tip(20, 6), with_tip(24, 6), 0.5);
    check_there_and_back(with_tip(20, 6), with_tip(20, 4), 0.5);
    check_there_and_back(under_tip(20), under_tip(24, 9), 0.5);
    check_there_and_back(under_tip(20), without_hole(), 0.4);
}

TEST_CASE("a slot cuts a face into pieces that are narrower than the bulge of their arcs") {
    check_there_and_back(with_ledge(false), with_ledge(true), 0.3, 3);
}

TEST_CASE("a feature is suppressed and unsuppressed") {
    check_there_and_back(with_switched_fillet(false), with_switched_fillet(true), 0.5);
}
