// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/feature_verdicts.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <algorithm>
#include <map>

#include "cells/cell_model.h"
#include "core/dimension.h"
#include "core/ids.h"
#include "core/message.h"
#include "core/messages.h"
#include "difference/face_owners.h"
#include "difference/feature_pieces.h"
#include "features/feature_tree.h"

namespace featuremesh {
namespace {
/// Volumes of one state, mm^3, by feature; summed up from the cells unless those are not to be trusted, then
/// integrated.
class Volumes {
  public:
    explicit Volumes(const PartState& state) : state_(state), from_cells_(state.cells.feature_volumes) {
        from_cells_.resize(state.tree.features.size(), 0);
        for (const FeatureId id : state.cells.report.untrusted) from_cells_[id.index()] = 0;
    }

    double operator()(std::size_t feature) const {
        if (from_cells_[feature] > 0) return from_cells_[feature];
        double sum = 0;
        for (const FeatureVolume& v : state_.tree.features[feature].volumes) {
            if (dimension_of(v.shape) != Dimension::solids) continue;
            GProp_GProps properties;
            BRepGProp::VolumeProperties(v.shape, properties, 1e-4);
            sum += std::abs(properties.Mass());
        }
        return sum;
    }

  private:
    const PartState& state_;
    std::vector<double> from_cells_;
};

Message changed_parameter(const std::string& name, const std::string& measure, double before, double after) {
    if (measure == "length") return say<Code::length_changed>(name, Length{before}, Length{after});
    if (measure == "angle") return say<Code::angle_changed>(name, before, after);
    return say<Code::number_changed>(name, before, after);
}

Message changed_parameters(const Feature& was, const Feature& is) {
    std::vector<Message> changed;
    for (const auto& [name, value] : is.parameters) {
        const auto old =
            std::find_if(was.parameters.begin(), was.parameters.end(), [&](const auto& p) { return p.first == name; });
        if (old == was.parameters.end() || std::abs(old->second - value) <= 1e-9 * (1 + std::abs(value))) continue;
        const auto measure = is.measures.find(name);
        changed.push_back(
            changed_parameter(name, measure == is.measures.end() ? "" : measure->second, old->second, value));
    }
    return listed(changed);
}

class FeatureComparison {
  public:
    FeatureComparison(const PartState& old_state, const PartState& new_state, const Sameness& sameness)
        : old_(old_state), new_(new_state), sameness_(sameness), old_volumes_(old_state), new_volumes_(new_state) {}

    FeatureVerdicts run() {
        std::size_t next_old = 0;
        for (std::size_t n = 0; n < new_.tree.features.size(); ++n) {
            const auto o = old_.tree.find(new_.tree.features[n].name);
            if (o)
                for (; next_old < o->index(); ++next_old) add_removed(next_old);
            result_.changes.push_back(o ? compare(o->index(), n) : added(n));
        }
        for (; next_old < old_.tree.features.size(); ++next_old) add_removed(next_old);
        result_.everything_moved = result_.moved.size() == 1 && !something_stayed_;
        return std::move(result_);
    }

  private:
    void add_removed(std::size_t o) {
        const Feature& was = old_.tree.features[o];
        if (new_.tree.find(was.name)) return;
        result_.changes.push_back(
            {was.name, was.label, Verdict::removed, {}, old_volumes_(o), 0, {}, {}, say<Code::feature_removed>()});
        if (!was.volumes.empty()) something_stayed_ = true;
    }

    FeatureChange added(std::size_t n) {
        const Feature& is = new_.tree.features[n];
        if (!is.volumes.empty()) something_stayed_ = true;
        return {is.name, is.label, Verdict::added, {}, 0, new_volumes_(n), {}, {}, say<Code::feature_added>()};
    }

    FeatureChange compare(std::size_t o, std::size_t n) {
        const Feature& was = old_.tree.features[o];
        const Feature& is = new_.tree.features[n];
        FeatureChange change{is.name, is.label, Verdict::same, {}, old_volumes_(o), 0, {}, {}, {}};
        if (was.suppressed != is.suppressed) return suppression(change, is, n);
        if (is.suppressed) return change;
        if (const Message why = distrust(o, n); !why.empty()) {
            something_stayed_ = true;
            change.verdict = Verdict::reshaped;
            change.new_volume = new_volumes_(n);
            change.detail = say<Code::taken_as_changed>(why);
            return change;
        }
        if (was.volumes.empty() && is.volumes.empty()) return compare_without_volume(change, was, is);
        compare_volumes(change, was, is, n);
        return change;
    }

    FeatureChange suppression(FeatureChange change, const Feature& is, std::size_t n) {
        something_stayed_ = true;
        change.verdict = is.suppressed ? Verdict::suppressed : Verdict::added;
        change.new_volume = is.suppressed ? 0 : new_volumes_(n);
        if (!is.suppressed) change.old_volume = 0;
        change.detail = is.suppressed ? say<Code::feature_suppressed>() : say<Code::feature_unsuppressed>();
        return change;
    }

    Message distrust(std::size_t o, std::size_t n) const {
        const Feature& was = old_.tree.features[o];
        const Feature& is = new_.tree.features[n];
        if (!is.error.empty()) return say<Code::in_error>(is.error);
        if (!was.error.empty()) return say<Code::was_in_error>(was.error);
        const auto listed = [](const CellModel& cells, std::size_t f) {
            const auto& u = cells.report.untrusted;
            return std::find(u.begin(), u.end(), FeatureId(f)) != u.end();
        };
        if (listed(old_.cells, o) || listed(new_.cells, n)) return say<Code::volume_not_trusted>();
        return {};
    }

