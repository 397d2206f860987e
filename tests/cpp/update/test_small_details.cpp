// SPDX-License-Identifier: GPL-3.0-or-later
// Parts with what is far smaller than the size: thin rods, and details that are ignored.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <limits>
#include <set>

#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"
#include "mesh/validation.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "update/fill_part.h"
#include "update/thin_tets.h"

using namespace featuremesh;

namespace {

void check_valid(const PartMesh& part) { CHECK(broken_invariants(part.mesh, expectation_of(part.part.brep)).empty()); }

/// A block with a step as low as given across its top, and a hole.
RawDocument stepped_block(double step, double hole_x) {
    return PartDocument()
        .box("Block", {0, 0, 0}, {60, 30, 8})
        .box("Top", {0, 0, 8}, {30, 30, step})
        .fuse("Stepped", "Block", "Top")
        .cylinder("Hole", {hole_x, 15, -1}, 4, 20)
        .cut("Part", "Stepped", "Hole")
        .finish();
}

bool are_same_bytes(const Mesh& a, const Mesh& b) {
    return a.points == b.points && a.tets == b.tets && a.triangles == b.triangles && a.entities == b.entities;
}

/// A flat tet between two faces with a vertex in common, and an edge from it as well if `share_edge`.
Mesh thin_wedge(bool share_edge) {
    Mesh mesh;
    const NodeId shared = mesh.add_node({0, 0, 0}, entity_of(VertexId(0)));
    const NodeId a = mesh.add_node({1, 0, 0}, share_edge ? entity_of(VertexId(1)) : entity_of(FaceId(0)));
    const NodeId b = mesh.add_node({0, 1, 0}, entity_of(FaceId(0))),
                 c = mesh.add_node({1, 1, 1e-3}, entity_of(FaceId(1)));
    mesh.corner_count = mesh.node_count();
    if (share_edge) mesh.add_segment({shared, a}, EdgeId(0));
    mesh.triangles = {{shared, b, a}, {shared, a, c}};
    mesh.triangle_faces = {FaceId(0), FaceId(1)};
    mesh.tets = {{shared, a, b, c}};
    mesh.tet_solids = {SolidId(0)};
    return mesh;
}

}  // namespace

TEST_CASE("two faces that touch each other are named where the tets between them are thin") {
    QualityReport quality;
    quality.worst = TetId(0);
    quality.min_dihedral = 0.1;
    const auto code = [&](bool share_edge) {
        const auto lines = warnings_of_thin_tets(thin_wedge(share_edge), quality);
        REQUIRE(lines.size() == 1);
        return lines[0].code();
    };
    CHECK(code(false) == Code::faces_touch);
    CHECK(code(true) == Code::smallest_angle);
}

TEST_CASE("a rod that is far thinner than the size is meshed in both orders, which is said once") {
    const auto rod = [](double length) { return PartDocument().cylinder("Rod", {0, 0, 0}, 1, length).finish(); };
    for (const int order : {1, 2}) {
        MeshOptions options = options_of(80, order);
        options.sizing.min_size = 8;
        const PartMeshResult result = meshed(rod(300), options);
        check_valid(*result.part_mesh);
        CHECK(result.report.rounds.empty());
        CHECK(result.report.quality.min_dihedral > 20);
        REQUIRE(result.report.warnings.size() == 1);
        CHECK(result.report.warnings[0].in_english().starts_with(
            "The part is 2 mm thick at Face1: elements are smaller there"));
        const PartMeshResult longer = updated(*result.part_mesh, rod(310), options);
        check_valid(*longer.part_mesh);
        CHECK(longer.report.kept_nodes_share > 0.9);
    }
}

