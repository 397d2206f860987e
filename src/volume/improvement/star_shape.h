// SPDX-License-Identifier: GPL-3.0-or-later
// The tets round one point: what they are worth with the point elsewhere.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "volume/improvement/objective.h"
#include "volume/tets/flatness_of_four.h"
#include "volume/tets/radius_ratios.h"
#include "volume/tets/tet_complex.h"

namespace featuremesh {

/// The triangles a point sees, each with positive volume (point, a, b, c): the star of a vertex, or the outside of a
/// cavity that is filled from one point.
class StarShape {
  public:
    explicit StarShape(const Objective& objective) : objective_(objective) {}

    void clear(bool is_on_boundary = false) { faces_.clear(), fours_.clear(), is_on_boundary_ = is_on_boundary; }
    void add(const Vec3& a, const Vec3& b, const Vec3& c, const std::array<bool, 3>& is_on_boundary = {});
    void gather(const TetComplex& complex, std::span<const int> star, int vertex);

    /// The worst tet's flaw; stops early, with some value >= limit, once it reaches `limit`.
    double worst(const Vec3& point, double limit = 2 * inverted_flatness) const;
    Value value(const Vec3& point) const;

    RadiusRatios radius_ratios(const Vec3& point) const { return featuremesh::radius_ratios(point, faces_); }
    double sum_of_radius_ratios(const Vec3& point) const { return featuremesh::sum_of_radius_ratios(point, faces_); }

    /// Mean distance of the point from a corner of each triangle.
    double mean_distance(const Vec3& point) const;
    /// The mean of the triangles' corners.
    Vec3 middle() const;

    /// Deterministic hill climbing from `point`, which is moved along the `ways` where `may_be_at` agrees; gives the
    /// worst flaw there. Stops at `good_enough`.
    template <class MayBeAt>
    double climb(Vec3& point, double good_enough, std::span<const Vec3> ways, const MayBeAt& may_be_at) const;
    /// The same in all directions.
    double climb(Vec3& point, double good_enough) const;

  private:
    double flaw_at(const Vec3& point, const SeenTriangle& face) const {
        const auto& [a, b, c] = face.corners;
        const auto& on = face.is_on_boundary;
        return objective_.flaw({point, a, b, c}, {is_on_boundary_, on[0], on[1], on[2]});
    }

    template <class Visit>
    void visit_flaws(const Vec3& point, const Visit& visit) const;
    void swap_faces(std::size_t i, std::size_t j) const;

    const Objective& objective_;
    bool is_on_boundary_ = false;
    // the triangle that refused last is the likeliest to refuse again and moves to the front
    mutable std::vector<SeenTriangle> faces_;
    mutable std::vector<FourTriangles> fours_;  // the same, four at a time; the last may be filled up
};

template <class MayBeAt>
double StarShape::climb(Vec3& point, double good_enough, std::span<const Vec3> ways, const MayBeAt& may_be_at) const {
    // a search ends by itself with far fewer calls, but each call may gain by rounding alone; one for a place with a
    // volume goes on as long as it may get there
    constexpr int most_calls = 1000, most_slow_calls = 20;
    double best = worst(point);
    double step = 0.2 * mean_distance(point);
    // what hardly has a volume may have to find a place of next to no size
    const double last = (best > 1 ? 1e-4 : 0.02) * step;
    if (best > 1)
        for (const double share : {1.0, 0.5, 0.25, 0.1}) {
            const Vec3 trial = point + share * (middle() - point);
            if (const double value = worst(trial, best); value < best && may_be_at(trial)) best = value, point = trial;
        }
    int slow_calls = 0;
    for (int i = 0; i < most_calls && step > last && best > good_enough && slow_calls < most_slow_calls; ++i) {
        bool is_better = false;
        const double before = best;
        for (const Vec3& way : ways) {
            const Vec3 trial = point + step * way;
            const double value = worst(trial, best);
            if (value >= best || !may_be_at(trial)) continue;
            best = value, point = trial, is_better = true;
        }
        if (!is_better) step *= 0.5;
        slow_calls = is_better && before - most_calls * (before - best) > 1 ? slow_calls + 1 : 0;
    }
    return best;
}

}  // namespace featuremesh
