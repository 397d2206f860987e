// SPDX-License-Identifier: GPL-3.0-or-later
// The dearer ways to get rid of a bad tet: a cavity round it is filled from one of its vertices (multi-face flip,
// collapse) or from a new one.
#pragma once

#include <span>
#include <vector>

#include "volume/cone_cavity.h"
#include "volume/tet_measures.h"

namespace featuremesh {

/// What it takes to do it, and how flat the worst tet is then.
struct ConePlan {
    double flatness = inverted_flatness;
    bool is_insertion = false;
    Vec3 point{};  ///< of the new vertex, which is number points.size() in `added`
    std::vector<int> removed;
    std::vector<Tet> added;
};

class ConeRefill {
  public:
    /// Stops looking for better once a plan is less flat than `target`. A new vertex that does not reach the target is
    /// worth its tets only where the worst is flatter than `urgent`. As a last resort new vertices are tried in more
    /// places.
    ConeRefill(CavityEditor& editor, double target, double urgent, bool is_last_resort = false)
        : editor_(editor), cavity_(editor), target_(target), urgent_(urgent), is_last_resort_(is_last_resort) {}

    /// The best plan, or nullptr where none brings the worst angle of its cavity up. Valid until the next call.
    const ConePlan* plan(int tet);

  private:
    void consider(double gain);
    void consider_insertion();
    void plan_from_corners(int tet);
    void plan_collapses(int tet);
    void plan_insertions(int tet);
    void plan_insertions_above(int tet);
    void plan_insertion(std::span<const int> start, const Vec3& point);

    CavityEditor& editor_;
    ConeCavity cavity_;
    ConePlan best_;
    double target_, urgent_;
    bool is_last_resort_;
    std::vector<int> star_, others_;
};

}  // namespace featuremesh
