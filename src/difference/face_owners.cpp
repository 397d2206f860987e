// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/face_owners.h"

#include <algorithm>

#include "core/geometry.h"

namespace featuremesh {

namespace {

void add_once(std::vector<std::string>& words, const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
}

std::vector<FaceId> faces_at(const Brep& brep, Entity entity) {
    const auto index = std::size_t(entity.index);
    if (entity.dim == 2 && index < brep.face_count()) return {FaceId(index)};
    if (entity.dim != 1 || index >= brep.edge_count()) return {};
    const std::span<const FaceId> faces = brep.faces_of(EdgeId(index));
    return {faces.begin(), faces.end()};
}

}  // namespace

FaceOwners::FaceOwners(const PartState& state) : state_(state) {
    const Box& box = state.brep.box();
    if (state.cells.owners_of_final_face.empty())
        by_points_.emplace(state.tree, box.center() + Vec3{0.3137, 0.2281, 0.1739} * box.diagonal());
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

std::vector<std::vector<std::string>> labels_of_owners(const PartState& state, std::span<const Entity> entities) {
    const FaceOwners owners(state);
    const std::vector<char> everybody(state.tree.features.size(), 1);
    std::vector<std::vector<std::string>> of_entity;
    for (const Entity entity : entities) {
        std::vector<std::string>& labels = of_entity.emplace_back();
        for (const FaceId face : faces_at(state.brep, entity))
            for (const Owner& owner : owners.of(face, everybody)) add_once(labels, state.tree[owner.feature].label);
    }
    return of_entity;
}

std::vector<std::vector<std::string>> names_of_owners(const PartState& state) {
    std::vector<std::vector<std::string>> of_face;
    for (const std::vector<Owner>& owners : owners_of_faces(state)) {
        std::vector<std::string>& names = of_face.emplace_back();
        for (const Owner& owner : owners) add_once(names, state.tree[owner.feature].name);
    }
    return of_face;
}

}  // namespace featuremesh
