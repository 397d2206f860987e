// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/cell_model.h"
#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "brep/booleans/shape_difference.h"
#include "brep/solid_probe.h"
#include "cells/cells_without_fuse.h"
#include "cells/final_faces.h"
#include "cells/fuse.h"
#include "cells/replay.h"
#include "core/dimension.h"
#include "core/errors.h"
#include "core/messages.h"
#include "core/numbers_in_words.h"
#include "core/tolerances.h"
#include "core/work.h"

namespace featuremesh {

namespace {

constexpr double share_of_attempt = 0.6;  // of what is left

void add_solids(std::vector<FuseArgument>& arguments, const Owner& owner, const TopoDS_Shape& shape) {
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) arguments.push_back({owner, it.Current()});
}

void add_final_shape(std::vector<FuseArgument>& arguments, const Brep& final_shape) {
    for (std::size_t s = 0; s < final_shape.solid_count(); ++s)
        arguments.push_back({Owner{}, final_shape.solid(SolidId(s))});
}

class CellBuilder {
  public:
    CellBuilder(const FeatureTree& tree, const Brep& final_shape, RunContext& context)
        : tree_(tree), final_shape_(final_shape), context_(context), final_volume_(final_shape.volume()) {
        for (std::size_t i = 0; i < final_shape.solid_count(); ++i)
            probes_.push_back(std::make_unique<SolidProbe>(final_shape, SolidId(i)));
    }

    /// One attempt after the other until the books close; the last cannot fail.
    CellModel run() {
        if (volumes().empty()) return opaque("no feature has a volume of its own");
        if (attempt(volumes(), 0)) return finish();
        if (replace_offenders() && attempt(volumes(), 0)) return finish();
        if (!was_too_much_ && attempt_fuzzy()) return finish();
        if (attempt_one_by_one()) return finish();
        for (const FeatureId step : steps_to_start_from())
            if (collapse_before(step) && attempt(volumes(), 0)) return finish();
        if (!was_too_much_ && attempt_with_final_shape()) return finish();
        return opaque("no fuse of the volumes adds up to the final shape");
    }

  private:
    Work share_of_left(double share) const { return static_cast<Work>(share * static_cast<double>(work_left_)); }
    void note(std::string text) { notes_.push_back(std::move(text)); }
    void distrust(FeatureId id) { untrusted_.insert(id); }

    std::string names(const std::set<FeatureId>& ids) const {
        std::string text;
        for (const FeatureId id : ids) text += (text.empty() ? "" : ", ") + tree_[id].label;
        return text.empty() ? "none" : text;
    }

    std::vector<FuseArgument> volumes() const {
        std::vector<FuseArgument> arguments;
        for (std::size_t f = 0; f < tree_.features.size(); ++f) {
            const FeatureId id(f);
            if (const auto other = replaced_.find(id); other != replaced_.end()) {
                for (const TopoDS_Shape& solid : other->second) add_solids(arguments, {id, 0}, solid);
                continue;
            }
            for (std::size_t v = 0; v < tree_[id].volumes.size(); ++v)
                add_solids(arguments, {id, static_cast<int>(v)}, tree_[id].volumes[v].shape);
        }
        return arguments;
    }

    /// A feature whose own volume the kernel cannot work with (a pipe that crosses itself) still has a shape before and
    /// after it.
    bool replace_offenders() {
        std::set<FeatureId> done;
        for (const FeatureId id : offenders_) {
            if (tree_[id].before.IsNull() || tree_[id].after.IsNull() || work_left_ <= 0) continue;
            ShapeDifference difference = difference_of(tree_[id].before, tree_[id].after,
                                                       std::min(work_of_seconds(8), work_left_ / 3), context_);
            work_left_ -= difference.work;
            if (!difference.closed) continue;
            auto& solids = replaced_[id];
            solids = std::move(difference.added);
            solids.insert(solids.end(), difference.removed.begin(), difference.removed.end());
            distrust(id);
            done.insert(id);
        }
        if (!done.empty())
            note("the volumes of these features do not add up and are taken from the shapes before and after: " +
                 names(done));
        for (const FeatureId id : done) offenders_.erase(id);
        return !done.empty();
    }

