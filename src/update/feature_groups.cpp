// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/feature_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brep/enclosure.h"
#include "brep/occt_geometry.h"
#include "core/geometry.h"
#include "core/sort_once.h"
#include "features/feature_tree.h"
#include "mesh/mesh.h"

namespace featuremesh {

namespace {

constexpr std::size_t points_per_column = 64;

/// The middles of all tets, in columns along z.
class Centroids {
  public:
    explicit Centroids(const Mesh& mesh) {
        points_.reserve(mesh.tets.size());
        for (const auto& tet : mesh.tets)
            points_.push_back((mesh.point(tet[0]) + mesh.point(tet[1]) + mesh.point(tet[2]) + mesh.point(tet[3])) / 4);
        for (const Vec3& p : points_) box_.add(p);
        across_ = std::max<std::size_t>(1, std::size_t(std::sqrt(double(points_.size()) / points_per_column)));
        std::vector<std::size_t> column_of;
        column_of.reserve(points_.size());
        for (const Vec3& p : points_)
            column_of.push_back(column(p.x, box_.low.x, box_.high.x) * across_ + column(p.y, box_.low.y, box_.high.y));
        start_.resize(across_ * across_ + 1);
        for (const std::size_t c : column_of) ++start_[c + 1];
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
        tets_.resize(points_.size());
        for (std::size_t t = 0; t < points_.size(); ++t) tets_[next[column_of[t]]++] = std::uint32_t(t);
    }

    const Vec3& operator[](std::size_t tet) const { return points_[tet]; }

    std::vector<std::uint32_t> in(const Box& box) const {
        std::vector<std::uint32_t> found;
        if (points_.empty() || !box.overlaps(box_)) return found;
        for (std::size_t i = column(box.low.x, box_.low.x, box_.high.x);
             i <= column(box.high.x, box_.low.x, box_.high.x); ++i)
            for (std::size_t j = column(box.low.y, box_.low.y, box_.high.y);
                 j <= column(box.high.y, box_.low.y, box_.high.y); ++j)
                for (std::size_t k = start_[i * across_ + j]; k < start_[i * across_ + j + 1]; ++k)
                    if (box.contains(points_[tets_[k]])) found.push_back(tets_[k]);
        return found;
    }

  private:
    std::size_t column(double at, double low, double high) const {
        const double share = (at - low) / std::max(high - low, 1e-300);
        return std::min(std::size_t(std::max(share, 0.0) * double(across_)), across_ - 1);
    }

    std::vector<Vec3> points_;
    Box box_;
    std::size_t across_ = 1;
    std::vector<std::size_t> start_;   // by column, into tets_
    std::vector<std::uint32_t> tets_;  // by column
};

void add_tets_in(const TopoDS_Shape& volume, const Centroids& centroids, std::vector<TetId>& tets,
                 RunContext& context) {
    const std::vector<std::uint32_t> candidates = centroids.in(box_of(volume));
    if (candidates.empty()) return;
    const Enclosure enclosure({volume});
    std::vector<char> is_inside(candidates.size(), 0);
    parallel_for(context, candidates.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) is_inside[i] = enclosure.contains(centroids[candidates[i]]);
    });
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (is_inside[i]) tets.push_back(TetId(std::size_t(candidates[i])));
}

}  // namespace

std::vector<std::pair<std::string, std::vector<TetId>>> tets_of_features(const PartMesh& part, RunContext& context) {
    const Centroids centroids(part.mesh);
    std::vector<std::pair<std::string, std::vector<TetId>>> groups;
    for (const Feature& feature : part.part.tree.features) {
        context.check_cancelled();
        std::vector<TetId> tets;
        for (const FeatureVolume& volume : feature.volumes) add_tets_in(volume.shape, centroids, tets, context);
        sort_once(tets);
        if (!tets.empty()) groups.emplace_back(feature.name, std::move(tets));
    }
    return groups;
}

}  // namespace featuremesh
