// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of faces: meshed with triangles, updated as locally as solids.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <map>
#include <set>

#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"
#include "mesh/second_order.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "surface/projection.h"
#include "update/fill_part.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

TopoDS_Wire circle(Vec3 centre, double radius) {
    const gp_Ax2 axis(gp_Pnt(centre.x, centre.y, centre.z), gp_Dir(0, 0, 1));
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axis, radius)).Edge()).Wire();
}

TopoDS_Wire rectangle(Vec3 low, double width, double height) {
    return BRepBuilderAPI_MakePolygon(gp_Pnt(low.x, low.y, low.z), gp_Pnt(low.x + width, low.y, low.z),
                                      gp_Pnt(low.x + width, low.y + height, low.z),
                                      gp_Pnt(low.x, low.y + height, low.z), true)
        .Wire();
}

/// A flat sheet of 100 x 60 with a round hole.
TopoDS_Shape sheet_with_hole(Vec3 hole, double radius) {
    BRepBuilderAPI_MakeFace face(rectangle({0, 0, 0}, 100, 60));
    TopoDS_Wire inner = circle(hole, radius);
    inner.Reverse();
    face.Add(inner);
    return face.Face();
}

/// A square pipe without ends.
TopoDS_Shape pipe(Vec3 low, double height) {
    return BRepPrimAPI_MakePrism(rectangle(low, 40, 40), gp_Vec(0, 0, height)).Shape();
}

/// Three sheets of 30 x 20 that meet in one edge.
TopoDS_Shape three_sheets(double third_width) {
    const TopoDS_Edge spine = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 20)).Edge();
    TopoDS_Shape all;
    for (const gp_Vec& way : {gp_Vec(30, 0, 0), gp_Vec(-30, 0, 0), gp_Vec(0, third_width, 0)}) {
        const TopoDS_Shape sheet = BRepPrimAPI_MakePrism(spine, way).Shape();
        all = all.IsNull() ? sheet : BRepAlgoAPI_Fuse(all, sheet).Shape();
    }
    return all;
}

/// Of two arcs, since an edge that is closed passes no vertex of another one.
TopoDS_Wire circle_of_arcs(Vec3 centre, double radius) {
    const gp_Circ round(gp_Ax2(gp_Pnt(centre.x, centre.y, centre.z), gp_Dir(0, 0, 1)), radius);
    const TopoDS_Edge upper = BRepBuilderAPI_MakeEdge(round, 0, M_PI).Edge();
    return BRepBuilderAPI_MakeWire(upper, BRepBuilderAPI_MakeEdge(round, M_PI, 2 * M_PI).Edge()).Wire();
}

/// A flat sheet with a round hole and a notch in its border whose tip all but touches the hole.
TopoDS_Shape sheet_with_notch(double gap, TopoDS_Wire hole) {
    BRepBuilderAPI_MakePolygon border;
    for (const auto& [x, y] :
         {std::array{0.0, 0.0}, {100.0, 0.0}, {100.0, 60.0}, {57.0, 60.0}, {50.0, 36 + gap}, {43.0, 60.0}, {0.0, 60.0}})
        border.Add(gp_Pnt(x, y, 0));
    border.Close();
    BRepBuilderAPI_MakeFace face(border.Wire());
    hole.Reverse();
    face.Add(hole);
    return face.Face();
}

void check_sound(const PartMesh& part, double size) {
    const Mesh& mesh = part.mesh;
    CHECK(mesh.tets.empty());
    CHECK(broken_invariants(mesh, expectation_of(part.part.brep)).empty());
    const Projector projector(part.part.brep);
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
        const Entity at = mesh.entities[n];
        REQUIRE(at.dim < 3);
        const Vec3& p = mesh.points[n];
        const double off = at.dim == 2   ? projector.nearest(FaceId(at.index), p).distance
                           : at.dim == 1 ? projector.nearest(EdgeId(at.index), p).distance
                                         : part.part.brep.distance_from(VertexId(at.index), p);
        CHECK(off < 1e-6 * size);
    }
}

