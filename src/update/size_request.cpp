// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/size_request.h"

#include <algorithm>
#include <cmath>

#include "core/geometry.h"
#include "core/messages.h"
#include "mesh/quality.h"
#include "mesh/sharp_angles.h"

namespace featuremesh {

namespace {

SizeSource half_length_at(const Mesh& mesh, std::size_t triangle) {
    const auto& corners = mesh.triangles[triangle];
    const Vec3 &a = mesh.point(corners[0]), &b = mesh.point(corners[1]), &c = mesh.point(corners[2]);
    return {(a + b + c) / 3, 0.5 * std::max({distance(a, b), distance(b, c), distance(c, a)})};
}

std::array<Vec3, 4> corners_of(const Mesh& mesh, TetId tet) {
    const auto& [a, b, c, d] = mesh.tets[tet.index()];
    return {mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)};
}

double smallest_angle(const std::array<Vec3, 4>& p) { return dihedral_range(p[0], p[1], p[2], p[3]).smallest_deg; }

constexpr double least_share = 0.15;  ///< of its length that a tet with a small angle asks for

/// An angle is about a height over the length; this gives the length with which it is a good one.
SizeSource length_for_angle(const std::array<Vec3, 4>& p) {
    constexpr double wanted_deg = 20;
    double longest = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j) longest = std::max(longest, distance(p[i], p[j]));
    return {(p[0] + p[1] + p[2] + p[3]) / 4, longest * std::max(least_share, smallest_angle(p) / wanted_deg)};
}

}  // namespace

SmallAngles small_angles(const Mesh& mesh) {
    constexpr std::size_t one_tet_in = 100;
    SmallAngles found;
    const double limit = found.smallest;
    std::vector<TetId> small;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
        if (smallest_angle(corners_of(mesh, TetId(t))) < limit) small.emplace_back(t);
    if (small.empty()) return found;
    const SharpAngles sharp(mesh, QualityReport::small_angle_deg);
    small.erase(std::remove_if(small.begin(), small.end(), [&](TetId t) { return sharp.force(t); }), small.end());
    found.count = small.size();
    for (const TetId t : small) found.smallest = std::min(found.smallest, smallest_angle(corners_of(mesh, t)));
    const bool is_hopeless = found.smallest < least_share * limit;
    if (small.empty() || is_hopeless || small.size() * one_tet_in > mesh.tets.size()) return found;
    found.request = {SizeReason::small_angles, as_parameter(mesh.tet_solids[small.front().index()]), {}};
    for (const TetId t : small) found.request.lengths.push_back(length_for_angle(corners_of(mesh, t)));
    return found;
}

SizeRequest for_turned_triangles(const Mesh& mesh, const std::vector<TriangleId>& turned) {
    SizeRequest request{SizeReason::cannot_follow, as_parameter(mesh.triangle_faces[turned.front().index()])};
    for (const TriangleId t : turned) request.lengths.push_back(half_length_at(mesh, t.index()));
    return request;
}

Message turned_over(const Mesh& mesh, const std::vector<TriangleId>& turned) {
    const std::size_t first = turned.front().index();
    return say<Code::triangles_turned_over>(turned.size(), mesh.triangle_faces[first],
                                            mesh.point(mesh.triangles[first][0]));
}

std::vector<SolidId> solids_off_volume(const Mesh& mesh, const Brep& brep, double tolerance) {
    std::vector<double> volumes(brep.solid_count(), 0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const auto& [a, b, c, d] = mesh.tets[t];
        volumes[mesh.tet_solids[t].index()] +=
            signed_volume(mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d));
    }
    std::vector<SolidId> off;
    for (std::size_t s = 0; s < volumes.size(); ++s) {
        const double wanted = brep.volume_of(SolidId(s));
        if (std::abs(volumes[s] - wanted) > tolerance * std::abs(wanted)) off.emplace_back(s);
    }
    return off;
}

SizeRequest for_volume_of(const Mesh& mesh, const Brep& brep, SolidId solid) {
    SizeRequest request{SizeReason::cannot_follow, as_parameter(solid)};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto solids = brep.solids_beside(mesh.triangle_faces[t]);
        if (std::find(solids.begin(), solids.end(), solid) != solids.end())
            request.lengths.push_back(half_length_at(mesh, t));
    }
    return request;
}

}  // namespace featuremesh