TEST_CASE(
    "what is smaller than the length below which details are ignored has "
    "no elements, also in updates") {
    for (const int order : {1, 2}) {
        MeshOptions with = options_of(4, order), without = with;
        with.ignore_below = -1, without.ignore_below = 0.01;
        const PartMeshResult off = meshed(stepped_block(0.004, 45), with),
                             on = meshed(stepped_block(0.004, 45), without);
        check_valid(*on.part_mesh);
        CHECK(off.report.quality.min_dihedral < 5);
        CHECK(on.report.quality.min_dihedral > 20);
        const auto said = [](const PartMeshResult& result, const char* begin) {
            return std::count_if(
                result.report.warnings.begin(), result.report.warnings.end(),
                [&](const featuremesh::Message& line) { return line.in_english().starts_with(begin); });
        };
        CHECK(said(on, "Too narrow for elements of their own: Face") == 1);
        CHECK(said(on, "These vertices are nearer to another one than 0.01 mm") == 1);

        const PartMeshResult moved = updated(*on.part_mesh, stepped_block(0.004, 47), without);
        check_valid(*moved.part_mesh);
        CHECK(moved.report.fallbacks.empty());
        CHECK(moved.report.kept_nodes_share > 0.5);
        CHECK(moved.report.quality.min_dihedral > 20);
        // with other details than before, nothing of the old mesh is of use
        const PartMeshResult again = updated(*on.part_mesh, stepped_block(0.004, 45), with);
        CHECK(again.report.kept_nodes_share == 0);
        CHECK(again.report.quality.min_dihedral < 5);
    }
}

TEST_CASE("a step round a shaft lower than what is ignored has no elements of its own, whichever way its circles run") {
    const auto shaft = [](double step, double bore, bool is_turned) {
        const gp_Ax2 axis(gp_Pnt(0, 0, is_turned ? 40 : 20), gp_Dir(0, 0, is_turned ? -1 : 1), gp_Dir(1, 0, 0));
        return PartDocument()
            .cylinder("Shaft", {0, 0, 0}, 10, 20)
            .add("Seat", "Part::Cylinder", BRepPrimAPI_MakeCylinder(axis, 10 + step, 20).Shape())
            .fuse("Stepped", "Shaft", "Seat")
            .cylinder("Bore", {0, 0, 30}, bore, 20)
            .cut("Part", "Stepped", "Bore")
            .finish();
    };
    for (const int order : {1, 2})
        for (const bool is_turned : {false, true}) {
            MeshOptions options = options_of(4, order);
            options.ignore_below = 0.02;
            const PartMeshResult result = meshed(shaft(0.01, 4, is_turned), options);
            check_valid(*result.part_mesh);
            CHECK(result.report.quality.min_dihedral > 20);
            CHECK(result.report.rounds.empty());
            const PartMeshResult bored = updated(*result.part_mesh, shaft(0.01, 5, is_turned), options);
            check_valid(*bored.part_mesh);
            CHECK(bored.report.fallbacks.empty());
            CHECK(bored.report.kept_nodes_share > 0.2);
            const PartMeshResult higher = updated(*bored.part_mesh, shaft(1, 5, is_turned), options);
            check_valid(*higher.part_mesh);
            const PartMeshResult again = updated(*higher.part_mesh, shaft(0.01, 5, is_turned), options);
            check_valid(*again.part_mesh);
            CHECK(again.report.quality.min_dihedral > 20);
        }
}

TEST_CASE("a bore or a pin that is thinner than what is ignored is closed, however deep it is") {
    const auto drilled = [](double radius, double depth, double x) {
        return PartDocument()
            .box("Block", {0, 0, 0}, {60, 30, 8})
            .cylinder("Bore", {x, 15, 8 - depth}, radius, depth)
            .cut("Drilled", "Block", "Bore")
            .cylinder("Pin", {15, 15, 7}, radius, 1 + depth)
            .fuse("Part", "Drilled", "Pin")
            .finish();
    };
    for (const int order : {1, 2}) {
        MeshOptions options = options_of(4, order);
        options.ignore_below = 0.002;
        for (const double depth : {0.001, 3.0}) {
            const PartMeshResult result = meshed(drilled(3e-4, depth, 45), options);
            check_valid(*result.part_mesh);
            CHECK(result.report.quality.min_dihedral > 15);
            CHECK(result.report.rounds.empty());
            const PartMeshResult moved = updated(*result.part_mesh, drilled(3e-4, depth, 47), options);
            check_valid(*moved.part_mesh);
            CHECK(moved.report.quality.min_dihedral > 10);
        }
    }
}

