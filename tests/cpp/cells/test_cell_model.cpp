// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "catch.h"
#include "cells/cell_model.h"
#include "cells/fuse.h"
#include "core/errors.h"
#include "parts.h"

using namespace featuremesh;
using namespace featuremesh::test;
constexpr double pi = std::numbers::pi;

namespace {

CellModel cells_of(const Part& part) {
    RunContext context;
    return build_cells(part.tree(), Brep(part.tree().final_shape), context);
}

/// A compound of two features with a solid each.
FeatureTree compound_of(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    FeatureTree tree;
    tree.object = "Compound";
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    for (const auto& [name, shape] : {std::pair{"A", a}, std::pair{"B", b}}) {
        Feature& feature = tree.features.emplace_back();
        feature.name = feature.label = name;
        feature.volumes.push_back({shape, Effect::adds, 0, {}, Effect::adds});
        builder.Add(both, shape);
    }
    Feature& compound = tree.features.emplace_back();
    compound.name = "Compound";
    compound.combination = Combination::fuse;
    compound.operands = {FeatureId(0), FeatureId(1)};
    tree.final_shape = both;
    return tree;
}

/// Names of the owners of each cell with its volume, the one number that tells cells apart here.
std::map<std::set<std::string>, std::vector<double>> by_owner(const Part& part, const CellModel& model) {
    std::map<std::set<std::string>, std::vector<double>> result;
    for (const Cell& cell : model.cells) {
        std::set<std::string> owners;
        for (const Owner& owner : cell.owners) owners.insert(part.tree()[owner.feature].name);
        result[owners].push_back(cell.volume);
    }
    for (auto& [owners, volumes] : result) std::sort(volumes.begin(), volumes.end());
    return result;
}

/// What holds for every cellular model that needed no fallback.
void check_sound(const Part& part, const CellModel& model) {
    const Brep brep(part.tree().final_shape);
    CHECK(model.report.fallbacks.empty());
    CHECK(model.report.untrusted.empty());
    CHECK(model.report.material_volume == Approx(model.report.final_volume).epsilon(1e-6));
    std::vector<std::size_t> faces_of_cell(model.cells.size());
    for (const CellFace& face : model.faces) {
        CHECK_FALSE(face.owners.empty());
        CHECK((face.cells[0].is_valid() || face.cells[1].is_valid()));
        CHECK(std::is_sorted(face.owners.begin(), face.owners.end()));
        int material = 0;
        for (const CellId id : face.cells) {
            if (!id.is_valid()) continue;
            ++faces_of_cell[id.index()];
            material += model.cells[id.index()].material;
        }
        CHECK(face.final_face.is_valid() == (material == 1));
    }
    for (const std::size_t count : faces_of_cell) CHECK(count > 0);
    for (const Cell& cell : model.cells) {
        CHECK(cell.volume > 0);
        CHECK_FALSE(cell.owners.empty());
    }
    REQUIRE(model.owners_of_final_face.size() == brep.face_count());
    for (const auto& owners : model.owners_of_final_face) CHECK_FALSE(owners.empty());
}

/// The same solid with its shell turned round, and turned round itself.
TopoDS_Shape turned_twice(const TopoDS_Shape& shape) {
    BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    for (TopExp_Explorer it(shape, TopAbs_SHELL); it.More(); it.Next()) builder.Add(solid, it.Current().Reversed());
    return solid.Reversed();
}

double material_of(const CellModel& model) {
    double volume = 0;
    for (const Cell& cell : model.cells) volume += cell.material ? cell.volume : 0;
    return volume;
}

}  // namespace

TEST_CASE("a lone box is one cell with six faces") {
    const Part part = Part().add("Pad", box(0, 0, 0, 10, 20, 30));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    REQUIRE(model.cells.size() == 1);
    CHECK(model.cells[0].volume == Approx(6000));
    CHECK(model.cells[0].box.size().z == Approx(30).epsilon(1e-5));
    CHECK(model.faces.size() == 6);
}

TEST_CASE("two overlapping boxes are three cells") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).add("B", box(5, 5, 5, 10, 10, 10));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    const auto cells = by_owner(part, model);
    REQUIRE(model.cells.size() == 3);
    CHECK(cells.at({"A"})[0] == Approx(875));
    CHECK(cells.at({"B"})[0] == Approx(875));
    CHECK(cells.at({"A", "B"})[0] == Approx(125));
}