/// Number of triangle -> its points.
std::map<Number, std::vector<Vec3>> triangles_by_number(const Mesh& mesh) {
    std::map<Number, std::vector<Vec3>> found;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::vector<Vec3>& points = found[mesh.triangle_numbers[t]];
        for (const NodeId n : mesh.triangles[t]) points.push_back(mesh.point(n));
        if (mesh.order == 2)
            for (const NodeId n : mesh.triangle_mids[t]) points.push_back(mesh.point(n));
    }
    return found;
}

std::size_t count_same(const Mesh& old_mesh, const Mesh& new_mesh) {
    const auto was = triangles_by_number(old_mesh), is = triangles_by_number(new_mesh);
    std::size_t same = 0;
    for (const auto& [number, points] : is)
        if (const auto it = was.find(number); it != was.end()) same += it->second == points;
    return same;
}

RawDocument document_of(const TopoDS_Shape& shape, const std::string& type = "Part::Feature") {
    return PartDocument().add("Sheet", type, shape).finish();
}

}  // namespace

TEST_CASE("A part of faces is meshed with triangles on its faces") {
    const int order = GENERATE(1, 2);
    RunContext context;
    for (const TopoDS_Shape& shape : {sheet_with_hole({30, 30, 0}, 8), pipe({0, 0, 0}, 100), three_sheets(20)}) {
        const PartMeshResult result = mesh_part(document_of(shape), options_of(5, order), context);
        check_sound(*result.part_mesh, 5);
        CHECK(result.report.dimension == Dimension::faces);
        CHECK(result.report.triangles > 50);
        CHECK(result.report.quality.min_dihedral_unforced > 20);
        CHECK(result.report.lengths.share_within > 0.9);
    }
}

TEST_CASE("A 6-node triangle that a curved side folds at any length has straight sides, which is said once") {
    MeshOptions options = options_of(8, 2);
    options.ignore_below = -1;
    const PartMeshResult result = meshed(document_of(sheet_with_notch(3e-4, circle({50, 30, 0}, 6))), options);
    const Mesh& mesh = result.part_mesh->mesh;
    CHECK(broken_invariants(mesh, expectation_of(result.part_mesh->part.brep)).empty());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        REQUIRE(min_scaled_jacobian(triangle_nodes(mesh, TriangleId(t))) > 0.05);
    std::vector<std::string> told;
    for (const auto& line : result.report.warnings)
        if (line.code() == Code::sides_stay_straight) told.push_back(line.in_english());
    REQUIRE(told.size() == 1);
    CHECK(told[0].starts_with("1 side of elements at Edge"));
    CHECK(result.report.rounds.size() == most_rounds_in_vain);
    const PartMeshResult moved =
        updated(*result.part_mesh, document_of(sheet_with_notch(4e-4, circle({50, 30, 0}, 6))), options);
    CHECK(broken_invariants(moved.part_mesh->mesh, expectation_of(moved.part_mesh->part.brep)).empty());
}

TEST_CASE("A border that passes a vertex of another nearer than what is ignored has its node") {
    const int order = GENERATE(1, 2);
    MeshOptions options = options_of(5, order);
    options.ignore_below = 0.01;
    const PartMeshResult result = meshed(document_of(sheet_with_notch(0.005, circle_of_arcs({50, 30, 0}, 6))), options);
    CHECK(broken_invariants(result.part_mesh->mesh, expectation_of(result.part_mesh->part.brep)).empty());
    CHECK(result.report.quality.min_dihedral > 5);
    CHECK(result.report.triangles < 1000);
}

TEST_CASE(
    "A sheet as narrow as what is ignored automatically has its elements, and is refused where the user ignores it") {
    const RawDocument strip = document_of(BRepBuilderAPI_MakeFace(rectangle({0, 0, 0}, 60, 0.003)).Face());
    MeshOptions options = options_of(5, 1);
    options.ignore_below = 0;
    const PartMeshResult result = meshed(strip, options);
    CHECK(broken_invariants(result.part_mesh->mesh, expectation_of(result.part_mesh->part.brep)).empty());
    CHECK(result.report.triangles >= 12);
    options.ignore_below = 0.01;
    CHECK_THROWS_WITH(meshed(strip, options), Catch::Matchers::StartsWith("All of the part is smaller"));
}

