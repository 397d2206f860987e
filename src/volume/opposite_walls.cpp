// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/opposite_walls.h"

#include <algorithm>
#include <cmath>

namespace featuremesh {

namespace {

/// As for the walls that `elements_across_gap` is about.
constexpr double opposite_cosine = 0.7;

bool holds(const std::vector<FaceId>& faces, FaceId face) {
    return std::find(faces.begin(), faces.end(), face) != faces.end();
}

}  // namespace

OppositeWalls::OppositeWalls(const Brep& brep, const Mesh& mesh)
    : brep_(brep), mesh_(mesh), projector_(brep), neighbours_(brep.face_count()) {
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        for (const EdgeId edge : brep.edges_of(FaceId(f)))
            for (const FaceId other : brep.faces_of(edge)) neighbours_[f].push_back(other);
}

bool OppositeWalls::are_spanned_by(const std::array<NodeId, 4>& nodes) const {
    std::array<std::vector<FaceId>, 4> faces;
    for (int k = 0; k < 4; ++k) {
        if (!nodes[k].is_valid() || mesh_.entities[nodes[k].index()].dim == 3) return false;
        faces[k] = brep_.faces_at(mesh_.entities[nodes[k].index()]);
    }
    const auto first_off = [&](FaceId face) {
        int k = 0;
        while (k < 4 && holds(faces[k], face)) ++k;
        return k;
    };
    for (const FaceId a : faces[0]) {
        const int off_a = first_off(a);
        if (off_a == 4) continue;
        for (const FaceId b : faces[off_a]) {
            const int off_b = first_off(b);
            const bool covers =
                std::all_of(faces.begin(), faces.end(), [&](const auto& at) { return holds(at, a) || holds(at, b); });
            if (off_b < 4 && covers && are_opposite(a, nodes[off_b], b, nodes[off_a])) return true;
        }
    }
    return false;
}

bool OppositeWalls::are_opposite(FaceId a, NodeId on_a, FaceId b, NodeId on_b) const {
    return !holds(neighbours_[a.index()], b) && std::abs(dot(normal(a, on_a), normal(b, on_b))) > opposite_cosine;
}

Vec3 OppositeWalls::normal(FaceId face, NodeId node) const {
    const std::scoped_lock lock(mutex_);
    const auto [at, is_new] = normals_.try_emplace({face, node});
    if (is_new) at->second = projector_.normal(face, projector_.nearest(face, mesh_.point(node)).uv);
    return at->second;
}

}  // namespace featuremesh