TEST_CASE("a cavity within a box") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).remove("B", box(3, 3, 3, 2, 2, 2));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    const auto cells = by_owner(part, model);
    REQUIRE(model.cells.size() == 2);
    CHECK(cells.at({"A"})[0] == Approx(992));
    CHECK(cells.at({"A", "B"})[0] == Approx(8));
    CHECK(model.faces.size() == 12);
}

TEST_CASE("boxes face to face share one face and keep their coplanar sides apart") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).add("B", box(10, 0, 0, 5, 10, 10));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    REQUIRE(model.cells.size() == 2);
    CHECK(model.faces.size() == 11);
    const auto shared = std::count_if(model.faces.begin(), model.faces.end(), [](const CellFace& f) {
        return f.cells[0].is_valid() && f.cells[1].is_valid() && f.owners.size() == 2;
    });
    CHECK(shared == 1);
}

TEST_CASE("a pocket flush with a face of the block") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).remove("B", box(2, 2, 6, 3, 3, 4));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    const auto cells = by_owner(part, model);
    REQUIRE(model.cells.size() == 2);
    CHECK(cells.at({"A", "B"})[0] == Approx(36));
    CHECK(material_of(model) == Approx(964));
}

TEST_CASE("a tool longer than the part leaves cells outside the material") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).remove("Hole", cylinder({5, 5, -5}, {0, 0, 1}, 2, 20));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    const auto cells = by_owner(part, model);
    REQUIRE(model.cells.size() == 4);
    CHECK(cells.at({"Hole"})[0] == Approx(20 * pi));
    CHECK(cells.at({"Hole"})[1] == Approx(20 * pi));
    CHECK(cells.at({"A", "Hole"})[0] == Approx(40 * pi));
    CHECK(material_of(model) == Approx(1000 - 40 * pi));
}

TEST_CASE("a cylinder tangent to a side of the box it stands in") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).add("B", cylinder({5, 3, 4}, {0, 0, 1}, 3, 12));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    CHECK(material_of(model) == Approx(1000 + 54 * pi));
    CHECK(by_owner(part, model).at({"A", "B"})[0] == Approx(54 * pi));
}

TEST_CASE("the pieces of a solid that was made inside out are cells like any other") {
    const TopoDS_Shape block = box(0, 0, 0, 10, 10, 10);
    FeatureTree tree = Part().add("A", block).remove("B", box(5, 5, 5, 10, 10, 10)).tree();
    // Faces that look inwards, and the same once more turned round as a whole, which is what some sweeps give.
    for (const TopoDS_Shape& tool :
         {TopoDS_Shape(box(5, 5, 5, 10, 10, 10).Reversed()), turned_twice(tree.features[1].volumes[0].shape)}) {
        tree.features[1].volumes[0].shape = tool;
        RunContext context;
        const CellModel model = build_cells(tree, Brep(tree.final_shape), context);
        CHECK(model.report.fallbacks.empty());
        REQUIRE(model.cells.size() == 3);
        double outside = 0;
        for (const Cell& cell : model.cells) outside += cell.material ? 0 : cell.volume;
        CHECK(outside == Approx(1000));
        CHECK(material_of(model) == Approx(875));
        for (const CellFace& face : model.faces) CHECK((face.cells[0].is_valid() || face.cells[1].is_valid()));
    }
}

TEST_CASE("two equal cylinders that cross at right angles") {
    const double r = 3;
    const Part part =
        Part().add("A", cylinder({-10, 0, 0}, {1, 0, 0}, r, 20)).add("B", cylinder({0, -10, 0}, {0, 1, 0}, r, 20));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    const auto cells = by_owner(part, model);
    const double common = 16 * r * r * r / 3;  // Steinmetz
    CHECK(cells.at({"A", "B"})[0] == Approx(common).epsilon(1e-6));
    CHECK(cells.at({"A"}).size() == 2);
    CHECK(cells.at({"B"}).size() == 2);
    CHECK(material_of(model) == Approx(2 * pi * r * r * 20 - common).epsilon(1e-6));
}

