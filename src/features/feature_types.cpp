// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/feature_types.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

namespace featuremesh {

namespace {

TypeMeaning step(Role role, Effect effect) {
    return {Kind::chain_step, role, effect, Combination::chain, {"BaseFeature"}, {}};
}
TypeMeaning change(std::vector<std::string> sources) {
    return {Kind::chain_change, Role::dress_up, Effect::adds, Combination::chain, std::move(sources), {}};
}
TypeMeaning pattern() {
    return {Kind::chain_pattern, Role::pattern, Effect::adds, Combination::chain, {"BaseFeature"}, {}};
}
TypeMeaning boolean(Combination how, std::vector<std::string> sources, std::vector<std::string> tools) {
    return {Kind::boolean, Role::boolean, Effect::adds, how, std::move(sources), std::move(tools)};
}
TypeMeaning copy(Role role, std::vector<std::string> sources) {
    return {Kind::copy, role, Effect::adds, Combination::pass, std::move(sources), {}};
}
TypeMeaning leaf(Role role) { return {Kind::leaf, role, Effect::adds, Combination::volumes, {}, {}}; }
TypeMeaning reference() { return {Kind::reference, Role::reference, Effect::adds, Combination::volumes, {}, {}}; }

const std::map<std::string, TypeMeaning, std::less<>>& types() {
    static const std::map<std::string, TypeMeaning, std::less<>> table = [] {
        std::map<std::string, TypeMeaning, std::less<>> t;
        t["PartDesign::Body"] = {Kind::container,   Role::transform,        Effect::adds,
                                 Combination::pass, {"Tip", "BaseFeature"}, {"Group"}};
        t["App::Part"] = {Kind::container, Role::transform, Effect::adds, Combination::fuse, {}, {"Group"}};
        t["App::DocumentObjectGroup"] = {Kind::container, Role::transform, Effect::adds, Combination::fuse, {},
                                         {"Group"}};
        for (const char* name : {"Pad", "Revolution"})
            t["PartDesign::" + std::string(name)] = step(Role::additive, Effect::adds);
        for (const char* name : {"Pocket", "Hole", "Groove"})
            t["PartDesign::" + std::string(name)] = step(Role::subtractive, Effect::removes);
        t["PartDesign::Hole"].at_centres = true;
        for (const char* name : {"Fillet", "Chamfer", "Draft", "Thickness"})
            t["PartDesign::" + std::string(name)] = change({"BaseFeature", "Base"});
        for (const char* name :
             {"LinearPattern", "PolarPattern", "Mirrored", "Scaled", "MultiTransform", "Transformed"})
            t["PartDesign::" + std::string(name)] = pattern();
        t["PartDesign::Boolean"] = boolean(Combination::cut, {"BaseFeature"}, {"Group"});
        t["PartDesign::FeatureBase"] = copy(Role::base, {"BaseFeature"});
        t["PartDesign::ShapeBinder"] = copy(Role::base, {"Support"});
        t["PartDesign::SubShapeBinder"] = copy(Role::base, {"Support"});

        t["Part::Cut"] = boolean(Combination::cut, {"Base"}, {"Tool"});
        t["Part::Fuse"] = boolean(Combination::fuse, {"Base"}, {"Tool"});
        t["Part::Common"] = boolean(Combination::common, {"Base"}, {"Tool"});
        t["Part::MultiFuse"] = boolean(Combination::fuse, {}, {"Shapes"});
        t["Part::MultiCommon"] = boolean(Combination::common, {}, {"Shapes"});
        for (const char* name : {"Part::Compound", "Part::Compound2"})
            t[name] = boolean(Combination::fuse, {}, {"Links"});
        t["Part::Fillet"] = change({"Base"});
        t["Part::Chamfer"] = change({"Base"});
        t["Part::Thickness"] = change({"Faces"});
        t["Part::Refine"] = copy(Role::transform, {"Source"});
        t["Part::Reverse"] = copy(Role::transform, {"Source"});
        t["Part::Mirroring"] = copy(Role::transform, {"Source"});
        t["Part::Scale"] = leaf(Role::transform);
        for (const char* name : {"Box", "Cylinder", "Sphere", "Cone", "Torus", "Prism", "Wedge", "Ellipsoid",
                                 "Extrusion", "Revolution", "Loft", "Sweep"})
            t["Part::" + std::string(name)] = leaf(Role::additive);
        t["Part::Feature"] = leaf(Role::base);
        t["App::Link"] = copy(Role::transform, {"LinkedObject"});
        t["App::LinkElement"] = copy(Role::transform, {"LinkedObject"});
        return t;
    }();
    return table;
}

const std::map<std::string, TypeMeaning, std::less<>>& proxies() {
    static const std::map<std::string, TypeMeaning, std::less<>> table{
        {"FeatureBooleanFragments", boolean(Combination::fuse, {}, {"Objects"})},
        {"FeatureXOR", boolean(Combination::exclusive, {}, {"Objects"})},
        {"FeatureSlice", boolean(Combination::fuse, {"Base"}, {})},
        {"_CompoundFilter", change({"Base"})},
        {"FeatureConnect", boolean(Combination::fuse, {}, {"Objects"})},
        {"AssembledParts", boolean(Combination::fuse, {}, {"Parts"})},
        {"FeatureEmbed", boolean(Combination::fuse, {"Base"}, {"Tool"})},
        {"Clone", copy(Role::transform, {"Objects"})},
        {"_Clone", copy(Role::transform, {"Objects"})},
        {"Array", copy(Role::pattern, {"Base"})},
        {"_Array", copy(Role::pattern, {"Base"})},
        {"PathArray", copy(Role::pattern, {"Base"})},
        {"_PathArray", copy(Role::pattern, {"Base"})},
        {"PointArray", copy(Role::pattern, {"Base"})},
        {"_PointArray", copy(Role::pattern, {"Base"})}};
    return table;
}

// Additive and subtractive lofts, pipes, helices and primitives say it in their names.
bool is_step_by_name(std::string_view type, TypeMeaning& meaning) {
    constexpr std::string_view module = "PartDesign::";
    if (!type.starts_with(module)) return false;
    type.remove_prefix(module.size());
    if (type.starts_with("Additive")) return meaning = step(Role::additive, Effect::adds), true;
    if (type.starts_with("Subtractive")) return meaning = step(Role::subtractive, Effect::removes), true;
    return false;
}

bool is_reference(std::string_view type) {
    static constexpr std::string_view modules[] = {"Sketcher::", "Spreadsheet::"};
    static const std::set<std::string, std::less<>> names{
        "App::Origin",        "App::TextDocument",    "App::Line",         "App::Plane",
        "App::Point",         "App::Placement",       "App::VarSet",       "App::LocalCoordinateSystem",
        "PartDesign::Plane",  "PartDesign::Line",     "PartDesign::Point", "PartDesign::CoordinateSystem",
        "Part::DatumPlane",   "Part::DatumLine",      "Part::DatumPoint",  "Part::LocalCoordinateSystem",
        "Part::Part2DObject", "Part::Plane",          "Part::Line",        "Part::Circle",
        "Part::Ellipse",      "Part::Vertex",         "Part::Helix",       "Part::Spiral",
        "Part::Polygon",      "Part::RegularPolygon", "Part::RuledSurface"};
    return names.count(type) > 0 ||
           std::any_of(std::begin(modules), std::end(modules), [&](std::string_view m) { return type.starts_with(m); });
}

// What a boolean does is a property of it, not its type.
void read_operation(const RawRecord& record, TypeMeaning& meaning) {
    const auto operation = record.texts.find("Type");
    if (record.type != "PartDesign::Boolean" || operation == record.texts.end()) return;
    if (operation->second == "Fuse") meaning.combination = Combination::fuse;
    if (operation->second == "Common") meaning.combination = Combination::common;
}

}  // namespace

TypeMeaning meaning_of(const RawRecord& record) {
    if (const auto proxy = proxies().find(record.proxy); proxy != proxies().end()) return proxy->second;
    std::string_view type = record.type;
    constexpr std::string_view scripted = "Python";
    if (type.ends_with(scripted) && type != "Part::FeaturePython") type.remove_suffix(scripted.size());
    TypeMeaning meaning = leaf(Role::opaque);
    if (is_step_by_name(type, meaning)) return meaning;
    if (const auto known = types().find(type); known != types().end()) meaning = known->second;
    if (is_reference(type)) meaning = reference();
    read_operation(record, meaning);
    return meaning;
}

}  // namespace featuremesh
