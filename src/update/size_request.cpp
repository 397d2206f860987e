// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/size_request.h"

#include <algorithm>
#include <cmath>

#include "core/geometry.h"
#include "core/messages.h"

namespace featuremesh {

namespace {

SizeSource half_length_at(const Mesh& mesh, std::size_t triangle) {
    const auto& corners = mesh.triangles[triangle];
    const Vec3 &a = mesh.point(corners[0]), &b = mesh.point(corners[1]), &c = mesh.point(corners[2]);
    return {(a + b + c) / 3, 0.5 * std::max({distance(a, b), distance(b, c), distance(c, a)})};
}

}  // namespace

SizeRequest for_triangles(const Mesh& mesh, const std::vector<TriangleId>& triangles, SizeReason reason) {
    SizeRequest request{reason, as_parameter(mesh.triangle_faces[triangles.front().index()])};
    for (const TriangleId t : triangles) request.lengths.push_back(half_length_at(mesh, t.index()));
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
