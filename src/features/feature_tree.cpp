// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/feature_tree.h"

#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <map>
#include <set>

#include "brep/booleans/shape_difference.h"
#include "brep/occt_geometry.h"
#include "brep/same_solids.h"
#include "core/activity.h"
#include "core/errors.h"
#include "core/messages.h"
#include "features/copied_volumes.h"
#include "features/document_view.h"
#include "features/feature_types.h"
#include "features/pattern_instances.h"

namespace featuremesh {

namespace {

/// What a step does to the part when the shape it is applied to has the effect `context` itself.
Effect within(Effect context, Effect step) {
    if (context == Effect::adds || step == Effect::keeps_only) return step;
    if (context == Effect::keeps_only) return step == Effect::adds ? Effect::keeps_only : Effect::removes;
    return step == Effect::adds ? Effect::removes : Effect::adds;
}

/// Walks from the final object down to the leaves and gives each feature its volumes, once.
class Interpreter {
  public:
    Interpreter(const RawDocument& document, RunContext& context, const FeatureTree* before, Dimension dimension)
        : view_(document, dimension), context_(context), before_(before) {
        tree_.object = document.final_object;
        for (std::size_t i = 0; i < document.records.size(); ++i) {
            meanings_.push_back(meaning_of(document.records[i]));
            add_feature(static_cast<int>(i));
        }
        visited_.assign(document.records.size(), false);
    }

    FeatureTree run() {
        const int last = view_.find(tree_.object);
        if (last < 0) throw InputError(say<Code::no_such_object>(tree_.object));
        tree_.final_shape = view_.geometry_of(record(last));
        if (tree_.final_shape.IsNull()) throw InputError(nothing_to_mesh(title(last)));
        evaluate(last, Effect::adds);
        return std::move(tree_);
    }

  private:
    const RawRecord& record(int i) const { return view_.records()[i]; }
    Feature& feature(int i) { return tree_.features[i]; }
    std::string title(int i) const {
        const RawRecord& r = record(i);
        return r.label.empty() || r.label == r.name ? r.name : r.label + " (" + r.name + ")";
    }
    Message nothing_to_mesh(const std::string& object) const {
        if (view_.dimension() == Dimension::faces) return say<Code::object_without_face>(object);
        if (view_.dimension() == Dimension::edges) return say<Code::object_without_edge>(object);
        return say<Code::object_without_solid>(object);
    }
    template <Code code>
    void note(int i, const auto&... values) {
        tree_.notes.push_back(say<code>(title(i), values...));
    }

    void add_feature(int i) {
        const RawRecord& r = record(i);
        Feature f;
        f.name = r.name;
        f.label = r.label;
        f.type = r.type;
        f.role = meanings_[i].role;
        f.frame = r.global_placement;
        f.at_centres = meanings_[i].at_centres;
        f.suppressed = r.suppressed;
        f.error = r.error;
        f.parameters.assign(r.numbers.begin(), r.numbers.end());
        f.measures = r.measures;
        std::set<FeatureId> links;
        for (const RawLink& link : r.links)
            if (const int target = view_.find(link.object); target >= 0 && target < i) links.insert(FeatureId(target));
        f.depends_on.assign(links.begin(), links.end());
        tree_.features.push_back(std::move(f));
        if (!r.error.empty()) note<Code::feature_in_error>(i, r.error);
    }

    /// Earlier records with something to mesh that the properties link to, in order; of what is loose beside solids
    /// none.
    std::vector<int> solids_linked(int i, const std::string& property) const {
        std::vector<int> found = linked(i, property);
        if (view_.takes_loose()) std::erase_if(found, [&](int target) { return !view_.has_solid(record(target)); });
        return found;
    }

    std::vector<int> linked(int i, const std::string& property) const {
        std::vector<int> found;
        for (const RawLink& link : DocumentView::links_of(record(i), property)) {
            const int target = view_.find(link.object);
            if (target >= 0 && target < i && !view_.geometry_of(record(target)).IsNull() &&
                std::find(found.begin(), found.end(), target) == found.end())
                found.push_back(target);
        }
        return found;
    }