TEST_CASE("Where three sheets meet in an edge they share its nodes") {
    RunContext context;
    const PartMeshResult result = mesh_part(document_of(three_sheets(20)), options_of(4, 1), context);
    const Mesh& mesh = result.part_mesh->mesh;
    std::map<std::pair<NodeId, NodeId>, int> uses;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t s = 0; s < 3; ++s) ++uses[std::minmax(triangle[s], triangle[(s + 1) % 3])];
    std::map<int, int> counts;
    for (const auto& [side, count] : uses) ++counts[count];
    CHECK(counts[3] == 5);  // 20 mm in pieces of 4
    CHECK(counts.rbegin()->first == 3);
    CHECK(counts[1] > 30);
}

TEST_CASE("The faces of a solid are meshed without its inside") {
    RunContext context;
    const RawDocument document = PartDocument().box("Box", {0, 0, 0}, {40, 30, 20}).finish();
    const PartMeshResult result = mesh_part(document, options_of(5, 2, Dimension::faces), context);
    check_sound(*result.part_mesh, 5);
    CHECK(result.part_mesh->part.brep.solid_count() == 0);
    const PartMeshResult solid = mesh_part(document, options_of(5, 2), context);
    CHECK(!solid.part_mesh->mesh.tets.empty());
    CHECK_THROWS_AS(mesh_part(document_of(pipe({0, 0, 0}, 50)), options_of(5, 1, Dimension::solids), context),
                    InputError);
}

TEST_CASE("A hole that moves leaves the rest of a sheet as it was, and takes its own triangles along") {
    const int order = GENERATE(1, 2);
    RunContext context;
    const auto document = [](Vec3 hole) { return document_of(sheet_with_hole(hole, 6)); };
    const PartMeshResult before = mesh_part(document({30, 30, 0}), options_of(4, order), context);
    const PartMeshResult after = update_part(*before.part_mesh, document({36, 30, 0}), options_of(4, order), context);
    check_sound(*after.part_mesh, 4);
    CHECK(after.report.fallbacks.empty());
    const Mesh &old_mesh = before.part_mesh->mesh, &new_mesh = after.part_mesh->mesh;
    CHECK(count_same(old_mesh, new_mesh) > 0.6 * double(new_mesh.triangles.size()));
    CHECK(after.report.kept_tets_share == Approx(double(count_same(old_mesh, new_mesh)) / new_mesh.triangles.size()));
    for (std::size_t t = 0; t < new_mesh.triangles.size(); ++t)
        if (after.part_mesh->tet_origin[t] < 0) CHECK(new_mesh.triangle_numbers[t] >= old_mesh.next_element_number);
    CHECK(after.report.quality.min_dihedral_unforced > 20);
}

TEST_CASE("Triangles of faces that did not change stay, whatever changes beside them") {
    RunContext context;
    const PartMeshResult before = mesh_part(document_of(three_sheets(20)), options_of(4, 2), context);
    const PartMeshResult after =
        update_part(*before.part_mesh, document_of(three_sheets(26)), options_of(4, 2), context);
    check_sound(*after.part_mesh, 4);
    CHECK(after.report.fallbacks.empty());
    const Mesh& old_mesh = before.part_mesh->mesh;
    std::size_t on_unchanged = 0;
    for (std::size_t t = 0; t < old_mesh.triangles.size(); ++t)
        on_unchanged += old_mesh.point(old_mesh.triangles[t][0]).y == 0 &&
                        old_mesh.point(old_mesh.triangles[t][1]).y == 0 &&
                        old_mesh.point(old_mesh.triangles[t][2]).y == 0;
    CHECK(count_same(old_mesh, after.part_mesh->mesh) > on_unchanged);
    const auto is = triangles_by_number(after.part_mesh->mesh);
    for (const auto& [number, points] : triangles_by_number(old_mesh))
        if (points[0].y == 0 && points[1].y == 0 && points[2].y == 0) {
            CAPTURE(points[0].x, points[0].z, points[1].x, points[1].z, points[2].x, points[2].z);
            CHECK(is.count(number) == 1);
        }
}