    /// Features that change a shape FreeCAD shows, the last first.
    std::vector<FeatureId> chain() const {
        std::vector<FeatureId> steps;
        for (std::optional<FeatureId> id = tree_.find(tree_.object); id;) {
            const Feature& feature = tree_[*id];
            if (feature.combination == Combination::chain && !feature.before.IsNull()) steps.push_back(*id);
            id = feature.operands.empty() ? std::nullopt : std::optional<FeatureId>(feature.operands.front());
        }
        return steps;
    }

    /// The steps before which all is taken as one piece, when the volumes there cannot be fused; they are tried in this
    /// order. First the step right after the last offender, or the middle of the chain if no offender is known; then
    /// the last step.
    std::vector<FeatureId> steps_to_start_from() const {
        const std::vector<FeatureId> steps = chain();
        if (steps.empty()) return {};
        std::size_t first = steps.size() / 2;
        if (!offenders_.empty()) {
            const auto last_offender =
                std::find_if(steps.begin(), steps.end(), [&](FeatureId id) { return offenders_.count(id) > 0; });
            first = static_cast<std::size_t>(last_offender - steps.begin());
            if (first == 0) return {};
            --first;
        }
        if (first == 0) return {steps.front()};
        return {steps[first], steps.front()};
    }

    /// Takes everything before a step as one piece: the shape that FreeCAD shows there.
    bool collapse_before(FeatureId step) {
        std::set<FeatureId> before;
        std::vector<FeatureId> open = tree_[step].operands;
        while (!open.empty()) {
            const FeatureId id = open.back();
            open.pop_back();
            if (!before.insert(id).second) continue;
            open.insert(open.end(), tree_[id].operands.begin(), tree_[id].operands.end());
        }
        std::erase_if(before, [&](FeatureId id) { return tree_[id].volumes.empty(); });
        for (const FeatureId id : before) {
            replaced_[id] = {tree_[step].before};
            distrust(id);
        }
        if (!before.empty()) note("all before " + tree_[step].label + " is taken as one piece: " + names(before));
        return !before.empty();
    }

    bool leave_out_offenders() {
        if (offenders_.empty()) return false;
        note("the features whose volumes do not add up are left out: " + names(offenders_));
        for (const FeatureId id : offenders_) {
            distrust(id);
            replaced_[id].clear();
        }
        return true;
    }

    bool attempt_fuzzy() {
        const double fuzzy = std::max(1e-7 * final_shape_.box().diagonal(), 1e-6);
        note("the volumes are fused with a tolerance of " + in_words(fuzzy) + " mm");
        return attempt(volumes(), fuzzy);
    }

    /// Also tells who offends where the kernel only says that somebody does.
    bool attempt_one_by_one() {
        note("the volumes are fused one by one");
        return take(fuse_one_by_one(volumes(), {0, share_of_left(share_of_attempt)}, context_));
    }

    bool attempt_with_final_shape() {
        note("the final shape itself takes part in the fuse");
        std::vector<FuseArgument> arguments = volumes();
        add_final_shape(arguments, final_shape_);
        if (attempt(arguments, 0)) return true;
        if (!leave_out_offenders()) return false;
        arguments = volumes();
        add_final_shape(arguments, final_shape_);
        return attempt(arguments, 0);
    }

    bool attempt(const std::vector<FuseArgument>& arguments, double fuzzy) {
        if (work_left_ <= 0) return note("no more work is worth it"), false;
        context_.check_cancelled();
        return take(fuse(arguments, {fuzzy, share_of_left(share_of_attempt)}, context_));
    }

    bool take(FusedComplex complex) {
        was_too_much_ = complex.is_over_limit;
        work_left_ -= complex.work;
        if (!complex.trouble.empty()) return note("fuse: " + complex.trouble), false;
        model_ = {};
        model_.cells = std::move(complex.cells);
        model_.faces = std::move(complex.faces);
        offenders_.clear();
        for (const Owner& owner : complex.offenders) offenders_.insert(owner.feature);
        return decide_material() && books_close();
    }

