// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/polygon_cut.h"

#include <algorithm>
#include <cmath>

namespace featuremesh {

namespace {

/// Below this share of the squared sides an area is rounding.
constexpr double no_area = 1e-10;

class EarCutter {
  public:
    EarCutter(std::span<const Vec3> points, std::vector<int> outline, const Vec3& normal)
        : points_(points), outline_(std::move(outline)), normal_(normalized(normal)) {}

    bool cut(std::vector<std::array<int, 3>>& triangles) {
        while (outline_.size() > 3) {
            const int ear = best_ear();
            if (ear < 0) return false;
            triangles.push_back(corners_at(ear));
            outline_.erase(outline_.begin() + ear);
        }
        triangles.push_back(corners_at(1));
        return share_of_area(triangles.back()) > no_area;
    }

  private:
    std::array<int, 3> corners_at(int i) const {
        const std::size_t n = outline_.size(), at = static_cast<std::size_t>(i);
        return {outline_[(at + n - 1) % n], outline_[at], outline_[(at + 1) % n]};
    }
    double area(int a, int b, int c) const {
        return dot(normal_, cross(points_[b] - points_[a], points_[c] - points_[a]));
    }
    double share_of_area(const std::array<int, 3>& t) const {
        const double squares = squared_length(points_[t[1]] - points_[t[0]]) +
                               squared_length(points_[t[2]] - points_[t[1]]) +
                               squared_length(points_[t[0]] - points_[t[2]]);
        return area(t[0], t[1], t[2]) / squares;
    }
    bool holds(const std::array<int, 3>& t, int p) const {
        const double limit = -1e-12 * area(t[0], t[1], t[2]);
        return area(t[0], t[1], p) > limit && area(t[1], t[2], p) > limit && area(t[2], t[0], p) > limit;
    }
    int best_ear() const {
        int best = -1;
        double best_share = no_area;
        for (int i = 0; i < static_cast<int>(outline_.size()); ++i) {
            const auto t = corners_at(i);
            const double share = share_of_area(t);
            if (share <= best_share) continue;
            const bool is_free = std::none_of(outline_.begin(), outline_.end(), [&](int p) {
                return p != t[0] && p != t[1] && p != t[2] && holds(t, p);
            });
            if (is_free) best = i, best_share = share;
        }
        return best;
    }

    std::span<const Vec3> points_;
    std::vector<int> outline_;
    Vec3 normal_;
};

}  // namespace

bool cut_polygon(std::span<const Vec3> points, std::vector<int> outline, const Vec3& normal,
                 std::vector<std::array<int, 3>>& triangles) {
    return EarCutter(points, std::move(outline), normal).cut(triangles);
}

}  // namespace featuremesh