TEST_CASE("a block that is not quite flush with another one is meshed as if it were, also in updates") {
    const auto stacked = [](double off, double hole_x) {
        return PartDocument()
            .box("Low", {0, 0, 0}, {60, 30, 10})
            .box("High", {off, off, 9}, {60, 30, 5})
            .fuse("Stacked", "Low", "High")
            .cylinder("Hole", {hole_x, 15, -1}, 4, 20)
            .cut("Part", "Stacked", "Hole")
            .finish();
    };
    for (const int order : {1, 2}) {
        MeshOptions options = options_of(4, order);
        options.ignore_below = 0.01;
        const PartMeshResult result = meshed(stacked(0.002, 45), options);
        check_valid(*result.part_mesh);
        CHECK(result.report.quality.min_dihedral > 20);
        CHECK(result.report.rounds.empty());
        const PartMeshResult moved = updated(*result.part_mesh, stacked(0.002, 47), options);
        check_valid(*moved.part_mesh);
        CHECK(moved.report.fallbacks.empty());
        CHECK(moved.report.kept_nodes_share > 0.5);
        const PartMeshResult flush = updated(*moved.part_mesh, stacked(0, 47), options);
        check_valid(*flush.part_mesh);
        const PartMeshResult again = updated(*flush.part_mesh, stacked(0.002, 47), options);
        check_valid(*again.part_mesh);
        CHECK(again.report.quality.min_dihedral > 20);
    }
}

TEST_CASE("a slit narrower than what is ignored is closed in the mesh, which is said once") {
    const auto slit = [](double width, double hole_x) {
        return PartDocument()
            .box("Block", {0, 0, 0}, {60, 30, 8})
            .box("Slit", {30, -1, 3}, {width, 40, 10})
            .cut("Slitted", "Block", "Slit")
            .cylinder("Hole", {hole_x, 15, -1}, 4, 20)
            .cut("Part", "Slitted", "Hole")
            .finish();
    };
    for (const int order : {1, 2}) {
        MeshOptions options = options_of(4, order);
        options.ignore_below = 0.01;
        const auto closed = [](const PartMeshResult& result) {
            return std::count_if(result.report.warnings.begin(), result.report.warnings.end(),
                                 [](const auto& line) { return line.code() == Code::faces_joined; });
        };
        const PartMeshResult result = meshed(slit(0.002, 45), options);
        check_valid(*result.part_mesh);
        CHECK(closed(result) == 1);
        CHECK(result.report.quality.min_dihedral > 20);
        CHECK(result.report.rounds.empty());
        const PartMeshResult moved = updated(*result.part_mesh, slit(0.002, 47), options);
        check_valid(*moved.part_mesh);
        CHECK(closed(moved) == 1);
        CHECK(moved.report.fallbacks.empty());
        CHECK(moved.report.kept_nodes_share > 0.5);
        const PartMeshResult wide = updated(*moved.part_mesh, slit(1, 47), options);
        check_valid(*wide.part_mesh);
        CHECK(closed(wide) == 0);
        CHECK(wide.report.kept_nodes_share > 0.2);
        const PartMeshResult narrow = updated(*wide.part_mesh, slit(0.002, 47), options);
        check_valid(*narrow.part_mesh);
        CHECK(closed(narrow) == 1);
    }
}

TEST_CASE("the end of such a slit in a floor that goes on beside it is refused by the names of its edges") {
    BRepBuilderAPI_MakePolygon outline;
    const std::array<std::array<double, 2>, 8> corners{
        {{-1, -1}, {20, -1}, {20, 15}, {30, 15}, {30, 15.002}, {20, 15.002}, {20, 31}, {-1, 31}}};
    for (const auto& [x, y] : corners) outline.Add(gp_Pnt(x, y, 4));
    outline.Close();
    const TopoDS_Shape pocket =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 10)).Shape();
    const RawDocument slitted = PartDocument()
                                    .box("Block", {0, 0, 0}, {60, 30, 8})
                                    .add("Pocket", "Part::Extrusion", pocket)
                                    .cut("Part", "Block", "Pocket")
                                    .finish();
    MeshOptions options = options_of(4);
    options.ignore_below = 0.01;
    CHECK_THROWS_WITH(meshed(slitted, options), Catch::Matchers::Contains("Nothing is beside Edge"));
}

