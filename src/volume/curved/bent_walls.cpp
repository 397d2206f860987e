// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/curved/bent_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry.h"
#include "mesh/second_order.h"

namespace featuremesh {

namespace {

/// The opposite side of each side of a tet, both as indices of tet_sides.
constexpr std::array<int, 6> opposite_side{5, 3, 4, 1, 2, 0};
/// A side whose bend is a smaller share of its length is ignored.
constexpr double least_bend = 0.005;
/// Ratios of the wall's thickness to the bend. From the wanted one on the nodes have room; below the hopeless one no
/// moving of nodes makes room.
constexpr double hopeless_thickness = 1.0, wanted_thickness = 4.0;
/// The shortest length asked for in one round, as a share of the present one; the next mesh shows whether it suffices.
constexpr double shortest_share = 0.05;
constexpr int samples = 8;

bool holds(const std::vector<FaceId>& faces, FaceId face) {
    return std::find(faces.begin(), faces.end(), face) != faces.end();
}

class Finder {
  public:
    Finder(const Brep& brep, const Projector& projector, const Mesh& mesh)
        : brep_(brep), projector_(projector), mesh_(mesh), neighbours_(brep.face_count()) {
        for (std::size_t f = 0; f < brep.face_count(); ++f)
            for (const EdgeId edge : brep.edges_of(FaceId(f)))
                for (const FaceId other : brep.faces_of(edge)) neighbours_[f].push_back(other);
    }

    void look_at(TetId tet) {
        const auto nodes = tet_nodes(mesh_, tet);
        for (int side = 0; side < 6; ++side) {
            const auto [a, b] = tet_sides[side];
            const Vec3 bend = nodes[4 + side] - 0.5 * (nodes[a] + nodes[b]);
            if (length(bend) < least_bend * distance(nodes[a], nodes[b])) continue;
            const auto [c, d] = tet_sides[opposite_side[side]];
            if (thickness_over_bend(nodes[a], nodes[b], nodes[c], nodes[d], bend) > hopeless_thickness + 1) continue;
            for (const FaceId other : walls_opposite(tet, side)) ask(nodes[a], nodes[b], bend, other, tet);
        }
    }

    BentWalls found;

  private:
    /// The height of the tet over the bent side, as a multiple of the bend; infinite where the side bends away from the
    /// tet.
    static double thickness_over_bend(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& bend) {
        const double before = dot(cross(b - a, c - a), d - a);
        const double after = dot(cross(b - a, c - a - bend), d - a - bend);
        const double lost = (before - after) / before;
        return lost > 0 ? 1 / lost : std::numeric_limits<double>::infinity();
    }

    /// Faces at the nodes across from the side that have no edge in common with those on which the side lies.
    std::vector<FaceId> walls_opposite(TetId tet, int side) const {
        const Entity mid = mesh_.entities[mesh_.tet_mids[tet.index()][side].index()];
        if (mid.dim == 3) return {};
        const std::vector<FaceId> own = brep_.faces_at(mid);
        std::vector<FaceId> walls;
        for (const int corner : tet_sides[opposite_side[side]]) {
            const Entity entity = mesh_.entities[mesh_.tets[tet.index()][corner].index()];
            if (entity.dim == 3) continue;
            for (const FaceId face : brep_.faces_at(entity))
                if (!holds(walls, face) && !is_beside(face, own)) walls.push_back(face);
        }
        return walls;
    }
    bool is_beside(FaceId face, const std::vector<FaceId>& faces) const {
        return holds(faces, face) || std::any_of(faces.begin(), faces.end(),
                                                 [&](FaceId own) { return holds(neighbours_[own.index()], face); });
    }

    /// By how much the side bends more than the other wall does along it.
    double relative_bend(const Vec3& a, const Vec3& b, const Vec3& bend, FaceId other) const {
        const auto across = [&](const Vec3& p) { return projector_.nearest(other, p).point; };
        const Vec3 of_other = across(0.5 * (a + b)) - 0.5 * (across(a) + across(b));
        return length(bend) - dot(of_other, bend) / length(bend);
    }

    /// Along the side, by its bend in the middle.
    void ask(const Vec3& a, const Vec3& b, const Vec3& bend, FaceId other, TetId tet) {
        const double side = distance(a, b), height = length(bend), relative = relative_bend(a, b, bend, other);
        if (relative < 0.5 * height) return;
        std::vector<SizeSource> lengths;
        double thinnest = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= samples; ++i) {
            const double share = double(i) / samples;
            const Vec3 p = a + share * (b - a);
            const OnFace across = projector_.nearest(other, p);
            if (!is_faced(other, across, bend / height)) continue;
            const double thickness = std::max(0.0, across.distance - 4 * share * (1 - share) * height);
            thinnest = std::min(thinnest, thickness);
            const double wanted = std::sqrt(thickness / (wanted_thickness * relative));
            if (wanted < 0.5) lengths.push_back({p, std::max(wanted, shortest_share) * side});
        }
        if (thinnest > hopeless_thickness * relative) return;
        if (found.lengths.empty()) found.place = tet;
        found.lengths.insert(found.lengths.end(), lengths.begin(), lengths.end());
    }

    bool is_faced(FaceId wall, const OnFace& at, const Vec3& direction) const {
        constexpr double opposite_cosine = 0.7;
        return std::abs(dot(projector_.normal(wall, at.uv), direction)) > opposite_cosine &&
               projector_.is_inside_trim(wall, at.uv);
    }

    const Brep& brep_;
    const Projector& projector_;
    const Mesh& mesh_;
    std::vector<std::vector<FaceId>> neighbours_;  // by face
};

}  // namespace

BentWalls find_bent_walls(const Brep& brep, const Projector& projector, const Mesh& mesh, std::size_t first_tet,
                          const RunContext& context) {
    Finder finder(brep, projector, mesh);
    RoundWatch watch(context);
    for (std::size_t t = first_tet; t < mesh.tets.size(); ++t) {
        watch();
        finder.look_at(TetId(t));
    }
    return std::move(finder.found);
}

}  // namespace featuremesh