TEST_CASE("a pattern whose instances overlap") {
    std::vector<TopoDS_Shape> instances;
    for (int i = 0; i < 4; ++i) instances.push_back(box(2 + 2 * i, 2, -1, 3, 3, 12));
    const Part part = Part().add("A", box(0, 0, 0, 20, 10, 10)).step("Pattern", instances, Effect::removes);
    const CellModel model = cells_of(part);
    check_sound(part, model);
    CHECK(material_of(model) == Approx(2000 - 9 * 3 * 10));
    // In the block: 2 + 1 + 1 + 1 + 1 + 1 + 2 along x; above and below the same again.
    CHECK(model.cells.size() == 1 + 3 * 7);
    std::set<int> volumes;
    for (const Cell& cell : model.cells)
        for (const Owner& owner : cell.owners)
            if (owner.feature == FeatureId(1)) volumes.insert(owner.volume);
    CHECK(volumes == std::set<int>{0, 1, 2, 3});
    CHECK(model.feature_volumes[1] == Approx(9 * 3 * 12));  // what is in two instances counts once
}

TEST_CASE("a hole through another hole of the same radius") {
    const double r = 2;
    const Part part = Part()
                          .add("A", box(-10, -10, -10, 20, 20, 20))
                          .remove("X", cylinder({-10, 0, 0}, {1, 0, 0}, r, 20))
                          .remove("Y", cylinder({0, -10, 0}, {0, 1, 0}, r, 20));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    CHECK(model.cells.size() == 6);
    CHECK(material_of(model) == Approx(8000 - 2 * pi * r * r * 20 + 16 * r * r * r / 3).epsilon(1e-6));
}

TEST_CASE("the same hole twice is one cell with both owners") {
    const Part part = Part()
                          .add("A", box(0, 0, 0, 10, 10, 10))
                          .remove("First", cylinder({5, 5, 0}, {0, 0, 1}, 2, 10))
                          .remove("Second", cylinder({5, 5, 0}, {0, 0, 1}, 2, 10));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    REQUIRE(model.cells.size() == 2);
    CHECK(by_owner(part, model).at({"A", "First", "Second"})[0] == Approx(40 * pi));
}

TEST_CASE("a later feature fills what an earlier one removed") {
    const Part part = Part()
                          .add("A", box(0, 0, 0, 10, 10, 10))
                          .remove("Slot", box(4, 0, 5, 2, 10, 5))
                          .add("Rib", box(0, 4, 5, 10, 2, 5));
    const CellModel model = cells_of(part);
    check_sound(part, model);
    CHECK(material_of(model) == Approx(1000 - 80));
    for (const Cell& cell : model.cells)
        if (cell.owners.size() == 3) CHECK(cell.material);
}

TEST_CASE("a sphere that touches a face from outside in one point") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).add("B", sphere({5, 5, 12}, 2));
    const CellModel model = cells_of(part);
    CHECK(model.cells.size() == 2);
    CHECK(material_of(model) == Approx(1000 + 4.0 / 3 * pi * 8));
}

TEST_CASE("only what all have in common is kept") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).step("B", {sphere({5, 5, 5}, 6)}, Effect::keeps_only);
    const CellModel model = cells_of(part);
    check_sound(part, model);
    const double cap = pi * 1 * (3 * 6 - 1) / 3;
    CHECK(material_of(model) == Approx(4.0 / 3 * pi * 216 - 6 * cap));
    CHECK(model.cells.size() == 1 + 6 + 1);
}

TEST_CASE("the order of independent features does not change the cells") {
    const auto block = box(0, 0, 0, 30, 20, 10);
    const auto boss = cylinder({8, 10, 0}, {0, 0, 1}, 4, 18), rib = box(5, 8, 9, 20, 4, 6),
               hole = cylinder({25, 5, -1}, {0, 0, 1}, 2, 12);
    const Part one = Part().add("Block", block).add("Boss", boss).add("Rib", rib).remove("Hole", hole);
    const Part other = Part().add("Block", block).remove("Hole", hole).add("Rib", rib).add("Boss", boss);
    const auto first = by_owner(one, cells_of(one)), second = by_owner(other, cells_of(other));
    REQUIRE(first.size() == second.size());
    for (const auto& [owners, volumes] : first) {
        REQUIRE(second.count(owners) == 1);
        REQUIRE(second.at(owners).size() == volumes.size());
        for (std::size_t i = 0; i < volumes.size(); ++i) CHECK(second.at(owners)[i] == Approx(volumes[i]));
    }
}

