// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/curved/straight_sides.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/geometry.h"
#include "mesh/second_order.h"
#include "volume/curved/low_tets.h"

namespace featuremesh {
namespace {

/// Scaled: an element with less is all but folded.
constexpr double least_jacobian = 0.05;

class Straightening {
  public:
    explicit Straightening(Mesh& mesh) : mesh_(mesh) {}

    /// Whether a side of one of them was bent.
    bool run(const FoldedElements& folded) {
        bool has_changed = false;
        for (const TetId t : folded.tets)
            for (std::size_t s = 0; s < 6; ++s) has_changed |= take_bend_of_tet(t.index(), s);
        for (const TriangleId t : folded.triangles)
            for (std::size_t s = 0; s < 3; ++s) has_changed |= take_bend_of_triangle(t.index(), s);
        return has_changed;
    }

    void describe(StraightSides& result) const {
        result.sides = sides_;
        result.distance = distance_;
        result.places.assign(places_.begin(), places_.end());
    }

  private:
    bool take_bend_of_tet(std::size_t tet, std::size_t side) {
        const auto [a, b] = tet_sides[side];
        return take_bend(mesh_.tets[tet][std::size_t(a)], mesh_.tets[tet][std::size_t(b)], mesh_.tet_mids[tet][side]);
    }
    bool take_bend_of_triangle(std::size_t triangle, std::size_t side) {
        const auto& corners = mesh_.triangles[triangle];
        return take_bend(corners[side], corners[(side + 1) % 3], mesh_.triangle_mids[triangle][side]);
    }
    bool take_bend(NodeId a, NodeId b, NodeId mid) {
        const Vec3 middle = 0.5 * (mesh_.point(a) + mesh_.point(b));
        const double off = distance(mesh_.point(mid), middle);
        if (off == 0) return false;
        mesh_.points[mid.index()] = middle;
        note(mesh_.entities[mid.index()], off, distance(mesh_.point(a), mesh_.point(b)));
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
    std::size_t sides_ = 0;
    double distance_ = 0;
    std::set<Entity> places_;
};

}  // namespace

std::vector<TriangleId> shell_triangles_below(const Brep& brep, const Mesh& mesh, std::size_t first, double limit) {
    std::vector<TriangleId> found;
    if (!brep.has_free_faces()) return found;
    for (std::size_t t = first; t < mesh.triangles.size(); ++t)
        if (brep.is_free(mesh.triangle_faces[t]) && min_scaled_jacobian(triangle_nodes(mesh, TriangleId(t))) < limit)
            found.emplace_back(t);
    return found;
}

StraightSides straighten(const Brep& brep, Mesh mesh, FoldedElements folded, RunContext& context) {
    StraightSides result;
    Straightening straightening(mesh);
    while (!folded.tets.empty() || !folded.triangles.empty()) {
        context.check_cancelled();
        if (!straightening.run(folded)) return {};
        folded = {tets_at_most(mesh, least_jacobian, context), shell_triangles_below(brep, mesh, 0, least_jacobian)};
    }
    straightening.describe(result);
    result.mesh = std::move(mesh);
    return result;
}

}  // namespace featuremesh
