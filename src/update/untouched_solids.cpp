// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/untouched_solids.h"

#include <algorithm>
#include <span>

#include "core/ids.h"
#include "difference/feature_difference.h"
#include "update/solids_beside.h"

namespace featuremesh {
namespace {

constexpr std::int32_t none = -1;

class UntouchedSolids {
  public:
    explicit UntouchedSolids(const KeepInput& input)
        : in_(input),
          old_faces_(faces_of_solids(input.old_brep)),
          new_faces_(faces_of_solids(input.new_brep)),
          motions_(old_faces_.size(), none) {}

    std::vector<std::int32_t> find() {
        take_those_kept_as(faces_kept_in_place(), 0);
        const auto& regions = in_.difference.regions;
        for (std::size_t r = 1; r < regions.size(); ++r)
            if (!regions[r].volumes.empty()) take_those_kept_as(faces_carried(regions[r]), std::int32_t(r));
        return std::move(motions_);
    }

  private:
    void take_those_kept_as(const std::vector<FaceId>& kept_as, std::int32_t motion) {
        for (std::size_t s = 0; s < old_faces_.size(); ++s) {
            if (motions_[s] != none || (motion > 0 && shares_faces(s))) continue;
            std::vector<FaceId> now;
            for (const FaceId f : old_faces_[s]) now.push_back(kept_as[f.index()]);
            std::sort(now.begin(), now.end());
            if (std::find(new_faces_.begin(), new_faces_.end(), now) != new_faces_.end()) motions_[s] = motion;
        }
    }

    bool shares_faces(std::size_t solid) const {
        return std::any_of(old_faces_[solid].begin(), old_faces_[solid].end(), [&](FaceId f) {
            const auto solids = in_.old_brep.solids_beside(f);
            return solids[0].is_valid() && solids[1].is_valid();
        });
    }

    std::vector<FaceId> faces_kept_in_place() const {
        std::vector<FaceId> kept_as(in_.old_brep.face_count());
        for (const FaceChange& change : in_.difference.faces)
            if (change.verdict == BoundaryVerdict::kept &&
                has_same_vertices_inside(in_.difference.regions[0], change.old_face, change.new_face))
                kept_as[change.old_face.index()] = change.new_face;
        return kept_as;
    }

    /// Those whose edges, with their ends, are the edges of the new face.
    std::vector<FaceId> faces_carried(const CarriedRegion& region) const {
        std::vector<FaceId> kept_as(in_.old_brep.face_count());
        for (std::size_t f = 0; f < kept_as.size(); ++f) {
            const FaceId now = region.new_face_of[f];
            if (now.is_valid() && has_same_edges(region, FaceId(f), now) &&
                has_same_vertices_inside(region, FaceId(f), now))
                kept_as[f] = now;
        }
        return kept_as;
    }

    bool has_same_edges(const CarriedRegion& region, FaceId old_face, FaceId new_face) const {
        std::vector<EdgeId> were;
        for (const EdgeId e : in_.old_brep.edges_of(old_face)) {
            const EdgeId now = region.new_edge_of[e.index()];
            if (!in_.old_brep.is_degenerated(e) && (!now.is_valid() || !has_same_ends(region, e, now))) return false;
            if (!in_.old_brep.is_degenerated(e)) were.push_back(now);
        }
        std::vector<EdgeId> are;
        for (const EdgeId e : in_.new_brep.edges_of(new_face))
            if (!in_.new_brep.is_degenerated(e)) are.push_back(e);
        return std::is_permutation(were.begin(), were.end(), are.begin(), are.end());
    }

    bool has_same_ends(const CarriedRegion& region, EdgeId old_edge, EdgeId new_edge) const {
        auto were = in_.old_brep.ends_of(old_edge);
        for (VertexId& v : were) v = region.new_vertex_of[v.index()];
        const auto are = in_.new_brep.ends_of(new_edge);
        return std::is_permutation(were.begin(), were.end(), are.begin(), are.end());
    }

    bool has_same_vertices_inside(const CarriedRegion& region, FaceId old_face, FaceId new_face) const {
        std::vector<VertexId> were;
        for (const VertexId v : in_.old_brep.vertices_inside(old_face)) were.push_back(region.new_vertex_of[v.index()]);
        const std::span<const VertexId> are = in_.new_brep.vertices_inside(new_face);
        return std::is_permutation(were.begin(), were.end(), are.begin(), are.end());
    }

    const KeepInput& in_;
    const std::vector<std::vector<FaceId>> old_faces_, new_faces_;
    std::vector<std::int32_t> motions_;
};

}  // namespace

std::vector<std::int32_t> motions_of_untouched_solids(const KeepInput& input) {
    if (input.old_brep.solid_count() < 2) return std::vector<std::int32_t>(input.old_brep.solid_count(), none);
    return UntouchedSolids(input).find();
}

}  // namespace featuremesh