TEST_CASE("A sheet that moved carries its triangles") {
    RunContext context;
    const auto document = [](double x) {
        PartDocument part;
        part.add("Plate", "Part::Feature", sheet_with_hole({30, 30, 0}, 8));
        RigidMotion place;
        place.translation = {x, 0, 30};
        part.add("Pipe", "Part::Extrusion", pipe({x, 0, 30}, 50), {}, place);
        BRep_Builder builder;
        TopoDS_Compound both;
        builder.MakeCompound(both);
        builder.Add(both, part.shape("Plate")), builder.Add(both, part.shape("Pipe"));
        part.add("Both", "Part::Compound", both, {{"Links", "Plate", ""}, {"Links", "Pipe", ""}});
        return part.finish();
    };
    const PartMeshResult before = mesh_part(document(0), options_of(5, 2), context);
    const PartMeshResult after = update_part(*before.part_mesh, document(12.5), options_of(5, 2), context);
    check_sound(*after.part_mesh, 5);
    CHECK(after.report.fallbacks.empty());
    CHECK(after.report.kept_tets_share == 1.0);
    REQUIRE(after.report.kept.size() == 2);
    CHECK(after.report.kept[1].motion.translation == Vec3{12.5, 0, 0});
    CHECK(after.report.kept[1].tets > 100);
}

TEST_CASE("Undoing an edit of a sheet, or none, gives the kept part back bit for bit") {
    RunContext context;
    const RawDocument first = document_of(pipe({0, 0, 0}, 100)), second = document_of(pipe({0, 0, 0}, 120));
    const PartMeshResult before = mesh_part(first, options_of(6, 2), context);
    const PartMeshResult same = update_part(*before.part_mesh, first, options_of(6, 2), context);
    CHECK(same.part_mesh->mesh.points == before.part_mesh->mesh.points);
    const PartMeshResult longer = update_part(*before.part_mesh, second, options_of(6, 2), context);
    check_sound(*longer.part_mesh, 6);
    CHECK(longer.report.kept_tets_share > 0.5);
    const PartMeshResult again = update_part(*longer.part_mesh, first, options_of(6, 2), context);
    check_sound(*again.part_mesh, 6);
    CHECK(count_same(before.part_mesh->mesh, again.part_mesh->mesh) >
          0.5 * double(before.part_mesh->mesh.triangles.size()));
    std::set<Number> numbers(again.part_mesh->mesh.node_numbers.begin(), again.part_mesh->mesh.node_numbers.end());
    CHECK(numbers.size() == again.part_mesh->mesh.node_count());
}

TEST_CASE("A sheet's mesh is the same for any number of threads, and is restored as it was") {
    RunContext one, four;
    four.threads = 4;
    const RawDocument document = document_of(sheet_with_hole({30, 30, 0}, 8));
    const PartMeshResult a = mesh_part(document, options_of(3, 2), one),
                         b = mesh_part(document, options_of(3, 2), four);
    CHECK(a.part_mesh->mesh.points == b.part_mesh->mesh.points);
    CHECK(a.part_mesh->mesh.triangles == b.part_mesh->mesh.triangles);
    const auto restored = restore_part(document, options_of(3, 2), a.part_mesh->mesh, one);
    CHECK(restored->mesh.triangles == a.part_mesh->mesh.triangles);
    Mesh torn = a.part_mesh->mesh;
    torn.triangles.pop_back(), torn.triangle_mids.pop_back();
    torn.triangle_faces.pop_back(), torn.triangle_numbers.pop_back();
    CHECK_THROWS_AS(restore_part(document, options_of(3, 2), torn, one), StateError);
}

TEST_CASE("A part that becomes a solid is meshed anew, and says so") {
    RunContext context;
    const PartMeshResult before = mesh_part(document_of(pipe({0, 0, 0}, 40)), options_of(8, 1), context);
    const RawDocument solid = document_of(BRepPrimAPI_MakeBox(40, 40, 40).Shape());
    const PartMeshResult after = update_part(*before.part_mesh, solid, options_of(8, 1), context);
    CHECK(!after.part_mesh->mesh.tets.empty());
    REQUIRE(after.report.fallbacks.size() == 1);
    CHECK(after.report.fallbacks[0].in_english().find("were not before") != std::string::npos);
}
