// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/face_owners.h"

#include <algorithm>
#include <optional>

#include "difference/volume_faces.h"

namespace featuremesh {

namespace {

class OwnerHeritage {
  public:
    OwnerHeritage(const PartState& old_state, const PartState& new_state) : old_(old_state), new_(new_state) {
        for (const Feature& feature : old_state.tree.features) new_id_.push_back(new_state.tree.find(feature.name));
    }

    /// The same owner in the new tree.
    std::optional<Owner> heir_of(const Owner& owner) const {
        const auto id = new_id_[owner.feature.index()];
        if (!id || owner.volume >= int(new_.tree[*id].volumes.size())) return std::nullopt;
        return Owner{*id, owner.volume};
    }

    void add_kept(FaceId old_face, std::vector<Owner>& owners) const {
        for (const Owner& owner : old_.cells.owners_of_final_face[old_face.index()])
            if (const auto heir = heir_of(owner)) owners.push_back(*heir);
    }

    /// To new faces that were not kept, from the old faces that they overlap.
    void add_from_outside(const std::vector<std::vector<FaceId>>& new_faces_of, const std::vector<FaceId>& kept_from,
                          std::vector<std::vector<Owner>>& owners) const {
        for (std::size_t old = 0; old < new_faces_of.size(); ++old)
            for (const FaceId f : new_faces_of[old]) {
                if (kept_from[f.index()].is_valid()) continue;
                for (const Owner& owner : old_.cells.owners_of_final_face[old])
                    if (const auto heir = heir_of(owner); heir && reaches_out(*heir))
                        owners[f.index()].push_back(*heir);
            }
    }

  private:
    bool reaches_out(const Owner& owner) const {
        const auto& within = new_.cells.owners_within_edit;
        return !std::binary_search(within.begin(), within.end(), owner);
    }

    const PartState& old_;
    const PartState& new_;
    std::vector<std::optional<FeatureId>> new_id_;
};

}  // namespace

std::vector<std::vector<Owner>> owners_after_edit(const PartState& old_state, const PartState& new_state,
                                                  const FeatureDifference& difference) {
    const OwnerHeritage heritage(old_state, new_state);
    std::vector<FaceId> kept_from(new_state.brep.face_count());
    for (const FaceChange& face : difference.faces)
        if (face.verdict == BoundaryVerdict::kept) kept_from[face.new_face.index()] = face.old_face;
    const bool is_fused = !new_state.cells.owners_of_final_face.empty();
    std::optional<VolumeFaces> volume_faces;
    if (!is_fused) volume_faces.emplace(new_state.tree);
    std::vector<std::vector<Owner>> owners(kept_from.size());
    for (std::size_t f = 0; f < owners.size(); ++f) {
        if (kept_from[f].is_valid())
            heritage.add_kept(kept_from[f], owners[f]);
        else
            owners[f] = is_fused ? new_state.cells.owners_of_final_face[f]
                                 : volume_faces->owners_on(new_state.brep.face(FaceId(f)));
    }
    if (is_fused) heritage.add_from_outside(difference.regions[0].new_faces_of, kept_from, owners);
    for (auto& list : owners) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        if (list.empty()) list = owners_of_anything(new_state.tree);
    }
    return owners;
}

}  // namespace featuremesh