    /// Known at once where the kernel kept a face of the final shape: there is material beside it there or there is
    /// not.
    std::vector<std::optional<bool>> material_by_identity() const {
        std::vector<std::optional<bool>> material(model_.cells.size());
        if (probes_.size() > 1) return material;  // solids may overlap, so that a border of one is inside another
        for (const CellFace& face : model_.faces) {
            const FaceId id = final_shape_.find(face.face);
            if (!id.is_valid()) continue;
            const auto solids = final_shape_.solids_beside(id);
            const bool forward = final_shape_.face(id).Orientation() == TopAbs_FORWARD;
            for (const int place : {0, 1})
                if (face.cells[place].is_valid())
                    material[face.cells[place].index()] = solids[forward ? place : 1 - place].is_valid();
        }
        return material;
    }

    bool decide_material() {
        const auto known = material_by_identity();
        overlap_ = 0;
        for (std::size_t c = 0; c < model_.cells.size(); ++c) {
            Cell& cell = model_.cells[c];
            context_.progress(0.7);
            if (known[c]) {
                cell.material = *known[c];
                continue;
            }
            const auto inner = point_inside(cell.solid);
            if (!inner && cell.volume > Tolerances::volume_books * final_volume_) {
                std::set<FeatureId> features;
                for (const Owner& owner : cell.owners) features.insert(owner.feature);
                note("a piece of " + volume_in_words(cell.volume) + " of " + names(features) +
                     " has no sound inner point");
                return false;
            }
            if (inner) count_in(cell, *inner);
        }
        return true;
    }

    void count_in(Cell& cell, const Vec3& inner) {
        const auto solids = std::count_if(probes_.begin(), probes_.end(), [&](const auto& probe) {
            return probe->containment_of(inner) == Containment::inside;
        });
        cell.material = solids > 0;
        if (solids > 1) overlap_ += static_cast<double>(solids - 1) * cell.volume;
    }

    bool books_close() {
        double material = 0;
        for (const Cell& cell : model_.cells)
            if (cell.material) material += cell.volume;
        model_.report.material_volume = material;
        model_.report.final_volume = final_volume_ - overlap_;
        if (std::abs(material + overlap_ - final_volume_) <= Tolerances::volume_books * final_volume_) {
            if (overlap_ > Tolerances::volume_books * final_volume_)
                model_.report.findings = {say<Code::solids_overlap>(Volume{overlap_})};
            return true;
        }
        constexpr int digits = 9;  // more than the books may be off by
        note("the features' volumes come to " + volume_in_words(material, digits) + " where the final shape has " +
             volume_in_words(final_volume_, digits));
        return false;
    }

    /// Replays the tree on the cells. Where the tree and the final shape disagree about material, FreeCAD did something
    /// else than the tree says, so the owners of that cell are not trusted.
    void cross_check() {
        const std::vector<bool> expected = replay(tree_, model_.cells);
        for (std::size_t c = 0; c < model_.cells.size(); ++c)
            if (expected[c] != model_.cells[c].material &&
                model_.cells[c].volume > Tolerances::volume_books * final_volume_)
                for (const Owner& owner : model_.cells[c].owners) distrust(owner.feature);
    }

    CellModel finish() {
        cross_check();
        match_final_faces(model_, final_shape_, context_);
        own_the_rest();
        for (std::size_t f = 0; f < tree_.features.size(); ++f)
            if (!tree_.features[f].error.empty()) distrust(FeatureId(f));
        model_.feature_volumes = volumes_of_features(model_.cells, tree_.features.size());
        model_.report.fallbacks = std::move(notes_);
        model_.report.untrusted.assign(untrusted_.begin(), untrusted_.end());
        return std::move(model_);
    }

