// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/delaunay/region_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace featuremesh {

namespace {

/// Twice the signed area of (p, a, b) in the plane.
double cross2(double au, double av, double bu, double bv) { return au * bv - av * bu; }

}  // namespace

RegionLocator::RegionLocator(std::span<const Vec3> points, std::span<const Facet> facets)
    : points_(points), facets_(facets) {
    for (const Facet& f : facets)
        for (const int c : f.corners) box_.add(points[c]);
    if (box_.is_empty()) box_.add(Vec3{});
    const Vec3 size = box_.size();
    w_ = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    u_ = (w_ + 1) % 3, v_ = (w_ + 2) % 3;
    const double longest = std::max({size[u_], size[v_], 1e-300}), columns_wanted = double(facets.size()) + 1;
    width_ = std::max(std::sqrt(size[u_] * size[v_] / columns_wanted), longest / columns_wanted);
    count_u_ = static_cast<int>(size[u_] / width_) + 1;
    count_v_ = static_cast<int>(size[v_] / width_) + 1;

    begin_.assign(static_cast<std::size_t>(count_u_) * count_v_ + 1, 0);
    struct Columns {
        int first_u, last_u, first_v, last_v;
    };
    std::vector<Columns> columns;
    columns.reserve(facets_.size());
    for (const Facet& f : facets_) {
        Box box;
        for (const int c : f.corners) box.add(points_[c]);
        columns.push_back({place_u(box.low), place_u(box.high), place_v(box.low), place_v(box.high)});
    }
    const auto visit_columns = [&](std::size_t facet, auto&& visit) {
        const Columns& c = columns[facet];
        for (int j = c.first_v; j <= c.last_v; ++j)
            for (int i = c.first_u; i <= c.last_u; ++i) visit(j * count_u_ + i);
    };
    for (std::size_t i = 0; i < facets_.size(); ++i) visit_columns(i, [&](int column) { ++begin_[column + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    column_facets_.resize(begin_.back());
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < facets_.size(); ++i)
        visit_columns(i, [&](int column) { column_facets_[next[column]++] = static_cast<int>(i); });
}

int RegionLocator::place(double offset, int count) const {
    return std::clamp(static_cast<int>(offset / width_), 0, count - 1);
}

bool RegionLocator::meet(const Facet& facet, const Ray& ray, Hit& hit) const {
    const Vec3 &a = points_[facet.corners[0]], &b = points_[facet.corners[1]], &c = points_[facet.corners[2]];
    const double au = a[u_] - ray.u, av = a[v_] - ray.v, bu = b[u_] - ray.u, bv = b[v_] - ray.v;
    const double cu = c[u_] - ray.u, cv = c[v_] - ray.v;
    if (std::min({au, bu, cu}) > 0 || std::max({au, bu, cu}) < 0 || std::min({av, bv, cv}) > 0 ||
        std::max({av, bv, cv}) < 0)
        return false;
    const double wa = cross2(bu, bv, cu, cv), wb = cross2(cu, cv, au, av), wc = cross2(au, av, bu, bv);
    const double area = wa + wb + wc;
    const double reach = std::max({std::abs(au), std::abs(bu), std::abs(cu), std::abs(av), std::abs(bv), std::abs(cv)});
    const double doubt = 1e-9 * reach * reach;
    const double low = std::min({wa, wb, wc}), high = std::max({wa, wb, wc});
    if (low < -doubt && high > doubt) return false;
    hit.is_doubtful = low < doubt && high > -doubt;
    hit.w = hit.is_doubtful ? std::max({a[w_], b[w_], c[w_]}) : (wa * a[w_] + wb * b[w_] + wc * c[w_]) / area;
    hit.region = area > 0 ? facet.regions[0] : facet.regions[1];  // seen from below, against w
    return true;
}

int RegionLocator::region_at(const Vec3& p, double clearance) const {
    if (!box_.contains(p)) return -1;
    constexpr int attempts = 8;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        Ray ray = ray_from(p);
        ray.u += 0.37 * clearance * std::sin(1.0 + 2.4 * attempt);  // directions that no CAD model prefers
        ray.v += 0.37 * clearance * std::cos(1.7 + 3.1 * attempt);
        Hit nearest{std::numeric_limits<double>::infinity(), -1, false};
        const int column = place(ray.v - box_.low[v_], count_v_) * count_u_ + place(ray.u - box_.low[u_], count_u_);
        for (int i = begin_[column]; i < begin_[column + 1]; ++i) {
            Hit hit;
            if (!meet(facets_[column_facets_[i]], ray, hit) || hit.w <= ray.w) continue;
            if (hit.is_doubtful) {
                nearest = hit;
                break;
            }
            if (hit.w < nearest.w) nearest = hit;
        }
        if (!nearest.is_doubtful) return nearest.region;
    }
    return -1;
}

}  // namespace featuremesh