TEST_CASE("a fin or a plate thinner than what is ignored has elements: only what is between material is closed") {
    MeshOptions options = options_of(4);
    options.ignore_below = 0.01;
    const PartMeshResult plate = meshed(PartDocument().box("Plate", {0, 0, 0}, {60, 30, 0.005}).finish(), options);
    check_valid(*plate.part_mesh);
    const RawDocument with_fin = PartDocument()
                                     .box("Block", {0, 0, 0}, {60, 30, 8})
                                     .box("Fin", {20, 0, 8}, {0.004, 30, 10})
                                     .fuse("Part", "Block", "Fin")
                                     .finish();
    const PartMeshResult fin = meshed(with_fin, options);
    check_valid(*fin.part_mesh);
    const auto& points = fin.part_mesh->mesh.points;
    CHECK(std::any_of(points.begin(), points.end(), [](const Vec3& p) { return p.z > 17; }));
}

TEST_CASE("a bore that leaves a wall thinner than the sides of 10-node elements bend gets shorter ones there") {
    const auto bored = [](double wall) {
        return PartDocument()
            .box("Block", {0, 0, 0}, {30, 20, 10})
            .cylinder("Bore", {15, 4 + wall, -1}, 4, 12)
            .cut("Part", "Block", "Bore")
            .finish();
    };
    const PartMeshResult result = meshed(bored(0.02), options_of(3, 2));
    check_valid(*result.part_mesh);
    REQUIRE_FALSE(result.report.rounds.empty());
    CHECK(result.report.rounds[0].reason == "folded");
    CHECK(result.part_mesh->mesh.tets.size() < 40'000);
    // a wall that leaves the curved sides room needs none
    CHECK(meshed(bored(3), options_of(3, 2)).report.rounds.empty());
}

TEST_CASE("a few elements without a volume to speak of in a thin floor get shorter edges") {
    // the floor is 0.006 thick
    const RawDocument document = PartDocument()
                                     .box("Block", {0, 0, 0}, {40, 30, 8})
                                     .cylinder("Bore", {20, 15, 0.006}, 6, 20)
                                     .cut("Part", "Block", "Bore")
                                     .finish();
    for (const double size : {2.0, 2.6, 3.3}) check_valid(*meshed(document, options_of(size)).part_mesh);
}

TEST_CASE("a floor far thinner than its triangles are wide is meshed at once, also beside a bore through it") {
    const auto drilled = [](double floor, double second_x) {
        return PartDocument()
            .box("Block", {0, 0, 0}, {60, 40, 8})
            .cylinder("Through", {22, 20, -1}, 6, 20)
            .cut("Bored", "Block", "Through")
            .cylinder("Blind", {29, 22, floor}, 5, 20)
            .cut("Part", "Bored", "Blind")
            .cylinder("Other", {second_x, 30, -1}, 2, 20)
            .cut("Final", "Part", "Other")
            .finish();
    };
    for (const int order : {1, 2})
        for (const double floor : {0.0003, 0.004}) {
            const MeshOptions options = options_of(3.2, order);
            const PartMeshResult result = meshed(drilled(floor, 50), options);
            check_valid(*result.part_mesh);
            CHECK(result.report.rounds.empty());
            CHECK(result.report.fallbacks.empty());
            const PartMeshResult moved = updated(*result.part_mesh, drilled(floor, 52), options);
            check_valid(*moved.part_mesh);
            CHECK(moved.report.kept_nodes_share > 0.5);
        }
}

TEST_CASE("where no detail is below the length the bytes are the same") {
    MeshOptions off = options_of(4), on = off, automatic = off;
    off.ignore_below = -1, on.ignore_below = 0.01, automatic.ignore_below = 0;
    const Mesh plain = meshed(stepped_block(3, 45), off).part_mesh->mesh;
    CHECK(are_same_bytes(plain, meshed(stepped_block(3, 45), on).part_mesh->mesh));
    CHECK(are_same_bytes(plain, meshed(stepped_block(3, 45), automatic).part_mesh->mesh));
    CHECK(are_same_bytes(meshed(stepped_block(0.025, 45), off).part_mesh->mesh,
                         meshed(stepped_block(0.025, 45), automatic).part_mesh->mesh));
}

TEST_CASE(
    "automatically what is below a two-hundredth of the size is ignored, also where an edit makes it, unless a local "
    "size is nearly as fine") {
    MeshOptions automatic = options_of(4);
    automatic.ignore_below = 0;
    MeshOptions fine = automatic, finer = automatic;
    fine.sizing.local.push_back({entity_of(VertexId(0)), 0.9});
    finer.sizing.local.push_back({entity_of(VertexId(0)), 0.5});
    const PartMeshResult plain = meshed(stepped_block(3, 45), automatic);
    const PartMeshResult stepped = updated(*plain.part_mesh, stepped_block(0.015, 45), automatic);
    const PartMeshResult locally = updated(*stepped.part_mesh, stepped_block(0.015, 45), fine);
    const PartMeshResult again = updated(*locally.part_mesh, stepped_block(0.015, 45), finer);
    for (const PartMeshResult* result : {&plain, &stepped, &locally, &again}) check_valid(*result->part_mesh);
    CHECK(stepped.report.kept_nodes_share > 0.3);
    CHECK(stepped.report.quality.min_dihedral > 15);
    CHECK(locally.report.kept_nodes_share > 0.3);
    CHECK(locally.report.quality.min_dihedral > 15);
    CHECK(again.report.kept_nodes_share == 0);
    CHECK(again.report.quality.min_dihedral < 5);
}

TEST_CASE("a solid as thin as what is ignored automatically has its elements") {
    const RawDocument both = PartDocument()
                                 .box("Block", {0, 0, 0}, {40, 30, 20})
                                 .box("Film", {45, 0, 0}, {0.5, 0.5, 0.003})
                                 .fuse("Both", "Block", "Film")
                                 .finish();
    MeshOptions automatic = options_of(4);
    automatic.ignore_below = 0;
    const PartMeshResult result = meshed(both, automatic);
    check_valid(*result.part_mesh);
    CHECK(result.part_mesh->options.ignored_below < 0.001);
    CHECK(result.part_mesh->shared_nodes.empty());
}

TEST_CASE("what is too small for elements of its own has the nodes in its place") {
    for (const int order : {1, 2}) {
        MeshOptions options = options_of(4, order);
        options.ignore_below = 0;
        const auto part = meshed(stepped_block(0.003, 45), options).part_mesh;
        std::set<Entity> faces;
        for (const SharedNode& shared : part->shared_nodes) {
            CHECK(std::abs(part->mesh.point(shared.node).z - 8) < 0.004);
            if (shared.entity.dim == 2) faces.insert(shared.entity);
        }
        CHECK(faces.size() == 4);  // the step's four sides
    }
}

TEST_CASE(
    "a length below which details are ignored that is of the order of "
    "the size is refused") {
    MeshOptions options = options_of(4);
    for (const double wrong : {2.5, std::numeric_limits<double>::quiet_NaN()}) {
        options.ignore_below = wrong;
        CHECK_THROWS_AS(meshed(stepped_block(3, 45), options), InputError);
    }
}

static RawDocument ribbed_block(double thickness) {
    return PartDocument()
        .box("Block", {0, 0, 0}, {60, 40, 40})
        .box("Rib", {0, 20, 40}, {20, thickness, 4})
        .fuse("Part", "Block", "Rib")
        .finish();
}

TEST_CASE("small angles that the shape does not force get shorter edges, and an update keeps them") {
    const RawDocument ribbed = ribbed_block(0.35);
    const MeshOptions options = options_of(4);
    const PartMeshResult result = meshed(ribbed, options);
    check_valid(*result.part_mesh);
    CHECK(result.report.quality.min_dihedral_unforced > 10);
    REQUIRE(!result.report.rounds.empty());
    for (const auto& round : result.report.rounds) CHECK(round.reason == "small angles");
    const PartMeshResult again = updated(*result.part_mesh, ribbed, options);
    CHECK(are_same_bytes(result.part_mesh->mesh, again.part_mesh->mesh));
}

TEST_CASE("small angles of a large mesh are mended where they are, with the same bytes for any number of threads") {
    const RawDocument ribbed = ribbed_block(0.2);
    for (const int order : {1, 2}) {
        const PartMeshResult result = meshed(ribbed, options_of(1.75, order));
        check_valid(*result.part_mesh);
        CHECK(result.part_mesh->mesh.tets.size() > 100'000);
        REQUIRE(!result.report.rounds.empty());
        CHECK(result.report.rounds[0].reason == "small angles");
        CHECK(result.report.quality.min_dihedral_unforced > 10);
        CHECK(are_same_bytes(result.part_mesh->mesh, meshed(ribbed, options_of(1.75, order), 3).part_mesh->mesh));
    }
}

// The wall is 0.03 thick where it is thinnest.
TEST_CASE("angles of about a degree at a round pocket close to a side are mended, too") {
    const RawDocument pocket = PartDocument()
                                   .box("Block", {0, 0, 0}, {40, 30, 6})
                                   .cylinder("Pocket", {4.93, 15, 4}, 4.9, 3)
                                   .cut("Part", "Block", "Pocket")
                                   .finish();
    for (const int order : {1, 2}) {
        const PartMeshResult result = meshed(pocket, options_of(4, order));
        check_valid(*result.part_mesh);
        CHECK(result.report.quality.min_dihedral_unforced > 4);
    }
}

TEST_CASE("a small mesh may grow by more for its angles") {
    for (const int order : {1, 2}) {
        const PartMeshResult result = meshed(ribbed_block(0.25), options_of(6, order));
        check_valid(*result.part_mesh);
        CHECK(result.report.quality.min_dihedral_unforced > 10);
        CHECK(result.part_mesh->mesh.tets.size() < 7000);
    }
}

TEST_CASE("small angles that came with an edit are mended, and what was kept beside them stays") {
    for (const int order : {1, 2}) {
        const MeshOptions options = options_of(3, order);
        const PartMeshResult plain = meshed(ribbed_block(4), options);
        const PartMeshResult result = updated(*plain.part_mesh, ribbed_block(0.2), options);
        check_valid(*result.part_mesh);
        CHECK(result.report.fallbacks.empty());
        CHECK(result.report.quality.min_dihedral_unforced > 10);
        REQUIRE(!result.report.rounds.empty());
        CHECK(result.report.rounds[0].reason == "small angles");
        CHECK(result.report.kept_nodes_share > 0.5);
        const Mesh &old = plain.part_mesh->mesh, &now = result.part_mesh->mesh;
        const std::vector<std::int32_t>& origin = result.part_mesh->node_origin;
        REQUIRE(origin.size() == now.node_count());
        for (std::size_t n = 0; n < origin.size(); ++n) {
            if (origin[n] < 0) {
                REQUIRE(now.node_numbers[n] >= old.next_node_number);
                continue;
            }
            REQUIRE(now.points[n] == old.points[std::size_t(origin[n])]);
            REQUIRE(now.node_numbers[n] == old.node_numbers[std::size_t(origin[n])]);
        }
        const std::vector<std::int32_t>& tets = result.part_mesh->tet_origin;
        REQUIRE(tets.size() == now.tets.size());
        for (std::size_t t = 0; t < tets.size(); ++t)
            REQUIRE((tets[t] < 0 ? now.tet_numbers[t] >= old.next_element_number
                                 : now.tet_numbers[t] == old.tet_numbers[std::size_t(tets[t])]));
        CHECK(are_same_bytes(now, updated(*plain.part_mesh, ribbed_block(0.2), options, 3).part_mesh->mesh));
    }
}

TEST_CASE("small angles are not mended again and again where that takes more tets than there is room for") {
    MeshOptions options = options_of(5, 1);
    options.sizing.min_size = 0.5;
    const auto report = meshed(stepped_block(0.02, 28), options).report;
    const auto is_mending = [](const auto& round) { return round.reason == "small angles"; };
    const auto rounds = std::count_if(report.rounds.begin(), report.rounds.end(), is_mending);
    CHECK(rounds > 0);
    CHECK(rounds < 3);
}
