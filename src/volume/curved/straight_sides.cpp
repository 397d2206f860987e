// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/curved/straight_sides.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/geometry.h"
#include "mesh/second_order.h"
#include "volume/curved/curved_tet_repair.h"

namespace featuremesh {
namespace {

/// Scaled: a tet with less is all but folded.
constexpr double least_jacobian = 0.05;

class Straightening {
  public:
    Straightening(Mesh& mesh, const std::vector<bool>& is_movable) : mesh_(mesh), is_movable_(is_movable) {}

    /// Whether a side of one of them was bent.
    bool run(const std::vector<TetId>& tets) {
        bool has_changed = false;
        for (const TetId t : tets)
            for (std::size_t s = 0; s < 6; ++s) has_changed |= take_bend(t, s);
        return has_changed;
    }

    void describe(StraightSides& result) const {
        result.sides = sides_;
        result.distance = distance_;
        result.places.assign(places_.begin(), places_.end());
    }

  private:
    bool take_bend(TetId tet, std::size_t side) {
        const NodeId mid = mesh_.tet_mids[tet.index()][side];
        const auto& corners = mesh_.tets[tet.index()];
        const auto [a, b] = tet_sides[side];
        const Vec3 middle = 0.5 * (mesh_.point(corners[a]) + mesh_.point(corners[b]));
        const double off = distance(mesh_.point(mid), middle);
        if (off == 0 || !is_movable_[mid.index()]) return false;
        mesh_.points[mid.index()] = middle;
        note(mesh_.entities[mid.index()], off, distance(mesh_.point(corners[a]), mesh_.point(corners[b])));
        return true;
    }

    /// Sides that are straight but for rounding have lost nothing.
    void note(const Entity& on, double off, double length) {
        constexpr double rounding = 1e-9;
        if (on.dim == 3 || off < rounding * length) return;
        ++sides_;
        distance_ = std::max(distance_, off);
        places_.insert(on);
    }

    Mesh& mesh_;
    const std::vector<bool>& is_movable_;
    std::size_t sides_ = 0;
    double distance_ = 0;
    std::set<Entity> places_;
};

}  // namespace

StraightSides straighten(Mesh mesh, std::vector<TetId> folded, const std::vector<bool>& is_movable,
                         RunContext& context) {
    StraightSides result;
    Straightening straightening(mesh, is_movable);
    while (!folded.empty()) {
        context.check_cancelled();
        if (!straightening.run(folded)) return {};
        folded = tets_at_most(mesh, least_jacobian, context);
    }
    straightening.describe(result);
    result.mesh = std::move(mesh);
    return result;
}

}  // namespace featuremesh
