// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/feature_tree.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <gp_Trsf.hxx>
#include <numbers>
#include <set>

#include "brep/booleans/shape_difference.h"
#include "brep/occt_geometry.h"
#include "brep/same_faces.h"
#include "brep/volumes/flux.h"
#include "catch.h"
#include "core/errors.h"
#include "documents.h"

using namespace featuremesh;
using namespace featuremesh::test;
constexpr double pi = std::numbers::pi;

namespace {

double volume(const FeatureVolume& v) { return flux(v.shape, {}); }
const Feature& named(const FeatureTree& tree, const std::string& name) { return tree[tree.find(name).value()]; }

TopoDS_Shape with_round_edge(const TopoDS_Shape& shape, double radius) {
    BRepFilletAPI_MakeFillet fillet(shape);
    fillet.Add(radius, TopoDS::Edge(TopExp_Explorer(shape, TopAbs_EDGE).Current()));
    return fillet.Shape();
}

/// Plate, pocket, hole, round edge, as in a body.
DocumentMaker plate() {
    const TopoDS_Shape pad = box(0, 0, 0, 40, 20, 5);
    const TopoDS_Shape pocket_tool = box(5, 5, 3, 6, 6, 2), pocket = cut(pad, pocket_tool);
    const TopoDS_Shape hole_tool = cylinder({20, 10, -3}, {0, 0, 1}, 2, 11), hole = cut(pocket, hole_tool);
    DocumentMaker maker;
    maker.add("Sketch", "Sketcher::SketchObject");
    maker.add("Pad", "PartDesign::Pad", {{"Profile", "Sketch", ""}}, pad, pad).numbers["Length"] = 5;
    maker.add("Pocket", "PartDesign::Pocket", {{"BaseFeature", "Pad", ""}}, pocket, pocket_tool);
    maker.add("Hole", "PartDesign::Hole", {{"BaseFeature", "Pocket", ""}}, hole, hole_tool);
    return maker;
}

TopoDS_Shape plate_shape() {
    return cut(cut(box(0, 0, 0, 40, 20, 5), box(5, 5, 3, 6, 6, 2)), cylinder({20, 10, -3}, {0, 0, 1}, 2, 11));
}

std::vector<RawLink> body_links(const std::vector<std::string>& members) {
    std::vector<RawLink> links;
    for (const std::string& member : members) links.push_back({"Group", member, ""});
    links.push_back({"Tip", members.back(), ""});
    return links;
}

}  // namespace

TEST_CASE("a body is read as the chain of its features") {
    DocumentMaker maker = plate();
    maker.add("Body", "PartDesign::Body", body_links({"Pad", "Pocket", "Hole"}), plate_shape());
    const FeatureTree tree = interpret(maker.done());
    CHECK(tree.object == "Body");
    REQUIRE(tree.features.size() == 5);
    CHECK(named(tree, "Sketch").role == Role::reference);
    CHECK(named(tree, "Sketch").volumes.empty());
    const Feature& pad = named(tree, "Pad");
    CHECK(pad.role == Role::additive);
    CHECK(pad.volume_source == "own");
    CHECK(pad.depends_on == std::vector<FeatureId>{FeatureId(0)});
    CHECK(pad.parameters == std::vector<std::pair<std::string, double>>{{"Length", 5}});
    REQUIRE(pad.volumes.size() == 1);
    CHECK(pad.volumes[0].effect == Effect::adds);
    CHECK(volume(pad.volumes[0]) == Approx(4000));
    const Feature& hole = named(tree, "Hole");
    CHECK(hole.role == Role::subtractive);
    CHECK(hole.at_centres);
    CHECK_FALSE(named(tree, "Pocket").at_centres);
    REQUIRE(hole.volumes.size() == 1);
    CHECK(hole.volumes[0].effect == Effect::removes);
    CHECK(volume(hole.volumes[0]) == Approx(44 * pi));
    CHECK(hole.operands == std::vector<FeatureId>{FeatureId(2)});
    CHECK(named(tree, "Body").combination == Combination::pass);
    CHECK(named(tree, "Body").volumes.empty());
    CHECK(tree.notes.empty());
}

