// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/folded_triangles.h"

#include <algorithm>

#include "core/geometry.h"
#include "surface/chart.h"

namespace featuremesh {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Whether one of the two triangles that turning the side opposite corner i of t would make is folded.
bool gives_folded(const TrianglePatch& patch, const PatchGeometry& geometry, int t, int i) {
    const auto& c = patch.corners(t);
    const int n = patch.neighbour(t, i), a = c[at(i)], b = c[at((i + 1) % 3)], d = c[at((i + 2) % 3)];
    const int e = patch.corners(n)[at(patch.opposite_index(n, t))];
    return is_folded(patch, geometry, {a, b, e}) || is_folded(patch, geometry, {a, e, d});
}

}  // namespace

bool is_folded(const TrianglePatch& patch, const PatchGeometry& geometry, const std::array<int, 3>& corners) {
    constexpr double least_cosine = 0.25, noticeable_sag = 0.1;
    const Chart& chart = geometry.chart();
    if (chart.is_plane()) return false;
    std::array<Vec3, 3> places;
    for (int i = 0; i < 3; ++i) {
        const int p = corners[at(i)];
        places[at(i)] = geometry.is_flat() ? chart.point(patch.point(p)) : patch.place(p);
    }
    const auto& [a, b, c] = places;
    const Vec3 normal = normalized(cross(b - a, c - a));
    const auto is_against = [&](const Chart::Frame& frame) {
        const Vec3 across = cross(frame.dx, frame.dy);
        return dot(across, normal) < least_cosine * length(across);
    };
    const Chart::Frame middle =
        chart.frame((1.0 / 3) * (patch.point(corners[0]) + patch.point(corners[1]) + patch.point(corners[2])));
    if (is_against(middle)) return true;
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    if (distance(middle.point, (a + b + c) / 3) < noticeable_sag * longest) return false;
    return std::all_of(corners.begin(), corners.end(), [&](int p) {
        const bool is_apex = chart.cone_sine() != 0 && distance(patch.point(p), Vec2{}) < 1e-7 * longest;
        return is_apex || is_against(chart.frame(patch.point(p)));
    });
}

bool is_folded(const TrianglePatch& patch, const PatchGeometry& geometry, int t) {
    return !patch.is_at_pole(t) && is_folded(patch, geometry, patch.corners(t));
}

bool folds_by_turning(const TrianglePatch& patch, const PatchGeometry& geometry, int t, int i) {
    return !is_folded(patch, geometry, t) && !is_folded(patch, geometry, patch.neighbour(t, i)) &&
           gives_folded(patch, geometry, t, i);
}

bool unfold(TrianglePatch& patch, const PatchGeometry& geometry, int t) {
    for (int i = 0; i < 3; ++i) {
        if (patch.neighbour(t, i) < 0 || !patch.can_flip(t, i) || gives_folded(patch, geometry, t, i)) continue;
        patch.flip(t, i);
        return true;
    }
    return false;
}

}  // namespace featuremesh
