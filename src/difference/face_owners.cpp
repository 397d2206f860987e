// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/face_owners.h"

#include <algorithm>

namespace featuremesh {

FaceOwners::FaceOwners(const PartState& state) : state_(state) {
    if (state.cells.owners_of_final_face.empty()) by_points_.emplace(state.tree);
}

std::vector<Owner> FaceOwners::of(FaceId face) const {
    const std::vector<char> everybody(state_.tree.features.size(), 1);
    std::vector<Owner> owners = of(face, everybody);
    return owners.empty() ? owners_of_anything(state_.tree) : owners;
}

std::vector<Owner> FaceOwners::of(FaceId face, std::span<const char> is_wanted) const {
    if (by_points_) return by_points_->owners_on(state_.brep.face(face), state_.brep.box_of(face), is_wanted);
    std::vector<Owner> owners = state_.cells.owners_of_final_face[face.index()];
    std::erase_if(owners, [&](const Owner& owner) { return !is_wanted[owner.feature.index()]; });
    return owners;
}

std::vector<std::vector<Owner>> owners_of_faces(const PartState& state) {
    const FaceOwners owners(state);
    std::vector<std::vector<Owner>> of_face;
    for (std::size_t f = 0; f < state.brep.face_count(); ++f) of_face.push_back(owners.of(FaceId(f)));
    return of_face;
}

std::vector<std::vector<std::string>> names_of_owners(const PartState& state) {
    std::vector<std::vector<std::string>> of_face;
    for (const std::vector<Owner>& owners : owners_of_faces(state)) {
        std::vector<std::string>& names = of_face.emplace_back();
        for (const Owner& owner : owners) {
            const std::string& name = state.tree[owner.feature].name;
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
    }
    return of_face;
}

}  // namespace featuremesh