TEST_CASE("an import and copies of it are known by their shapes alone") {
    DocumentMaker maker = plate();
    maker.add("File", "Part::Feature", {}, box(0, 0, 0, 1, 1, 1));
    maker.add("Copy", "Part::Mirroring", {{"Source", "File", ""}}, box(0, 0, 0, 1, 1, 1));
    maker.add("CopyOfHole", "Part::Mirroring", {{"Source", "Hole", ""}}, plate_shape());
    const FeatureTree tree = interpret(maker.done());
    for (const Feature& feature : tree.features)
        CHECK(tree.is_import(*tree.find(feature.name)) == (feature.name == "File" || feature.name == "Copy"));
}

TEST_CASE("a fillet is what it adds and removes, also when no face is shared any more") {
    for (const bool reopened : {false, true}) {
        DocumentMaker maker = plate();
        const TopoDS_Shape before = plate_shape();
        // The plate of the document was made anew, so its faces are other ones than those of `before` anyway.
        TopoDS_Shape after = with_round_edge(before, 1);
        if (reopened) after = BRepBuilderAPI_Copy(after).Shape();
        maker.add("Fillet", "PartDesign::Fillet", {{"Base", "Hole", "Edge1"}, {"BaseFeature", "Hole", ""}}, after);
        const FeatureTree tree = interpret(maker.done());
        const Feature& fillet = named(tree, "Fillet");
        CHECK(fillet.role == Role::dress_up);
        CHECK(fillet.volume_source == "before and after");
        REQUIRE(fillet.volumes.size() == 1);
        CHECK(fillet.volumes[0].effect == Effect::removes);
        CHECK(volume(fillet.volumes[0]) == Approx(flux(before, {}) - flux(after, {})).epsilon(1e-6));
    }
}

TEST_CASE("holes that faces before and after have in common are no part of what changed between them") {
    const auto top = [](double second_radius) {
        const TopoDS_Shape first = cut(box(0, 0, 0, 40, 20, 5), cylinder({10, 10, -1}, {0, 0, 1}, 2, 7));
        return unshared_faces(cut(first, cylinder({30, 10, -1}, {0, 0, 1}, second_radius, 7)), box(0, 0, 0, 40, 20, 5));
    };
    const auto wires = [](const std::vector<TopoDS_Shape>& faces) {
        int count = 0;
        for (const TopoDS_Shape& face : faces)
            for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next()) ++count;
        return count;
    };
    const auto area = [](const std::vector<TopoDS_Shape>& faces) {
        GProp_GProps sum;
        for (const TopoDS_Shape& face : faces)
            if (BRepAdaptor_Surface(TopoDS::Face(face)).GetType() == GeomAbs_Plane) {
                GProp_GProps one;
                BRepGProp::SurfaceProperties(face, one);
                sum.Add(one);
            }
        return sum.Mass();
    };
    const auto before = top(2), after = top(3);  // two walls with a wire each, top and bottom with three
    REQUIRE(wires(before) == 8);
    const auto simpler = without_common_holes(before, after);
    CHECK(simpler.size() == before.size());
    CHECK(wires(simpler) == 6);
    CHECK(area(simpler) == Approx(2 * (800 - pi * 4)));
    CHECK(wires(without_common_holes(before, {})) == 8);
}

TEST_CASE("reading ends when it is not wanted any more") {
    DocumentMaker maker = plate();
    maker.add("Fillet", "PartDesign::Fillet", {{"Base", "Hole", "Edge1"}, {"BaseFeature", "Hole", ""}},
              with_round_edge(plate_shape(), 1));
    RunContext context;
    context.on_progress = [](std::string_view, double) { return false; };
    CHECK_THROWS_AS(interpret(maker.done(), context), Cancelled);
}

TEST_CASE("a pad without a volume of its own is had from before and after") {
    const TopoDS_Shape pad = box(0, 0, 0, 10, 10, 10), after = fused(pad, box(2, 2, 5, 3, 3, 10));
    DocumentMaker maker;
    maker.add("Pad", "PartDesign::Pad", {}, pad);
    maker.add("Boss", "PartDesign::Pad", {{"BaseFeature", "Pad", ""}}, after);
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "Pad").volume_source == "shape");
    REQUIRE(named(tree, "Boss").volumes.size() == 1);
    CHECK(named(tree, "Boss").volumes[0].effect == Effect::adds);
    CHECK(volume(named(tree, "Boss").volumes[0]) == Approx(45));
}

