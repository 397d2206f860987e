// SPDX-License-Identifier: GPL-3.0-or-later
// A cavity that is filled from one point: vertex insertion, edge collapse, multi-face flips. Grown tet by tet as in
// Klingner and Shewchuk, "Aggressive tetrahedral mesh improvement", 2007.
#pragma once

#include <span>
#include <vector>

#include "volume/cavity_editor.h"
#include "volume/vertex_move.h"

namespace featuremesh {

/// Plans on the untouched complex. When every triangle of its outside sees the point from inside, the cones over them
/// fill the cavity exactly.
class ConeCavity {
  public:
    explicit ConeCavity(CavityEditor& editor) : editor_(editor) {}

    /// Grows from `start` across the triangle with the worst cone, as long as that may help; keeps the best cavity met.
    /// `apex` is the vertex that `point` belongs to, -1 for a new one. False where no cavity was better than the tets
    /// it replaces.
    bool grow(std::span<const int> start, int apex, const Vec3& point);

    /// Moves a new point to where the worst cone is the least flat.
    void climb(double good_enough);

    double worst_before() const { return worst_before_; }
    double worst_after() const { return worst_after_; }
    int apex() const { return apex_; }
    /// Sums of the burdens of the tets that go and of the cones.
    double burden_before(double target) const;
    double burden_after(double target) const;
    const Vec3& point() const { return point_; }
    std::span<const int> removed() const { return tets_; }
    /// The cones; `apex` stands for a new vertex.
    std::span<const Tet> cones(int apex);

  private:
    struct Face {
        int tet, face;
        std::array<int, 3> vertices;
        double value;
    };
    void reset(std::span<const int> start);
    void add(int tet);
    void add_face(int tet, int face);
    std::array<bool, 3> are_outside(const std::array<int, 3>& corners) const;
    double cone_flatness(const std::array<int, 3>& face) const;
    void remove_face(int tet, int face);
    const Face* worst_face() const;
    bool loses_fixed_vertex() const;
    void rebuild(std::size_t count);

    CavityEditor& editor_;
    int apex_ = -1;
    Vec3 point_{};
    double worst_before_ = 0, worst_after_ = 0;
    std::vector<int> tets_, order_;
    std::vector<Face> faces_;
    std::vector<Tet> cones_;
    StarShape shape_;
};

}  // namespace featuremesh