    void note_operands_without_solid(int i) {
        for (const auto& properties : {meanings_[i].sources, meanings_[i].tools})
            for (const std::string& property : properties)
                for (const RawLink& link : DocumentView::links_of(record(i), property))
                    if (const int target = view_.find(link.object); target < 0)
                        note<Code::feature_link_dangles>(i, link.object);
                    else if (meanings_[target].kind != Kind::reference && view_.geometry_of(record(target)).IsNull())
                        note<Code::operand_without_solid>(i, title(target));
    }

    int source_of(int i) const {
        for (const std::string& property : meanings_[i].sources)
            if (const auto found = solids_linked(i, property); !found.empty()) return found.front();
        return -1;
    }

    /// The body's member before this one that is a step of its chain; -2 when no body has it as a member.
    int member_before(int i) const {
        for (const RawRecord& r : view_.records()) {
            if (r.type != "PartDesign::Body") continue;
            int before = -1;
            for (const RawLink& link : DocumentView::links_of(r, "Group")) {
                if (link.object == record(i).name) return before;
                const int member = view_.find(link.object);
                if (member >= 0 && member < i && is_step(member) && !view_.geometry_of(record(member)).IsNull())
                    before = member;
            }
        }
        return -2;
    }

    bool is_step(int i) const {
        const Kind kind = meanings_[i].kind;
        return kind == Kind::chain_step || kind == Kind::chain_change || kind == Kind::chain_pattern ||
               kind == Kind::boolean || record(i).type == "PartDesign::FeatureBase";
    }

    /// The object whose shape a chain step starts from. Old documents may not name it: then it is the body's member
    /// before, or, before FreeCAD had bodies, the object on whose face the sketch lies.
    int base_of(int i) const {
        if (const int base = source_of(i); base >= 0) return base;
        const int before = member_before(i);
        return before == -2 ? support_of_profile(i) : before;
    }

    int support_of_profile(int i) const {
        for (const char* profile : {"Profile", "Sketch"})
            for (const RawLink& link : DocumentView::links_of(record(i), profile)) {
                const int sketch = view_.find(link.object);
                if (sketch < 0 || sketch >= i) continue;
                for (const char* support : {"Support", "AttachmentSupport"})
                    if (const auto found = solids_linked(sketch, support); !found.empty()) return found.front();
            }
        return -1;
    }

    void evaluate(int i, Effect context) {
        if (visited_[i]) return;
        visited_[i] = true;
        context_.progress(0.5);
        switch (meanings_[i].kind) {
            case Kind::container:
                return evaluate_container(i, context);
            case Kind::chain_step:
            case Kind::chain_change:
            case Kind::chain_pattern:
                return evaluate_chain(i, context);
            case Kind::boolean:
                return evaluate_boolean(i, context);
            case Kind::copy:
                return evaluate_copy(i, context);
            case Kind::leaf:
            case Kind::reference:
                return take_shape(i, context);
        }
    }

    void pass_on(int i, int source, Effect context) {
        feature(i).combination = Combination::pass;
        feature(i).operands = {FeatureId(source)};
        evaluate(source, context);
    }

    void evaluate_container(int i, Effect context) {
        if (const int source = source_of(i); source >= 0) return pass_on(i, source, context);
        std::vector<int> members = solids_linked(i, "Group");
        // Operands stand in the group beside the object that uses them up.
        std::set<std::string> used;
        for (const int member : members)
            for (const RawLink& link : record(member).links) used.insert(link.object);
        std::erase_if(members, [&](int member) { return used.count(record(member).name) > 0; });
        if (members.empty()) return take_shape(i, context);
        combine(i, Combination::fuse, members, context);
    }

    void combine(int i, Combination how, const std::vector<int>& operands, Effect context) {
        feature(i).combination = how;
        for (std::size_t k = 0; k < operands.size(); ++k) {
            feature(i).operands.push_back(FeatureId(operands[k]));
            Effect effect = Effect::adds;
            if (k > 0 && how == Combination::cut) effect = Effect::removes;
            if (k > 0 && how == Combination::common) effect = Effect::keeps_only;
            evaluate(operands[k], within(context, effect));
        }
    }

    void evaluate_boolean(int i, Effect context) {
        note_operands_without_solid(i);
        std::vector<int> operands;
        if (const int source = source_of(i); source >= 0) operands.push_back(source);
        const bool has_base = !operands.empty() || meanings_[i].sources.empty();
        const bool is_union = meanings_[i].combination == Combination::fuse;
        if (!feature(i).suppressed)
            for (const std::string& property : meanings_[i].tools)
                for (const int tool : is_union ? linked(i, property) : solids_linked(i, property))
                    operands.push_back(tool);
        if (operands.empty() || !has_base) return take_shape(i, context);
        combine(i, meanings_[i].combination, operands, context);
    }