TEST_CASE("before there were bodies the chain runs through the sketch's support") {
    const TopoDS_Shape pad = box(0, 0, 0, 10, 10, 10), tool = box(2, 2, 5, 3, 3, 5);
    DocumentMaker maker;
    maker.add("Pad", "PartDesign::Pad", {}, pad, pad);
    maker.add("Sketch", "Sketcher::SketchObject", {{"Support", "Pad", "Face6"}});
    maker.add("Pocket", "PartDesign::Pocket", {{"Profile", "Sketch", ""}}, cut(pad, tool), tool);
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "Pocket").operands == std::vector<FeatureId>{FeatureId(0)});
    CHECK(named(tree, "Pad").volumes.size() == 1);
}

TEST_CASE("a linear pattern is one volume per further occurrence, placed by its parameters") {
    const TopoDS_Shape pad = box(0, 0, 0, 40, 10, 5), tool = cylinder({5, 5, -1}, {0, 0, 1}, 2, 7),
                       first = cut(pad, tool);
    TopoDS_Shape after = first;
    for (int i = 1; i < 4; ++i) after = cut(after, cylinder({5.0 + 10 * i, 5, -1}, {0, 0, 1}, 2, 7));
    DocumentMaker maker;
    maker.add("Sketch", "Sketcher::SketchObject");
    maker.add("Pad", "PartDesign::Pad", {}, pad, pad);
    maker.add("Pocket", "PartDesign::Pocket", {{"BaseFeature", "Pad", ""}}, first, tool);
    RawRecord& pattern = maker.add(
        "Pattern", "PartDesign::LinearPattern",
        {{"BaseFeature", "Pocket", ""}, {"Originals", "Pocket", ""}, {"Direction", "Sketch", "H_Axis"}}, after);
    pattern.numbers = {{"Length", 30}, {"Occurrences", 4}};
    SECTION("along the direction") {}
    SECTION("against it: the shapes decide, not the flag") { pattern.numbers["Reversed"] = 1; }
    const FeatureTree tree = interpret(maker.done());
    const Feature& feature = named(tree, "Pattern");
    CHECK(feature.role == Role::pattern);
    CHECK(feature.volume_source == "instances");
    REQUIRE(feature.volumes.size() == 3);
    for (int i = 0; i < 3; ++i) {
        CHECK(feature.volumes[i].instance == i + 1);
        CHECK(feature.volumes[i].effect == Effect::removes);
        CHECK(distance(feature.volumes[i].motion.apply({0, 0, 0}), {10.0 * (i + 1), 0, 0}) < 1e-9);
        CHECK(feature.volumes[i].shape.IsPartner(named(tree, "Pocket").volumes[0].shape));
    }
}

TEST_CASE("a pattern that repeats nothing known is its own shape") {
    DocumentMaker maker;
    const TopoDS_Shape pad = box(0, 0, 0, 40, 10, 5);
    maker.add("Pattern", "PartDesign::LinearPattern", {}, pad, pad);
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "Pattern").operands.empty());
    CHECK(named(tree, "Pattern").volumes.size() == 1);
}

TEST_CASE("polar patterns and mirrors") {
    const TopoDS_Shape disc = cylinder({0, 0, 0}, {0, 0, 1}, 20, 5), tool = box(10, 2, -1, 4, 3, 7),
                       first = cut(disc, tool);
    const auto with = [&](const gp_Trsf& t) { return cut(first, tool.Moved(TopLoc_Location(t))); };
    DocumentMaker maker;
    maker.add("Sketch", "Sketcher::SketchObject");
    maker.add("Pad", "PartDesign::Pad", {}, disc, disc);
    maker.add("Pocket", "PartDesign::Pocket", {{"BaseFeature", "Pad", ""}}, first, tool);
    SECTION("half a turn") {
        gp_Trsf turn;
        turn.SetRotation(gp::OZ(), pi);
        RawRecord& pattern = maker.add(
            "Pattern", "PartDesign::PolarPattern",
            {{"BaseFeature", "Pocket", ""}, {"Originals", "Pocket", ""}, {"Axis", "Sketch", "N_Axis"}}, with(turn));
        pattern.numbers = {{"Angle", 360}, {"Occurrences", 2}};
        const FeatureTree tree = interpret(maker.done());
        REQUIRE(named(tree, "Pattern").volumes.size() == 1);
        CHECK(named(tree, "Pattern").volume_source == "instances");
        CHECK(distance(named(tree, "Pattern").volumes[0].motion.apply({1, 0, 0}), {-1, 0, 0}) < 1e-12);
    }
    SECTION("a mirror at the sketch's vertical axis") {
        maker.add("Mirror", "PartDesign::Mirrored",
                  {{"BaseFeature", "Pocket", ""}, {"Originals", "Pocket", ""}, {"MirrorPlane", "Sketch", "V_Axis"}},
                  cut(first, box(-14, 2, -1, 4, 3, 7)));
        const FeatureTree tree = interpret(maker.done());
        REQUIRE(named(tree, "Mirror").volumes.size() == 1);
        CHECK(named(tree, "Mirror").volume_source == "instances");
        CHECK(volume(named(tree, "Mirror").volumes[0]) == Approx(84));
    }
    SECTION("parameters that do not fit the shapes: before and after decide") {
        RawRecord& pattern =
            maker.add("Pattern", "PartDesign::LinearPattern",
                      {{"BaseFeature", "Pocket", ""}, {"Originals", "Pocket", ""}, {"Direction", "Sketch", "H_Axis"}},
                      cut(first, box(-14, 2, -1, 4, 3, 7)));
        pattern.numbers = {{"Length", 7}, {"Occurrences", 2}};
        const FeatureTree tree = interpret(maker.done());
        CHECK(named(tree, "Pattern").volume_source == "before and after");
        REQUIRE(named(tree, "Pattern").volumes.size() == 1);
        CHECK(volume(named(tree, "Pattern").volumes[0]) == Approx(60));
    }
}