TEST_CASE("the same input gives the same cells in the same order") {
    const Part part =
        Part().add("A", box(0, 0, 0, 10, 10, 10)).add("B", box(5, 5, 5, 10, 10, 10)).remove("C", sphere({5, 5, 5}, 4));
    const CellModel one = cells_of(part), other = cells_of(part);
    REQUIRE(one.cells.size() == other.cells.size());
    for (std::size_t i = 0; i < one.cells.size(); ++i) {
        CHECK(one.cells[i].owners == other.cells[i].owners);
        CHECK(one.cells[i].volume == other.cells[i].volume);
    }
}

TEST_CASE("a final shape that the tree does not explain is reported, and the tree distrusted") {
    Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).remove("Hole", cylinder({5, 5, 0}, {0, 0, 1}, 2, 10));
    FeatureTree tree = part.tree();
    tree.final_shape = BRepAlgoAPI_Cut(box(0, 0, 0, 10, 10, 10), cylinder({5, 5, 0}, {0, 0, 1}, 3, 10)).Shape();
    RunContext context;
    const CellModel model = build_cells(tree, Brep(tree.final_shape), context);
    CHECK_FALSE(model.report.fallbacks.empty());
    CHECK(model.report.material_volume == Approx(1000 - 90 * pi));
    CHECK(model.report.untrusted == std::vector<FeatureId>{FeatureId(0)});
    for (const auto& owners : model.owners_of_final_face) CHECK_FALSE(owners.empty());
    for (const CellFace& face : model.faces) CHECK_FALSE(face.owners.empty());
}

TEST_CASE("volumes of a part of thousandths of a millimetre are told") {
    Part part = Part().add("A", box(0, 0, 0, 0.001, 0.001, 0.001)).remove("B", box(0, 0, 0, 0.0005, 0.001, 0.001));
    FeatureTree tree = part.tree();
    tree.final_shape = box(0, 0, 0, 0.001, 0.001, 0.00075);
    RunContext context;
    const auto notes = build_cells(tree, Brep(tree.final_shape), context).report.fallbacks;
    INFO(notes.front());
    CHECK(notes.front().find(" mm^3 where the final shape has 7.5e-10 mm^3") != std::string::npos);
}

TEST_CASE("a tree without any volume is one opaque cell") {
    FeatureTree tree;
    tree.object = "Lost";
    tree.final_shape = box(0, 0, 0, 1, 2, 3);
    tree.features.emplace_back().name = "Lost";
    RunContext context;
    const CellModel model = build_cells(tree, Brep(tree.final_shape), context);
    REQUIRE(model.cells.size() == 1);
    CHECK(model.cells[0].material);
    CHECK(model.report.fallbacks.size() == 1);
}

TEST_CASE("a cancelled fuse throws, on any number of threads") {
    const Part part = Part().add("A", box(0, 0, 0, 10, 10, 10)).add("B", box(5, 5, 5, 10, 10, 10));
    const Brep brep(part.tree().final_shape);
    RunContext context;
    context.threads = GENERATE(1, 4);
    context.on_progress = [](std::string_view, double) { return false; };
    CHECK_THROWS_AS(build_cells(part.tree(), brep, context), Cancelled);
}

TEST_CASE("the cells are the same for any number of threads") {
    Part part = Part().add("A", box(0, 0, 0, 60, 60, 20));
    for (int i = 0; i < 12; ++i) {
        const gp_Pnt foot{8.0 + 11 * (i % 4), 10.0 + 18 * (i / 4), -1};
        part.remove("Hole" + std::to_string(i), cylinder(foot, {0.2, 0.05 * i, 1}, 5, 30));
    }
    RunContext one, four;
    four.threads = 4;
    const Brep brep(part.tree().final_shape);
    const CellModel a = build_cells(part.tree(), brep, one), b = build_cells(part.tree(), brep, four);
    REQUIRE(a.cells.size() == b.cells.size());
    REQUIRE(a.faces.size() == b.faces.size());
    for (std::size_t c = 0; c < a.cells.size(); ++c) {
        CHECK(a.cells[c].volume == b.cells[c].volume);
        CHECK(a.cells[c].owners == b.cells[c].owners);
        CHECK(a.cells[c].box.low == b.cells[c].box.low);
    }
    for (std::size_t f = 0; f < a.faces.size(); ++f) CHECK(a.faces[f].owners == b.faces[f].owners);
}