    void evaluate_copy(int i, Effect context) {
        const int source = source_of(i);
        if (!is_of_solids(i)) return take_shape(i, context);
        if (source >= 0 && same_solids(view_.geometry_of(record(source)), view_.geometry_of(record(i))))
            return pass_on(i, source, context);
        if (source < 0 || feature(i).suppressed || !take_copies(i, source, context)) take_shape(i, context);
    }

    /// A copy of an object has the volumes of that object, moved to the copy's place.
    bool take_copies(int i, int source, Effect context) {
        const auto volumes = volumes_of(source);
        if (!volumes || volumes->empty()) return false;
        auto copies = copied_volumes(record(i), record(source), *volumes, view_);
        if (!copies) return false;
        feature(i).combination = Combination::chain;
        feature(i).volume_source = "copies";
        feature(i).volumes = std::move(*copies);
        if (feature(i).volumes.size() > volumes->size()) feature(i).after = view_.geometry_of(record(i));  // an array
        for (FeatureVolume& volume : feature(i).volumes) volume.effect = within(context, volume.step);
        return true;
    }

    /// The source of a copy need not be part of the result itself.
    std::optional<std::vector<FeatureVolume>> volumes_of(int source) {
        if (visited_[source]) return volumes_in_order(tree_, FeatureId(source));
        const FeatureTree tree = tree_;
        const std::vector<bool> visited = visited_;
        evaluate(source, Effect::adds);
        auto volumes = volumes_in_order(tree_, FeatureId(source));
        tree_ = tree;
        visited_ = visited;
        return volumes;
    }

    /// What a feature did is told by solids; of sheets and wires only where they are.
    bool is_of_solids(int i) const {
        return (view_.dimension() == Dimension::solids && !view_.takes_loose()) || view_.has_solid(record(i));
    }

    void evaluate_chain(int i, Effect context) {
        const int base = base_of(i);
        if (feature(i).suppressed) {
            if (base >= 0) pass_on(i, base, context);
            return;
        }
        if ((base < 0 && view_.own_volume_of(record(i)).IsNull()) || !is_of_solids(i)) return take_shape(i, context);
        feature(i).after = view_.geometry_of(record(i));
        if (base >= 0) feature(i).before = view_.geometry_of(record(base));
        // The repeated volumes belong to features before this one.
        const bool repeats = base >= 0 && meanings_[i].kind == Kind::chain_pattern;
        if (repeats) evaluate(base, context);
        if (!(repeats && take_instances(i, base)) && !take_own_volume(i) && !take_difference(i))
            return take_shape(i, context);
        feature(i).combination = Combination::chain;
        for (FeatureVolume& volume : feature(i).volumes) volume.effect = within(context, volume.step);
        if (base < 0) return;
        feature(i).operands = {FeatureId(base)};
        evaluate(base, context);
    }

    bool take_own_volume(int i) {
        const TopoDS_Shape& own = view_.own_volume_of(record(i));
        if (own.IsNull() || meanings_[i].kind != Kind::chain_step) return false;
        const Effect step = meanings_[i].effect;
        feature(i).volumes = {{own, step, 0, {}, step}};
        feature(i).volume_source = "own";
        return true;
    }

    bool take_instances(int i, int base) {
        const Activity activity("feature " + feature(i).label);
        std::vector<FeatureVolume> originals;
        for (const RawLink& link : DocumentView::links_of(record(i), "Originals")) {
            const int original = view_.find(link.object);
            if (original < 0 || original >= i || feature(original).volumes.empty()) return false;
            const auto& volumes = feature(original).volumes;
            originals.insert(originals.end(), volumes.begin(), volumes.end());
        }
        auto found = pattern_instances(record(i), originals, view_.geometry_of(record(base)),
                                       view_.geometry_of(record(i)), view_);
        if (!found) return false;
        feature(i).volumes = std::move(*found);
        feature(i).volume_source = "instances";
        return true;
    }

    /// What the feature added and removed before the edit.
    const ShapeDifference* known_difference(int i) const {
        if (!before_) return nullptr;
        const auto id = before_->find(record(i).name);
        return id ? (*before_)[*id].difference.get() : nullptr;
    }