TEST_CASE("the leaves of a Part tree have volumes, its booleans none") {
    const TopoDS_Shape a = box(0, 0, 0, 10, 10, 10), b = cylinder({5, 5, -1}, {0, 0, 1}, 3, 12),
                       c = box(0, 0, 0, 5, 5, 5), d = box(4, 4, 4, 20, 20, 20);
    DocumentMaker maker;
    maker.add("A", "Part::Box", {}, a);
    maker.add("B", "Part::Cylinder", {}, b);
    maker.add("C", "Part::Box", {}, c);
    maker.add("D", "Part::Box", {}, d);
    maker.add("Tool", "Part::Cut", {{"Base", "B", ""}, {"Tool", "C", ""}}, cut(b, c));
    maker.add("Cut", "Part::Cut", {{"Base", "A", ""}, {"Tool", "Tool", ""}}, cut(a, cut(b, c)));
    maker.add("Common", "Part::MultiCommon", {{"Shapes", "Cut", ""}, {"Shapes", "D", ""}},
              BRepAlgoAPI_Common(cut(a, cut(b, c)), d).Shape());
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "A").volumes.at(0).effect == Effect::adds);
    CHECK(named(tree, "B").volumes.at(0).effect == Effect::removes);
    CHECK(named(tree, "C").volumes.at(0).effect == Effect::adds);  // taken from what is taken away
    CHECK(named(tree, "D").volumes.at(0).effect == Effect::keeps_only);
    for (const char* name : {"Tool", "Cut", "Common"}) {
        CHECK(named(tree, name).role == Role::boolean);
        CHECK(named(tree, name).volumes.empty());
        CHECK(named(tree, name).operands.size() == 2);
    }
}

TEST_CASE("a body with a boolean of another body") {
    const TopoDS_Shape a = box(0, 0, 0, 10, 10, 10), b = box(2, 2, 2, 20, 3, 3), pin = box(15, 2, 2, 2, 3, 3),
                       tool = cut(b, pin);
    DocumentMaker maker;
    maker.add("Pad", "PartDesign::Pad", {}, a, a);
    maker.add("ToolPad", "PartDesign::Pad", {}, b, b);
    maker.add("ToolPocket", "PartDesign::Pocket", {{"BaseFeature", "ToolPad", ""}}, tool, pin);
    maker.add("ToolBody", "PartDesign::Body", body_links({"ToolPad", "ToolPocket"}), tool);
    RawRecord& boolean = maker.add("Boolean", "PartDesign::Boolean",
                                   {{"BaseFeature", "Pad", ""}, {"Group", "ToolBody", ""}}, cut(a, tool));
    boolean.texts["Type"] = "Cut";
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "ToolPad").volumes.at(0).effect == Effect::removes);
    CHECK(named(tree, "ToolPad").volumes.at(0).step == Effect::adds);
    CHECK(named(tree, "ToolPocket").volumes.at(0).effect == Effect::adds);
    CHECK(named(tree, "ToolPocket").volumes.at(0).step == Effect::removes);
}