    /// A cell or face without owners may belong to any feature whose volume was replaced, so all of these become its
    /// owners.
    void own_the_rest() {
        const std::vector<Owner> all = owners_of_anything(tree_);
        std::vector<Owner> suspects;
        for (const Owner& owner : all)
            if (untrusted_.count(owner.feature)) suspects.push_back(owner);
        const std::vector<Owner>& owners = suspects.empty() ? all : suspects;
        for (Cell& cell : model_.cells)
            if (cell.owners.empty()) cell.owners = owners;
        for (CellFace& face : model_.faces)
            if (face.owners.empty()) face.owners = owners;
        for (auto& list : model_.owners_of_final_face)
            if (list.empty()) list = owners;
    }

    /// The final shape as it is, owned by every feature and trusted to none.
    CellModel opaque(const std::string& why) {
        note("the part is taken as one piece: " + why);
        std::vector<FuseArgument> whole;
        add_final_shape(whole, final_shape_);
        model_ = {};
        for (std::size_t s = 0; s < whole.size(); ++s) {
            FusedComplex solid = fuse({whole[s]}, {}, context_);
            const auto offset = static_cast<std::int32_t>(model_.cells.size());
            for (Cell& cell : solid.cells) {
                cell.material = true;
                model_.cells.push_back(std::move(cell));
            }
            for (CellFace& face : solid.faces) {
                for (CellId& id : face.cells)
                    if (id.is_valid()) id.value += offset;
                model_.faces.push_back(std::move(face));
            }
        }
        own_everything();
        model_.feature_volumes = volumes_of_features(model_.cells, tree_.features.size());
        model_.report.material_volume = model_.report.final_volume = final_volume_;
        match_final_faces(model_, final_shape_, context_);
        model_.report.fallbacks = std::move(notes_);
        model_.report.untrusted.assign(untrusted_.begin(), untrusted_.end());
        return std::move(model_);
    }

    void own_everything() {
        const std::vector<Owner> owners = owners_of_anything(tree_);
        for (const Owner& owner : owners) distrust(owner.feature);
        for (Cell& cell : model_.cells) cell.owners = owners;
        for (CellFace& face : model_.faces) face.owners = owners;
    }

    const FeatureTree& tree_;
    const Brep& final_shape_;
    std::vector<std::unique_ptr<SolidProbe>> probes_;  // one per solid of the final shape
    RunContext& context_;
    Work work_left_ = work_of_seconds(24);  // for all attempts together; what is fused with that is worth it
    double final_volume_;
    double overlap_ = 0;  // mm^3 that the final shape's solids count more than once
    CellModel model_;
    bool was_too_much_ = false;  // was the last attempt? Then variations of it are a waste of time
    std::vector<std::string> notes_;
    std::set<FeatureId> offenders_, untrusted_;
    std::map<FeatureId, std::vector<TopoDS_Shape>> replaced_;  // other volumes than the tree's, all counted as volume 0
};

}  // namespace

std::vector<double> volumes_of_features(const std::vector<Cell>& cells, std::size_t feature_count) {
    std::vector<double> volumes(feature_count, 0);
    for (const Cell& cell : cells)
        for (std::size_t i = 0; i < cell.owners.size(); ++i)
            if (i == 0 || cell.owners[i].feature != cell.owners[i - 1].feature)
                volumes[cell.owners[i].feature.index()] += cell.volume;
    return volumes;
}

std::vector<Owner> owners_of_anything(const FeatureTree& tree) {
    std::vector<Owner> owners;
    for (std::size_t f = 0; f < tree.features.size(); ++f)
        if (!tree.features[f].volumes.empty()) owners.push_back({FeatureId(f), 0});
    return owners;
}

CellModel build_cells(const FeatureTree& tree, const Brep& final_shape, RunContext& context) {
    RunContext::Step step(context, "cells");
    if (final_shape.dimension() != Dimension::solids || final_shape.has_free_faces() || final_shape.has_free_edges())
        return cells_without_fuse(tree, final_shape);
    return CellBuilder(tree, final_shape, context).run();
}

}  // namespace featuremesh
