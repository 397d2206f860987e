// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/final_faces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "brep/face_probe.h"
#include "core/box_tree.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/sort_once.h"

namespace featuremesh {

namespace {

class Matcher {
  public:
    Matcher(CellModel& model, const Brep& final_shape, RunContext& context)
        : model_(model), final_shape_(final_shape), context_(context) {
        std::vector<Box> boxes;
        for (std::size_t f = 0; f < final_shape.face_count(); ++f) {
            final_faces_.emplace_back(final_shape.face(FaceId(f)));
            boxes.push_back(final_faces_.back().box().grown(boolean_tolerance));
        }
        tree_.emplace(boxes);
        for (const CellFace& face : model.faces) cell_faces_.emplace_back(face.face);
        model.owners_of_final_face.assign(final_shape.face_count(), {});
    }

    void run() {
        for (std::size_t f = 0; f < model_.faces.size(); ++f)
            if (is_boundary(model_.faces[f])) match(f);
        for (std::size_t f = 0; f < final_faces_.size(); ++f)
            if (model_.owners_of_final_face[f].empty()) find_owners(FaceId(f), true);
        // Where solids of the final shape touch, or one touches itself, their faces have material behind and before
        // them.
        for (std::size_t f = 0; f < final_faces_.size(); ++f)
            if (model_.owners_of_final_face[f].empty()) find_owners(FaceId(f), false);
        for (auto& owners : model_.owners_of_final_face) sort_once(owners);
    }

  private:
    bool is_material(CellId id) const { return id.is_valid() && model_.cells[id.index()].material; }
    bool is_boundary(const CellFace& face) const { return is_material(face.cells[0]) != is_material(face.cells[1]); }

    /// Out of the material on the cell face, at a point of it.
    Vec3 outward(const CellFace& face, const FaceProbe& probe, const Vec3& p) const {
        return probe.normal_at(p) * (is_material(face.cells[0]) ? 1.0 : -1.0);
    }

    /// Orientation in the final shape: as first met there, so the solid may lie behind or before it.
    Vec3 outward(FaceId face, const Vec3& p) const {
        const bool behind = final_shape_.solids_beside(face)[0].is_valid();
        return final_faces_[face.index()].normal_at(p) * (behind ? 1.0 : -1.0);
    }

    void give(FaceId final_face, const CellFace& face) {
        auto& owners = model_.owners_of_final_face[final_face.index()];
        owners.insert(owners.end(), face.owners.begin(), face.owners.end());
    }

    void match(std::size_t index) {
        context_.progress(0.9);
        CellFace& face = model_.faces[index];
        face.final_face = final_shape_.find(face.face);
        if (!face.final_face.is_valid()) {
            const FaceProbe& probe = cell_faces_[index];
            if (!probe.inner_point()) return;
            face.final_face = final_face_at(*probe.inner_point(), outward(face, probe, *probe.inner_point()));
        }
        if (face.final_face.is_valid()) give(face.final_face, face);
    }

    FaceId final_face_at(const Vec3& p, const Vec3& normal) const {
        std::vector<std::int32_t> near;
        tree_->visit_around(p, [&](std::int32_t f) { near.push_back(f); });
        std::sort(near.begin(), near.end());
        for (const std::int32_t f : near)
            if (final_faces_[std::size_t(f)].contains(p, boolean_tolerance) &&
                dot(outward(FaceId(f), p), normal) > same_normal)
                return FaceId(f);
        return {};
    }

    /// The final face may be smaller than the cell faces on it: look from the final one.
    void find_owners(FaceId id, bool on_boundary) {
        context_.progress(0.9);
        const auto& p = final_faces_[id.index()].inner_point();
        if (!p) return;
        const Vec3 normal = outward(id, *p);
        for (std::size_t f = 0; f < cell_faces_.size(); ++f) {
            CellFace& face = model_.faces[f];
            if (is_boundary(face) != on_boundary) continue;
            const FaceProbe& probe = cell_faces_[f];
            if (!probe.contains(*p, boolean_tolerance)) continue;
            const double cosine = dot(outward(face, probe, *p), normal);
            if ((on_boundary ? cosine : std::abs(cosine)) < same_normal) continue;
            if (!face.final_face.is_valid()) face.final_face = id;
            give(id, face);
        }
    }

    CellModel& model_;
    const Brep& final_shape_;
    RunContext& context_;
    std::vector<FaceProbe> final_faces_, cell_faces_;
    std::optional<BoxTree> tree_;  // of the boxes of the final ones
};

}  // namespace

void match_final_faces(CellModel& model, const Brep& final_shape, RunContext& context) {
    Matcher(model, final_shape, context).run();
}

}  // namespace featuremesh