TEST_CASE("a suppressed feature has no volume") {
    const TopoDS_Shape pad = box(0, 0, 0, 10, 10, 10), tool = box(2, 2, 5, 3, 3, 5);
    DocumentMaker maker;
    maker.add("Pad", "PartDesign::Pad", {}, pad, pad);
    maker.add("Pocket", "PartDesign::Pocket", {{"BaseFeature", "Pad", ""}}, pad, tool).suppressed = true;
    maker.add("Body", "PartDesign::Body", body_links({"Pad", "Pocket"}), pad);
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "Pocket").suppressed);
    CHECK(named(tree, "Pocket").volumes.empty());
    CHECK(named(tree, "Pad").volumes.size() == 1);
}

TEST_CASE("a feature in error is noted with FreeCAD's words") {
    DocumentMaker maker;
    const TopoDS_Shape pad = box(0, 0, 0, 10, 10, 10);
    maker.add("Pad", "PartDesign::Pad", {}, pad, pad);
    maker.add("Fillet", "PartDesign::Fillet", {{"BaseFeature", "Pad", ""}}).error =
        "Fillet not possible on selected shapes";
    maker.add("Body", "PartDesign::Body", body_links({"Pad"}), pad);
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "Fillet").error == "Fillet not possible on selected shapes");
    REQUIRE(tree.notes.size() == 1);
    CHECK(tree.notes[0].in_english().find("Fillet not possible") != std::string::npos);
}

TEST_CASE("what a feature did is looked for with so much work, the same for any number of threads") {
    const TopoDS_Shape upright = box(0, 0, 0, 10, 10, 10);
    gp_Trsf shift;
    shift.SetTranslation({0.5, 0, 0});  // a side crosses the one it was, which only the kernel can tell
    const TopoDS_Shape slanting =
        BRepBuilderAPI_Transform(BRepPrimAPI_MakeWedge(10, 10, 10, 0, 0, 9, 10).Shape(), shift).Shape();
    std::set<Work> works;
    for (const int threads : {1, 2, 4}) {
        RunContext context;
        context.threads = threads;
        const ShapeDifference enough = difference_of(upright, slanting, work_of_seconds(1), context);
        CHECK(enough.closed);
        CHECK(enough.work > 0);
        CHECK(enough.work < work_of_seconds(1));
        works.insert(enough.work);
        const ShapeDifference little = difference_of(upright, slanting, enough.work / 10, context);
        CHECK_FALSE(little.closed);
        CHECK_FALSE(little.is_hopeless);
        CHECK(little.work <= enough.work / 10);
        const ShapeDifference known = difference_of(upright, slanting, work_of_seconds(1), context, &enough);
        CHECK(known.closed);
        CHECK(known.work == 0);
    }
    CHECK(works.size() == 1);
}

TEST_CASE("an unknown type is one opaque volume") {
    DocumentMaker maker;
    maker.add("Gear", "Part::FeaturePython", {}, box(0, 0, 0, 1, 1, 1)).proxy = "InvoluteGear";
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "Gear").role == Role::opaque);
    CHECK(named(tree, "Gear").volumes.size() == 1);
}

TEST_CASE("a link in the same place passes on what it links to, one elsewhere is a volume") {
    const TopoDS_Shape solid = box(0, 0, 0, 1, 2, 3);
    gp_Trsf away;
    away.SetTranslation(gp_Vec(5, 0, 0));
    for (const bool moved : {false, true}) {
        DocumentMaker maker;
        maker.add("Box", "Part::Box", {}, solid);
        maker.add("Link", "App::Link", {{"LinkedObject", "Box", ""}},
                  moved ? solid.Moved(TopLoc_Location(away)) : solid);
        const FeatureTree tree = interpret(maker.done());
        CHECK(named(tree, "Box").volumes.size() == (moved ? 0u : 1u));
        CHECK(named(tree, "Link").volumes.size() == (moved ? 1u : 0u));
        CHECK(named(tree, "Link").depends_on.size() == 1);
    }
}