TEST_CASE("overlapping solids of the final shape are reported") {
    const FeatureTree tree = compound_of(box(0, 0, 0, 10, 10, 10), box(5, 5, 5, 10, 10, 10));
    RunContext context;
    const CellModel model = build_cells(tree, Brep(tree.final_shape), context);
    CHECK(model.cells.size() == 3);
    CHECK(model.report.material_volume == Approx(1875));
    CHECK(model.report.fallbacks.empty());
    REQUIRE(model.report.findings.size() == 1);
    CHECK(model.report.findings[0].in_english().find("overlap by 125") != std::string::npos);
}

TEST_CASE("a solid inside another one is counted twice, in either order, and nothing there is empty") {
    for (const bool is_inner_first : {true, false}) {
        const TopoDS_Shape outer = box(0, 0, 0, 10, 10, 10), inner = box(3, 3, 3, 4, 4, 4);
        const FeatureTree tree = is_inner_first ? compound_of(inner, outer) : compound_of(outer, inner);
        RunContext context;
        const CellModel model = build_cells(tree, Brep(tree.final_shape), context);
        CHECK(model.report.fallbacks.empty());
        CHECK(model.report.material_volume == Approx(1000));
        CHECK(material_of(model) == Approx(1000));
        REQUIRE(model.report.findings.size() == 1);
        CHECK(model.report.findings[0].in_english().find("overlap by 64") != std::string::npos);
    }
}

TEST_CASE("a volume that crosses itself is replaced by what changed between before and after") {
    // Two solids of one volume that overlap: their cells cannot add up to it.
    TopoDS_Compound twice;
    BRep_Builder builder;
    builder.MakeCompound(twice);
    builder.Add(twice, box(2, 2, 5, 4, 4, 10));
    builder.Add(twice, box(4, 4, 5, 4, 4, 10));
    Part part = Part().add("Pad", box(0, 0, 0, 10, 10, 10)).add("Pipe", twice);
    FeatureTree tree = part.tree();
    tree.features[1].before = box(0, 0, 0, 10, 10, 10);
    tree.features[1].after = tree.final_shape =
        BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(box(0, 0, 0, 10, 10, 10), box(2, 2, 5, 4, 4, 10)).Shape(),
                         box(4, 4, 5, 4, 4, 10))
            .Shape();
    RunContext context;
    const CellModel model = build_cells(tree, Brep(tree.final_shape), context);
    CHECK(model.report.material_volume == Approx(1000 + 28 * 5));
    for (const auto& owners : model.owners_of_final_face) CHECK_FALSE(owners.empty());
}

TEST_CASE("where two solids of the final shape touch, both faces have owners") {
    const FeatureTree tree = compound_of(box(0, 0, 0, 10, 10, 10), box(10, 2, 2, 5, 5, 5));
    RunContext context;
    const CellModel model = build_cells(tree, Brep(tree.final_shape), context);
    CHECK(model.report.fallbacks.empty());
    REQUIRE(model.owners_of_final_face.size() == 12);
    for (const auto& owners : model.owners_of_final_face) CHECK_FALSE(owners.empty());
}

TEST_CASE("a fuse that is too much work says so and throws nothing") {
    RunContext context;
    const FusedComplex complex =
        fuse({{{FeatureId(0), 0}, box(0, 0, 0, 10, 10, 10)}, {{FeatureId(1), 0}, box(5, 5, 5, 10, 10, 10)}},
             {.fuzzy = 0, .work = 0}, context);
    CHECK(complex.cells.empty());
    CHECK(complex.trouble.find("too much work") != std::string::npos);
}

TEST_CASE("a fuse is as much work with any number of threads, and stops at the limit or not at all") {
    std::vector<FuseArgument> arguments{{{FeatureId(0), 0}, box(0, 0, 0, 60, 60, 10)}};
    for (int i = 1; i < 10; ++i)
        arguments.push_back({{FeatureId(std::size_t(i)), 0}, cylinder({6.0 * i, 6.0 * i, -1}, {0, 0, 1}, 4, 18)});
    RunContext context;
    const FusedComplex alone = fuse(arguments, {}, context);
    CHECK(alone.trouble.empty());
    for (const int threads : {2, 4}) {
        context.threads = threads;
        CHECK(fuse(arguments, {}, context).work == alone.work);
        CHECK(fuse(arguments, {.work = alone.work}, context).is_over_limit);
        CHECK_FALSE(fuse(arguments, {.work = alone.work + 1}, context).is_over_limit);
    }
}