    FeatureChange compare_without_volume(FeatureChange change, const Feature& was, const Feature& is) const {
        const RigidMotion motion = compose(is.frame, was.frame.inverse());
        const Message parameters = changed_parameters(was, is);
        if (!parameters.empty()) {
            change.verdict = Verdict::reshaped;
            change.detail = parameters;
        } else if (!same_motion(motion, RigidMotion{}, sameness_)) {
            change.verdict = Verdict::moved;
            change.motion = motion;
            change.detail = describe(motion);
        }
        return change;
    }

    void compare_volumes(FeatureChange& change, const Feature& was, const Feature& is, std::size_t n) {
        const std::vector<FeaturePiece> old_pieces = pieces_of(was), new_pieces = pieces_of(is);
        const PieceMatch match =
            match_pieces(old_pieces, new_pieces, compose(is.frame, was.frame.inverse()), sameness_);
        register_motions(was, match, old_pieces, new_pieces);
        const std::size_t count = old_pieces.size();
        const bool complete = match.added == 0 && match.removed == 0;
        if (complete && match.same == count) {
            change.new_volume = change.old_volume;
            return;
        }
        if (complete && match.moved == count && one_motion(match)) {
            change.new_volume = change.old_volume;
            change.verdict = Verdict::moved;
            change.motion = match.motions[0];
            change.detail = describe(change.motion);
            return;
        }
        change.new_volume = complete ? change.old_volume : new_volumes_(n);
        change.verdict = Verdict::reshaped;
        std::vector<Message> details;
        if (const Message parameters = changed_parameters(was, is); !parameters.empty()) details.push_back(parameters);
        if (old_pieces.size() > 1 || new_pieces.size() > 1)
            details.push_back(describe(match, old_pieces, new_pieces, old_.brep.box(), new_.brep.box()));
        if (details.empty())
            details.push_back(change.old_volume == 0 && change.new_volume == 0
                                  ? say<Code::other_faces>()
                                  : say<Code::volume_changed>(Volume{change.old_volume}, Volume{change.new_volume}));
        change.detail = several(std::move(details));
    }

    bool one_motion(const PieceMatch& match) const {
        return std::all_of(match.motions.begin(), match.motions.end(),
                           [&](const RigidMotion& m) { return same_motion(m, match.motions[0], sameness_); });
    }

    void register_motions(const Feature& was, const PieceMatch& match, const std::vector<FeaturePiece>& old_pieces,
                          const std::vector<FeaturePiece>& new_pieces) {
        if (match.same > 0 || match.added > 0 || match.removed > 0) something_stayed_ = true;
        for (std::size_t i = 0; i < old_pieces.size(); ++i) {
            if (match.new_of[i] < 0 || match.motions[i].is_identity()) continue;
            auto group = std::find_if(result_.moved.begin(), result_.moved.end(), [&](const MovedFeatures& m) {
                return same_motion(m.motion, match.motions[i], sameness_);
            });
            if (group == result_.moved.end())
                group = result_.moved.insert(group, MovedFeatures{match.motions[i], {}, {}, {}});
            if (group->features.empty() || group->features.back() != was.name) group->features.push_back(was.name);
            if (old_pieces[i].effect == Effect::adds) group->additive_volumes.push_back(old_pieces[i].shape);
            group->new_place.add(new_pieces[std::size_t(match.new_of[i])].box);
        }
    }

    const PartState& old_;
    const PartState& new_;
    const Sameness& sameness_;
    Volumes old_volumes_, new_volumes_;
    FeatureVerdicts result_;
    bool something_stayed_ = false;
};

/// Faces of the final shape by the feature that owns them: all of a feature that changed, and of others those that were
/// not kept.
std::map<std::string, std::vector<FaceId>> faces_by_feature(const PartState& state, const std::vector<char>& is_kept,
                                                            const std::vector<FeatureChange>& changes) {
    std::vector<char> is_changed(state.tree.features.size(), 0);
    for (const FeatureChange& change : changes)
        if (const auto id = state.tree.find(change.name); id && change.verdict != Verdict::same)
            is_changed[id->index()] = 1;
    const FaceOwners owners(state);
    std::map<std::string, std::vector<FaceId>> result;
    for (std::size_t f = 0; f < state.brep.face_count(); ++f)
        for (const Owner& owner : is_kept[f] ? owners.of(FaceId(f), is_changed) : owners.of(FaceId(f))) {
            auto& faces = result[state.tree[owner.feature].name];
            if (faces.empty() || faces.back() != FaceId(f)) faces.push_back(FaceId(f));
        }
    return result;
}
}  // namespace

FeatureVerdicts compare_features(const PartState& old_state, const PartState& new_state, const Sameness& sameness) {
    return FeatureComparison(old_state, new_state, sameness).run();
}

void add_face_verdicts(const PartState& old_state, const PartState& new_state, const std::vector<FaceChange>& faces,
                       std::vector<FeatureChange>& changes) {
    std::vector<char> old_kept(old_state.brep.face_count(), 0), new_kept(new_state.brep.face_count(), 0);
    for (const FaceChange& face : faces)
        if (face.verdict == BoundaryVerdict::kept)
            old_kept[face.old_face.index()] = new_kept[face.new_face.index()] = 1;
    auto old_faces = faces_by_feature(old_state, old_kept, changes),
         new_faces = faces_by_feature(new_state, new_kept, changes);
    for (FeatureChange& change : changes) {
        change.old_faces = old_faces[change.name];
        change.new_faces = new_faces[change.name];
        if (change.verdict != Verdict::same || (change.old_faces.empty() && change.new_faces.empty())) continue;
        change.verdict = Verdict::interaction_changed;
        change.detail = say<Code::cut_otherwise>(std::max(change.old_faces.size(), change.new_faces.size()));
    }
}

}  // namespace featuremesh
