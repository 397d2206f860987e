// SPDX-License-Identifier: GPL-3.0-or-later
// Which region a point away from the facets lies in.
#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"
#include "volume/facet.h"

namespace featuremesh {

/// Shoots rays along one axis at facets that are sorted into columns: a query costs what one column holds.
class RegionLocator {
  public:
    /// Keeps the spans; they must outlive it.
    RegionLocator(std::span<const Vec3> points, std::span<const Facet> facets);

    /// The region before the first facet that a ray from `p` meets; -1 outside all. `clearance` is a distance
    /// within which no facet is, mm: the ray may start anywhere in there, which keeps it off the facets' edges.
    int region_at(const Vec3& p, double clearance) const;

  private:
    struct Hit {
        double w = 0;
        int region = -1;
        bool is_doubtful = false;
    };
    struct Ray {
        double u, v, w;
    };
    Ray ray_from(const Vec3& p) const { return {p[u_], p[v_], p[w_]}; }
    int place(double offset, int count) const;
    int place_u(const Vec3& p) const { return place(p[u_] - box_.low[u_], count_u_); }
    int place_v(const Vec3& p) const { return place(p[v_] - box_.low[v_], count_v_); }
    bool meet(const Facet& facet, const Ray& ray, Hit& hit) const;

    std::span<const Vec3> points_;
    std::span<const Facet> facets_;
    Box box_;
    int u_ = 0, v_ = 1, w_ = 2;
    int count_u_ = 1, count_v_ = 1;
    double width_ = 1;
    std::vector<int> begin_, column_facets_;
};

}  // namespace featuremesh
