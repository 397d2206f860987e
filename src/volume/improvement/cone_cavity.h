// SPDX-License-Identifier: GPL-3.0-or-later
// A cavity that is filled from one point: vertex insertion, edge collapse, multi-face flips. Grown tet by tet as in
// Klingner and Shewchuk, "Aggressive tetrahedral mesh improvement", 2007.
#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"
#include "volume/improvement/local_mesh.h"
#include "volume/improvement/objective.h"
#include "volume/improvement/operation.h"
#include "volume/improvement/star_shape.h"
#include "volume/tets/cavity_editor.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_marks.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

/// Plans on the untouched complex. When every triangle of its outside sees the point from inside, the cones over them
/// fill the cavity exactly.
class ConeCavity {
  public:
    ConeCavity(const TetComplex& complex, const Objective& objective)
        : complex_(complex), objective_(objective), shape_(objective) {}

    /// Adds the tets that it looks at from now on to the footprint. They may have changed since the last call.
    void note_in(Footprint& footprint) { footprint_ = &footprint, last_start_.clear(); }

    /// Grows from `start` across the triangle with the worst cone, as long as that may help; keeps the best cavity met.
    /// `apex` is the vertex that `point` belongs to, -1 for a new one. False where no cavity was better than the tets
    /// it replaces.
    bool grow(std::span<const int> start, int apex, const Vec3& point);

    /// Takes these tets and no others, as they are now, to be filled from a new point that climbs from here.
    void open(std::span<const int> start, const Vec3& point) { last_start_.clear(), reset(start, -1, point); }

    /// For tets that are too thin: grows until a new point sees the whole outside, moves the point, and takes in the
    /// tets behind the thinnest cones, in turns; up to 240 tets. Calls `consider` for every cavity that may do.
    template <class Consider>
    void make_room(std::span<const int> start, const Vec3& point, const Consider& consider);

    /// Moves a new point to where the worst cone is the best.
    void climb(double good_enough);

    double worst_before() const { return worst_before_; }
    double worst_after() const { return worst_after_; }
    int apex() const { return apex_; }
    const Vec3& point() const { return point_; }
    std::span<const int> removed() const { return tets_; }
    /// The cones; `apex` stands for a new vertex.
    std::span<const Tet> cones(int apex);
    /// Makes the refill the change if it is worth its price.
    void describe_if_better(const Price& price, Change& change);

  private:
    struct Face {
        int tet, face;
        std::array<int, 3> vertices;
        double value;
        bool has(int v) const { return vertices[0] == v || vertices[1] == v || vertices[2] == v; }
    };
    void reset(std::span<const int> start, int apex, const Vec3& point);
    void add(int tet);
    void take_in(int tet);
    void add_face(int tet, int face);
    void remove_face(int tet, int face);
    /// The cones over the triangles that are new since the last call.
    void measure_new_cones();
    /// A star is grown from towards each of its neighbours in turn: known if it is the last one.
    double worst_of(std::span<const int> start);
    void gather_shape();
    Value value_of_cones();
    double cone_flaw(const std::array<int, 3>& face) const;
    int behind(const Face& f) const { return complex_.neighbours[f.tet][f.face]; }
    const Face* worst_face() const;
    /// A vertex that may not be taken out has all its tets in the cavity.
    bool loses_lasting_vertex() const;
    void rebuild(std::size_t count);
    bool make_visible();
    bool give_room();

    static constexpr double not_measured = -1;
    static constexpr std::size_t most_tets = 48, most_tets_with_room = 240;
    const TetComplex& complex_;
    const Objective& objective_;
    int apex_ = -1;
    Vec3 point_{};
    double worst_before_ = 0, worst_after_ = 0;
    TetMarks marks_;
    Footprint* footprint_ = nullptr;
    std::vector<int> tets_, order_, last_start_;
    double worst_of_last_ = 0;
    std::vector<Face> faces_;
    std::vector<Tet> cones_;
    StarShape shape_;
};

/// Calls try_at(tets, point) for the tet's middle and for those of its inner edges: where a new vertex may help.
template <class TryAt>
void visit_starts(const TetComplex& complex, int tet, Footprint& footprint, const TryAt& try_at) {
    const auto& [a, b, c, d] = complex.tets[tet];
    const auto& p = complex.points;
    try_at(std::array{tet}, (p[a] + p[b] + p[c] + p[d]) / 4);
    visit_rings(complex, tet, footprint,
                [&](const EdgeRing& ring) { try_at(ring.all_tets(), (p[ring.from] + p[ring.to]) / 2); });
}

template <class Consider>
void ConeCavity::make_room(std::span<const int> start, const Vec3& point, const Consider& consider) {
    constexpr int rounds = 10;
    worst_after_ = inverted_flatness;
    open(start, point);
    for (int round = 0; round < rounds && worst_after_ > 1; ++round) {
        if (!make_visible()) return;
        if (!loses_lasting_vertex()) {
            climb(1);
            consider();
        }
        if (!give_room()) return;
    }
}

}  // namespace featuremesh
