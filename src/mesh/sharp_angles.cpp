// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sharp_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/geometry.h"
#include "core/sort_once.h"

namespace featuremesh {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr int sides[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};

double angle_between(const Vec3& u, const Vec3& v) { return std::atan2(length(cross(u, v)), dot(u, v)) * degrees; }

/// The angle at edge (a, b) between the triangles to c and to d, degrees.
double dihedral_at(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return angle_between(cross(b - a, c - a), cross(b - a, d - a));
}

/// Keys whose angles add up to less than `limit`, sorted.
template <class Key>
std::vector<Key> keys_below(std::vector<std::pair<Key, double>> angles, double limit) {
    std::sort(angles.begin(), angles.end());
    std::vector<Key> below;
    for (std::size_t first = 0, last; first < angles.size(); first = last) {
        double sum = 0;
        for (last = first; last < angles.size() && angles[last].first == angles[first].first; ++last)
            sum += angles[last].second;
        if (sum < limit) below.push_back(angles[first].first);
    }
    return below;
}

}  // namespace

SharpAngles::SharpAngles(const Mesh& mesh, double angle_deg)
    : mesh_(mesh), short_sides_(mesh), is_sharp_node_(mesh.corner_count, 0) {
    find_sharp_segments(angle_deg);
    find_sharp_corners(angle_deg);
}

void SharpAngles::find_sharp_segments(double angle_deg) {
    using SegmentOfSolid = std::pair<std::int32_t, SolidId>;
    std::vector<std::pair<SegmentOfSolid, double>> angles;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
        const auto& n = mesh_.tets[t];
        for (const auto& [i, j, k, l] : sides) {
            if (mesh_.entities[n[i].index()].dim > 1 || mesh_.entities[n[j].index()].dim > 1) continue;
            const std::int32_t segment = short_sides_.segment_at(n[i], n[j]);
            if (segment < 0) continue;
            const double angle =
                dihedral_at(mesh_.point(n[i]), mesh_.point(n[j]), mesh_.point(n[k]), mesh_.point(n[l]));
            angles.push_back({{segment, mesh_.tet_solids[t]}, angle});
        }
    }
    std::vector<char> is_sharp(mesh_.segments.size(), 0);
    for (const auto& [segment, solid] : keys_below(std::move(angles), angle_deg)) {
        is_sharp[static_cast<std::size_t>(segment)] = 1;
        for (const NodeId n : mesh_.segments[static_cast<std::size_t>(segment)]) is_sharp_node_[n.index()] = 1;
    }
    find_wedge_faces(is_sharp);
}

void SharpAngles::find_sharp_corners(double angle_deg) {
    using CornerOfFace = std::pair<std::int32_t, FaceId>;
    std::vector<std::pair<CornerOfFace, double>> angles;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const auto& n = mesh_.triangles[t];
            if (mesh_.entities[n[i].index()].dim > 0) continue;
            const Vec3& at = mesh_.point(n[i]);
            const double angle = angle_between(mesh_.point(n[(i + 1) % 3]) - at, mesh_.point(n[(i + 2) % 3]) - at);
            angles.push_back({{n[i].value, mesh_.triangle_faces[t]}, angle});
        }
    for (const auto& [node, face] : keys_below(std::move(angles), angle_deg))
        is_sharp_node_[static_cast<std::size_t>(node)] = 1;
}

void SharpAngles::find_wedge_faces(const std::vector<char>& is_sharp_segment) {
    std::vector<std::pair<std::int32_t, FaceId>> faces_at;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const std::int32_t segment =
                short_sides_.segment_at(mesh_.triangles[t][i], mesh_.triangles[t][(i + 1) % 3]);
            if (segment >= 0 && is_sharp_segment[static_cast<std::size_t>(segment)])
                faces_at.push_back({segment, mesh_.triangle_faces[t]});
        }
    std::sort(faces_at.begin(), faces_at.end());
    for (std::size_t i = 0; i + 1 < faces_at.size(); ++i)
        for (std::size_t j = i + 1; j < faces_at.size() && faces_at[j].first == faces_at[i].first; ++j)
            if (faces_at[i].second != faces_at[j].second) wedges_.push_back({faces_at[i].second, faces_at[j].second});
    sort_once(wedges_);

    std::vector<FaceId> of_wedges;
    for (const auto& [a, b] : wedges_) of_wedges.insert(of_wedges.end(), {a, b});
    std::sort(of_wedges.begin(), of_wedges.end());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
        if (std::binary_search(of_wedges.begin(), of_wedges.end(), mesh_.triangle_faces[t]))
            for (const NodeId n : mesh_.triangles[t]) on_wedge_.push_back({n.value, mesh_.triangle_faces[t].value});
    sort_once(on_wedge_);
}

bool SharpAngles::lies_on(NodeId node, FaceId face) const {
    return std::binary_search(on_wedge_.begin(), on_wedge_.end(), std::pair{node.value, face.value});
}

bool SharpAngles::force(TetId tet) const {
    const auto& nodes = mesh_.tets[tet.index()];
    if (std::any_of(nodes.begin(), nodes.end(), [&](NodeId n) { return is_sharp_node_[n.index()]; })) return true;
    if (short_sides_.forced_side(tet)) return true;
    return std::any_of(wedges_.begin(), wedges_.end(), [&](const auto& wedge) {
        return std::all_of(nodes.begin(), nodes.end(),
                           [&](NodeId n) { return lies_on(n, wedge.first) || lies_on(n, wedge.second); });
    });
}

}  // namespace featuremesh