TEST_CASE("fused one by one, the cells and their owners are the same") {
    const std::vector<FuseArgument> arguments{{{FeatureId(0), 0}, box(0, 0, 0, 30, 20, 10)},
                                              {{FeatureId(1), 0}, cylinder({8, 10, 0}, {0, 0, 1}, 4, 18)},
                                              {{FeatureId(2), 0}, box(5, 8, 9, 20, 4, 6)},
                                              {{FeatureId(3), 0}, cylinder({25, 5, -1}, {0, 0, 1}, 2, 12)},
                                              {{FeatureId(4), 0}, box(30, 0, 0, 5, 20, 10)}};
    RunContext context;
    const auto owned = [](const FusedComplex& complex) {
        std::multimap<std::vector<Owner>, double> cells;
        std::multiset<std::vector<Owner>> faces;
        for (const Cell& cell : complex.cells) cells.emplace(cell.owners, std::round(1e6 * cell.volume) / 1e6);
        for (const CellFace& face : complex.faces) faces.insert(face.owners);
        return std::pair(cells, faces);
    };
    const FusedComplex at_once = fuse(arguments, {}, context), one_by_one = fuse_one_by_one(arguments, {}, context);
    CHECK(one_by_one.trouble.empty());
    CHECK(one_by_one.offenders.empty());
    CHECK(at_once.cells.size() > 6);
    CHECK(owned(at_once) == owned(one_by_one));
    CHECK_FALSE(fuse_one_by_one(arguments, {.fuzzy = 0, .work = 0}, context).trouble.empty());
}

TEST_CASE("fused one by one, an argument that does not add up is named") {
    RunContext context;
    const FusedComplex complex = fuse_one_by_one({{{FeatureId(0), 0}, box(0, 0, 0, 10, 10, 10)},
                                                  {{FeatureId(1), 0}, box(5, 5, 5, 10, 10, 10)},
                                                  {{FeatureId(1), 0}, box(8, 8, 8, 10, 10, 10)}},
                                                 {}, context);
    CHECK(complex.offenders == std::vector<Owner>{{FeatureId(1), 0}});
    CHECK(complex.cells.size() > 3);
}

TEST_CASE("what cannot be fused is taken as one piece, and later features keep their cells") {
    TopoDS_Compound twice;
    BRep_Builder builder;
    builder.MakeCompound(twice);
    builder.Add(twice, box(0, 0, 0, 10, 10, 10));
    builder.Add(twice, box(5, 5, 5, 10, 10, 10));
    const TopoDS_Shape united = BRepAlgoAPI_Fuse(box(0, 0, 0, 10, 10, 10), box(5, 5, 5, 10, 10, 10)).Shape();
    const TopoDS_Shape hole = cylinder({2, 2, 0}, {0, 0, 1}, 1, 10);
    // What FreeCAD made of the pipe differs from its volume, so that the books cannot close with it.
    const TopoDS_Shape shown = BRepAlgoAPI_Fuse(united, box(-5, 0, 0, 5, 5, 5)).Shape();
    Part part = Part().add("Pipe", twice).remove("Hole", hole);
    FeatureTree tree = part.tree();
    tree.features[1].before = shown;
    tree.features[1].after = tree.final_shape = BRepAlgoAPI_Cut(shown, hole).Shape();
    RunContext context;
    const CellModel model = build_cells(tree, Brep(tree.final_shape), context);
    CHECK(material_of(model) == Approx(1875 + 125 - 10 * pi));
    REQUIRE(model.cells.size() == 2);
    const auto is_hole = [](const Cell& cell) { return cell.owners.size() == 2; };
    CHECK(std::count_if(model.cells.begin(), model.cells.end(), is_hole) == 1);
    CHECK(model.report.untrusted == std::vector<FeatureId>{FeatureId(0)});
    CHECK_FALSE(model.report.fallbacks.empty());
}
