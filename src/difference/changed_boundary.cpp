// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/box_tree.h"
#include "core/distances.h"
#include "difference/feature_difference.h"

namespace featuremesh {
namespace {
using Triangle = std::array<Vec3, 3>;

double depth_in_box(const Vec3& p, const Box& box) {
    const Vec3 low = p - box.low, high = box.high - p;
    return std::max(0.0, std::min({low.x, low.y, low.z, high.x, high.y, high.z}));
}

/// Triangles lie beside those before them, for faces are halved into cells: so many together are one thing of the tree.
constexpr std::size_t run = 4;

std::vector<Box> boxes_of_runs(std::span<const Triangle> triangles) {
    std::vector<Box> boxes((triangles.size() + run - 1) / run);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const Vec3& corner : triangles[t]) boxes[t / run].add(corner);
    return boxes;
}

/// What changed on one underlying surface: triangles from `begin` to `end`.
struct OnSurface {
    std::size_t begin, end;
    Box box;
};

std::vector<OnSurface> by_surface(std::span<const Triangle> triangles, std::span<const std::size_t> ends) {
    std::vector<OnSurface> surfaces;
    for (std::size_t begin = 0; const std::size_t end : ends) {
        OnSurface& surface = surfaces.emplace_back(OnSurface{begin, end, {}});
        for (const Triangle& triangle : triangles.subspan(begin, end - begin))
            for (const Vec3& corner : triangle) surface.box.add(corner);
        begin = end;
    }
    return surfaces;
}
}  // namespace

struct ChangedBoundary::Tree {
    std::vector<Triangle> triangles;
    std::optional<Box> domain;
    std::vector<OnSurface> surfaces;
    BoxTree boxes{boxes_of_runs(triangles)};

    std::span<const Triangle> run_of(std::size_t number) const {
        return std::span(triangles).subspan(run * number, std::min(run, triangles.size() - run * number));
    }
    /// The smaller of `most` and the squared distance; of the places below `enough` any will do.
    double least_distance(const Vec3& p, double most, double enough) const {
        return boxes.least_distance(p, most, enough,
                                    [&](std::int32_t r) { return least_of(run_of(std::size_t(r)), p); });
    }
    /// The same to triangles on the surface alone.
    double least_distance(const Vec3& p, double most, double enough, const OnSurface& surface) const {
        return boxes.least_distance(p, most, enough, [&](std::int32_t r) {
            const std::size_t first = std::max(surface.begin, run * std::size_t(r)),
                              last = std::min(surface.end, run * (std::size_t(r) + 1));
            return first < last ? least_of(std::span(triangles).subspan(first, last - first), p)
                                : std::numeric_limits<double>::infinity();
        });
    }
    static double least_of(std::span<const Triangle> some, const Vec3& p) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : some) least = std::min(least, squared_distance_to_triangle(p, a, b, c));
        return least;
    }
};

ChangedBoundary::ChangedBoundary() : ChangedBoundary(std::vector<Triangle>{}) {}

ChangedBoundary::ChangedBoundary(std::vector<Triangle> triangles)
    : ChangedBoundary(std::move(triangles), std::span<const std::size_t>{}) {}

ChangedBoundary::ChangedBoundary(std::vector<Triangle> triangles, std::span<const std::size_t> ends) {
    std::vector<OnSurface> surfaces = by_surface(triangles, ends);
    tree_ = std::make_shared<Tree>(Tree{std::move(triangles), {}, std::move(surfaces)});
}

ChangedBoundary::ChangedBoundary(std::vector<Triangle> triangles, const Box& domain)
    : tree_(std::make_shared<Tree>(Tree{std::move(triangles), domain, {}})) {}

bool ChangedBoundary::is_empty() const { return tree_->triangles.empty() && !tree_->domain; }

std::span<const std::array<Vec3, 3>> ChangedBoundary::triangles() const { return tree_->triangles; }

double ChangedBoundary::distance(const Vec3& p, double limit) const {
    if (tree_->domain) limit = std::min(limit, depth_in_box(p, *tree_->domain));
    if (!(limit > 0)) return 0;
    const double best = tree_->least_distance(p, limit * limit, 0);
    return best < limit * limit ? std::sqrt(best) : limit;
}

bool ChangedBoundary::is_within(double reach, const Vec3& p) const {
    if (tree_->domain && depth_in_box(p, *tree_->domain) < reach) return true;
    return reach > 0 && tree_->least_distance(p, reach * reach, reach * reach) < reach * reach;
}

bool ChangedBoundary::is_within(double reach, const Vec3& p, std::size_t surface) const {
    const OnSurface& of = tree_->surfaces[surface];
    return of.box.grown(reach).contains(p) &&
           tree_->least_distance(p, reach * reach, reach * reach, of) < reach * reach;
}

Box ChangedBoundary::box() const {
    if (tree_->domain) return Box{Box{}.high, Box{}.low};
    return tree_->boxes.box();
}

}  // namespace featuremesh
