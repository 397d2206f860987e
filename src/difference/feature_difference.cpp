// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/feature_difference.h"

#include <Standard_Failure.hxx>
#include <algorithm>

#include "core/dimension.h"
#include "core/errors.h"
#include "core/messages.h"
#include "difference/boundary_match.h"
#include "difference/boundary_model.h"
#include "difference/edge_difference.h"
#include "difference/feature_verdicts.h"
#include "difference/partners.h"
#include "difference/trim_difference.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

std::string to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::same:
            return "same";
        case Verdict::moved:
            return "moved";
        case Verdict::reshaped:
            return "reshaped";
        case Verdict::added:
            return "added";
        case Verdict::removed:
            return "removed";
        case Verdict::suppressed:
            return "suppressed";
        case Verdict::interaction_changed:
            return "interaction changed";
    }
    return "";
}

bool FeatureDifference::is_empty() const {
    const bool features_same = std::all_of(features.begin(), features.end(),
                                           [](const FeatureChange& f) { return f.verdict == Verdict::same; });
    const bool faces_same =
        std::all_of(faces.begin(), faces.end(), [](const FaceChange& f) { return f.verdict == BoundaryVerdict::kept; });
    return features_same && faces_same && (regions.empty() || regions[0].changed.is_empty());
}

namespace {
constexpr std::size_t most_motions = 64;

// A motion is asked for near what moved only; beyond, the identity keeps more.
std::optional<Box> domain_of(const MovedFeatures& moved, bool everything_moved, double resolution) {
    if (everything_moved) return std::nullopt;
    return moved.new_place.grown(std::max(8 * resolution, 0.5 * moved.new_place.diagonal()));
}

CarriedRegion find_region(const BoundaryPair& pair, BoundaryMatch& match) {
    CarriedRegion region;
    region.motion = pair.motion;
    match = match_boundaries(pair);
    find_partners(pair, match, region);
    return region;
}

ChangedBoundary changed_boundary(const BoundaryPair& pair, const BoundaryMatch& match, const Resolution& resolution) {
    std::vector<SpaceTriangle> triangles;
    std::vector<std::size_t> ends;
    if (pair.new_model.brep().dimension() != Dimension::edges)
        for (const SurfaceGroup& group : match.groups) {
            append_trim_difference(pair, match, group, resolution, triangles);
            ends.push_back(triangles.size());
        }
    if (pair.old_model.brep().has_free_edges() || pair.new_model.brep().has_free_edges())
        append_edge_difference(pair, match, resolution, triangles);
    return pair.domain ? ChangedBoundary(std::move(triangles), *pair.domain)
                       : ChangedBoundary(std::move(triangles), ends);
}

std::vector<std::string> names_of_unmoved(const std::vector<FeatureChange>& changes) {
    std::vector<std::string> names;
    for (const FeatureChange& change : changes)
        if (change.verdict == Verdict::same || change.verdict == Verdict::interaction_changed)
            names.push_back(change.name);
    return names;
}

void note_unrelated(const PartState& old_state, const PartState& new_state, std::vector<Message>& notes) {
    const auto& features = new_state.tree.features;
    // Every document has an origin and most have a sketch: only what has a volume tells parts apart.
    const bool common = std::any_of(features.begin(), features.end(), [&](const Feature& f) {
        const auto old_id = old_state.tree.find(f.name);
        return old_id && !f.volumes.empty() && !old_state.tree[*old_id].volumes.empty();
    });
    if (!common) notes.push_back(say<Code::parts_unrelated>());
}

void limit_motions(std::vector<MovedFeatures>& moved, std::vector<Message>& notes) {
    if (moved.size() <= most_motions) return;
    notes.push_back(say<Code::many_motions>(moved.size(), most_motions));
    moved.resize(most_motions);
}

FeatureDifference compare_states(const PartState& old_state, const PartState& new_state, const Resolution& resolution,
                                 RunContext& context) {
    const Sameness sameness = sameness_of(old_state.brep.box(), new_state.brep.box());
    FeatureVerdicts verdicts = compare_features(old_state, new_state, sameness);
    const BoundaryModel old_model(old_state.brep), new_model(new_state.brep);
    context.progress(0.3);

    FeatureDifference difference;
    BoundaryMatch match;
    const BoundaryPair in_place{old_model, new_model, RigidMotion{}, std::nullopt, sameness};
    difference.regions.push_back(find_region(in_place, match));
    difference.regions[0].changed = changed_boundary(in_place, match, resolution);
    difference.regions[0].surface_of_old_face = match.group_of_old_face;
    difference.faces = face_changes(in_place, match, difference.regions[0]);
    context.progress(0.6);

    limit_motions(verdicts.moved, difference.notes);
    for (std::size_t m = 0; m < verdicts.moved.size(); ++m) {
        MovedFeatures& moved = verdicts.moved[m];
        const BoundaryPair pair{old_model, new_model, moved.motion,
                                domain_of(moved, verdicts.everything_moved, resolution.finest), sameness};
        CarriedRegion region = find_region(pair, match);
        region.features = std::move(moved.features);
        region.volumes = std::move(moved.additive_volumes);
        // Among solids a hole takes no material along, so nobody will ask.
        const Brep& brep = new_state.brep;
        const bool takes_nothing = region.volumes.empty() && brep.dimension() == Dimension::solids &&
                                   !brep.has_free_faces() && !brep.has_free_edges();
        region.changed = takes_nothing ? ChangedBoundary({}, Box{}) : changed_boundary(pair, match, resolution);
        difference.regions.push_back(std::move(region));
        context.progress(0.6 + 0.4 * double(m + 1) / double(verdicts.moved.size()));
    }

    difference.features = std::move(verdicts.changes);
    add_face_verdicts(old_state, new_state, difference.faces, difference.features);
    difference.regions[0].features = names_of_unmoved(difference.features);
    note_unrelated(old_state, new_state, difference.notes);
    return difference;
}
}  // namespace

FeatureDifference compare(const PartState& old_state, const PartState& new_state, const Resolution& resolution,
                          RunContext& context) {
    const RunContext::Step step(context, "difference");
    if (!(resolution.finest > 0) || !std::isfinite(resolution.finest))
        throw InputError(say<Code::resolution_not_positive>(Length{resolution.finest}));
    try {
        return compare_states(old_state, new_state, resolution, context);
    } catch (const Standard_Failure& failure) {
        const char* why = failure.GetMessageString();
        throw KernelError(say<Code::states_not_compared>(why ? why : "no reason given"));
    }
}

}  // namespace featuremesh