TEST_CASE("an array has one volume per element, with its motion") {
    const TopoDS_Shape element = box(0, 0, 0, 1, 1, 1);
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 0; i < 3; ++i) {
        gp_Trsf shift;
        shift.SetTranslation(gp_Vec(2 * i, 0, 0));
        builder.Add(all, element.Moved(TopLoc_Location(shift)));
    }
    DocumentMaker maker;
    maker.add("Box", "Part::Box", {}, element);
    maker.add("Array", "Part::FeaturePython", {{"Base", "Box", ""}}, all).proxy = "Array";
    const FeatureTree tree = interpret(maker.done());
    REQUIRE(named(tree, "Array").volumes.size() == 3);
    CHECK(named(tree, "Array").volumes[2].motion.translation == Vec3{4, 0, 0});
}

TEST_CASE("links that dangle and loops do no harm") {
    DocumentMaker maker;
    maker.add("Cut", "Part::Cut", {{"Base", "Gone", ""}, {"Tool", "Cut", ""}}, box(0, 0, 0, 1, 1, 1));
    const FeatureTree tree = interpret(maker.done());
    CHECK(named(tree, "Cut").volumes.size() == 1);
    CHECK(named(tree, "Cut").depends_on.empty());
    REQUIRE(tree.notes.size() == 1);
    CHECK(tree.notes[0].in_english() == "Cut: its link to Gone leads to nothing");
}

TEST_CASE("what has no solid is named, and counts as changed where it should have one") {
    DocumentMaker maker = plate();
    maker.add("Fillet", "PartDesign::Fillet", {{"Base", "Hole", "Edge1"}, {"BaseFeature", "Hole", ""}});
    maker.add("Empty", "Part::Feature");
    maker.add("Fusion", "Part::MultiFuse", {{"Shapes", "Fillet", ""}, {"Shapes", "Hole", ""}, {"Shapes", "Empty", ""}},
              plate_shape());
    const FeatureTree tree = interpret(maker.done());
    const auto says = [&](const std::string& words) {
        return std::any_of(tree.notes.begin(), tree.notes.end(),
                           [&](const auto& note) { return note.in_english() == words; });
    };
    CHECK(says("Fusion: its operand Fillet has no solid and is left out"));
    CHECK(says("Fusion: its operand Empty has no solid and is left out"));
}

TEST_CASE("a document without the object or without a solid is refused by name") {
    DocumentMaker maker;
    maker.add("Sketch", "Sketcher::SketchObject");
    RawDocument document = maker.done();
    CHECK_THROWS_AS(interpret(document), InputError);
    CHECK_THROWS_WITH(interpret(document), Catch::Contains("Sketch"));
    document.final_object = "Nobody";
    CHECK_THROWS_WITH(interpret(document), Catch::Contains("Nobody"));
}

namespace {
/// A plate with a slot, and a second object that shows it elsewhere.
RawDocument plate_and(const std::string& type, const std::string& link, const gp_Trsf& to, bool plate_too,
                      const RawRecord& like) {
    const TopoDS_Shape pad = box(0, 0, 0, 20, 10, 5), slot = box(3, 2, -1, 4, 3, 7), plate = cut(pad, slot);
    const TopoDS_Shape copy = BRepBuilderAPI_Transform(plate, to, true).Shape();
    DocumentMaker maker;
    maker.add("Pad", "PartDesign::Pad", {}, pad, pad);
    maker.add("Pocket", "PartDesign::Pocket", {{"BaseFeature", "Pad", ""}}, plate, slot);
    maker.add("Body", "PartDesign::Body", body_links({"Pad", "Pocket"}), plate);
    RawRecord& other = maker.add("Other", type, {{link, "Body", ""}}, copy);
    other.numbers = like.numbers;
    other.placement = other.global_placement = like.global_placement;
    if (plate_too)
        maker.add("Both", "Part::MultiFuse", {{"Shapes", "Other", ""}, {"Shapes", "Body", ""}}, fused(plate, copy));
    return maker.done();
}

void check_copied(const FeatureTree& tree, bool plate_too) {
    const Feature& other = named(tree, "Other");
    CHECK(other.volume_source == "copies");
    REQUIRE(other.volumes.size() == 2);
    CHECK(other.volumes[0].effect == Effect::adds);
    CHECK(other.volumes[1].effect == Effect::removes);
    CHECK(volume(other.volumes[0]) == Approx(1000));
    CHECK(volume(other.volumes[1]) == Approx(84));
    CHECK(named(tree, "Pad").volumes.size() == (plate_too ? 1u : 0u));
    CHECK(tree.notes.empty());
}
}  // namespace