    bool take_difference(int i) {
        const Activity activity("feature " + feature(i).label);
        const TopoDS_Shape& after = feature(i).after;
        if (after.IsNull()) {
            note<Code::feature_without_solid>(i);
            if (feature(i).error.empty()) feature(i).error = "it has no solid";
            return true;
        }
        const auto [known, is_new] = differences_.try_emplace(i);
        ShapeDifference& difference = known->second;
        if (is_new) {
            // One in error counts as changed whatever it did, and shows what it did before it failed.
            const Work worth = work_of_seconds(feature(i).error.empty() ? 8.0 : 0.3);
            difference =
                difference_of(feature(i).before, after, std::min(worth, work_left_), context_, known_difference(i));
            work_left_ = std::max(work_of_seconds(0.5), work_left_ - difference.work);
        }
        feature(i).difference = std::make_shared<const ShapeDifference>(difference);
        if (!difference.closed) {
            note<Code::feature_not_understood>(i);
            feature(i).role = Role::opaque;
            return false;
        }
        int instance = 0;
        const bool counts = meanings_[i].kind == Kind::chain_pattern;
        for (const auto& solid : difference.removed)
            feature(i).volumes.push_back({solid, Effect::removes, counts ? instance++ : 0, {}, Effect::removes});
        for (const auto& solid : difference.added)
            feature(i).volumes.push_back({solid, Effect::adds, counts ? instance++ : 0, {}, Effect::adds});
        feature(i).volume_source = "before and after";
        return true;
    }

    /// The shape itself is the volume; of an array, one volume per element.
    void take_shape(int i, Effect context) {
        const TopoDS_Shape& shape = view_.geometry_of(record(i));
        feature(i).combination = Combination::volumes;
        if (shape.IsNull() || feature(i).suppressed) return;
        feature(i).volume_source = "shape";
        if (feature(i).role != Role::pattern || !is_of_solids(i)) {
            feature(i).volumes = {{shape, context, 0, {}, Effect::adds}};
            return;
        }
        TopoDS_Shape first;
        for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) {
            const TopoDS_Shape& solid = it.Current();
            if (first.IsNull()) first = solid;
            FeatureVolume volume{solid, context, static_cast<int>(feature(i).volumes.size()), {}, Effect::adds};
            if (solid.IsPartner(first))
                volume.motion = to_motion((solid.Location() * first.Location().Inverted()).Transformation());
            feature(i).volumes.push_back(std::move(volume));
        }
    }

    DocumentView view_;
    RunContext& context_;
    const FeatureTree* before_;
    FeatureTree tree_;
    std::vector<TypeMeaning> meanings_;
    std::vector<bool> visited_;
    std::map<int, ShapeDifference> differences_;  // by record: the source of a copy is evaluated more than once
    Work work_left_ = work_of_seconds(16);        // for what was added and removed by all features together
};

}  // namespace

std::string to_string(Role role) {
    switch (role) {
        case Role::additive:
            return "additive";
        case Role::subtractive:
            return "subtractive";
        case Role::common:
            return "common";
        case Role::dress_up:
            return "dress-up";
        case Role::pattern:
            return "pattern";
        case Role::boolean:
            return "boolean";
        case Role::transform:
            return "transform";
        case Role::base:
            return "base";
        case Role::reference:
            return "reference";
        case Role::opaque:
            return "opaque";
    }
    return "unknown";
}

std::optional<FeatureId> FeatureTree::find(const std::string& name) const {
    for (std::size_t i = 0; i < features.size(); ++i)
        if (features[i].name == name) return FeatureId(i);
    return std::nullopt;
}

bool FeatureTree::is_import(FeatureId id) const {
    const Feature& feature = (*this)[id];
    if (feature.role != Role::base && feature.role != Role::transform) return false;
    return std::all_of(feature.depends_on.begin(), feature.depends_on.end(),
                       [&](FeatureId d) { return (*this)[d].role == Role::reference || is_import(d); });
}

FeatureTree interpret(const RawDocument& document, RunContext& context, const FeatureTree* before,
                      Dimension dimension) {
    return Interpreter(document, context, before, dimension).run();
}

FeatureTree interpret(const RawDocument& document) {
    RunContext context;
    return interpret(document, context);
}

}  // namespace featuremesh