TEST_CASE("a mirrored object has the volumes of what it mirrors") {
    RawRecord like;
    like.numbers = {{"Base.x", 30}, {"Base.y", 0}, {"Base.z", 0}, {"Normal.x", 1}, {"Normal.y", 0}, {"Normal.z", 0}};
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(30, 0, 0), gp_Dir(1, 0, 0)));
    for (const bool plate_too : {false, true})
        check_copied(interpret(plate_and("Part::Mirroring", "Source", mirror, plate_too, like)), plate_too);
    like.numbers["Base.x"] = 31;  // not what was done: the shape is the volume
    CHECK(named(interpret(plate_and("Part::Mirroring", "Source", mirror, true, like)), "Other").volume_source ==
          "shape");
}

TEST_CASE("a second link and a clone have the volumes of what they show") {
    RawRecord like;
    like.global_placement.translation = {0, 25, 0};
    for (const auto& [type, link] :
         {std::pair{"App::Link", "LinkedObject"}, std::pair{"PartDesign::FeatureBase", "BaseFeature"}})
        for (const bool plate_too : {false, true})
            check_copied(interpret(plate_and(type, link, to_trsf(like.global_placement), plate_too, like)), plate_too);
}

TEST_CASE("several originals repeated by a row and its mirror image") {
    const TopoDS_Shape pad = box(-40, 0, 0, 80, 20, 5), slot = box(4, 3, -1, 3, 4, 7),
                       hole = cylinder({6, 14, -1}, {0, 0, 1}, 2, 7);
    const TopoDS_Shape first = cut(pad, slot), second = cut(first, hole);
    TopoDS_Shape after = second;
    for (const double x : {15.0, -7.0, -22.0}) after = cut(after, box(x == 15 ? 19 : x, 3, -1, 3, 4, 7));
    for (const double x : {21.0, -6.0, -21.0}) after = cut(after, cylinder({x, 14, -1}, {0, 0, 1}, 2, 7));
    DocumentMaker maker;
    maker.add("Sketch", "Sketcher::SketchObject");
    maker.add("Pad", "PartDesign::Pad", {}, pad, pad);
    maker.add("Slot", "PartDesign::Pocket", {{"BaseFeature", "Pad", ""}}, first, slot);
    maker.add("Hole", "PartDesign::Pocket", {{"BaseFeature", "Slot", ""}}, second, hole);
    maker.add("Row", "PartDesign::LinearPattern", {{"Direction", "Sketch", "H_Axis"}}).numbers = {{"Length", 15},
                                                                                                  {"Occurrences", 2}};
    maker.add("Image", "PartDesign::Mirrored", {{"MirrorPlane", "Sketch", "V_Axis"}});
    maker.add("Multi", "PartDesign::MultiTransform",
              {{"BaseFeature", "Hole", ""},
               {"Originals", "Slot", ""},
               {"Originals", "Hole", ""},
               {"Transformations", "Row", ""},
               {"Transformations", "Image", ""}},
              after);
    const FeatureTree tree = interpret(maker.done());
    const Feature& multi = named(tree, "Multi");
    CHECK(multi.volume_source == "instances");
    REQUIRE(multi.volumes.size() == 6);
    double removed = 0;
    for (const FeatureVolume& v : multi.volumes) {
        CHECK(v.effect == Effect::removes);
        removed += volume(v);
    }
    CHECK(removed == Approx(3 * (84 + 28 * pi)));
    CHECK(named(tree, "Row").volumes.empty());
}

TEST_CASE("a body that begins with another object's solid") {
    const TopoDS_Shape block = box(0, 0, 0, 20, 10, 5), tool = box(3, 2, 2, 4, 3, 5);
    DocumentMaker maker;
    maker.add("Block", "Part::Box", {}, block);
    maker.add("Base", "PartDesign::FeatureBase", {{"BaseFeature", "Block", ""}}, block);
    maker.add("Pocket", "PartDesign::Pocket", {{"BaseFeature", "Base", ""}}, cut(block, tool), tool);
    maker.add("Body", "PartDesign::Body", body_links({"Base", "Pocket"}), cut(block, tool));
    const FeatureTree tree = interpret(maker.done());
    REQUIRE(named(tree, "Block").volumes.size() == 1);
    CHECK(volume(named(tree, "Block").volumes[0]) == Approx(1000));
    CHECK(named(tree, "Base").role == Role::base);
    CHECK(named(tree, "Base").volumes.empty());
    CHECK(named(tree, "Pocket").operands == std::vector<FeatureId>{*tree.find("Base")});
}
