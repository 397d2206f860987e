// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/wall_tets.h"

#include <algorithm>
#include <cmath>

#include "volume/cavity_editor.h"
#include "volume/optimise.h"
#include "volume/tet_measures.h"
#include "volume/vertex_move.h"

namespace featuremesh {

namespace {

/// As for the walls that `elements_across_gap` is about.
constexpr double opposite_cosine = 0.7;
constexpr int mending_rounds = 2;

std::vector<int> tets_with_vertices_from(const TetComplex& complex, int first) {
    std::vector<int> tets;
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
        if (*std::max_element(complex.tets[t].begin(), complex.tets[t].end()) >= first)
            tets.push_back(static_cast<int>(t));
    return tets;
}

bool holds(const std::vector<FaceId>& faces, FaceId face) {
    return std::find(faces.begin(), faces.end(), face) != faces.end();
}

/// A new vertex, and the tets that it takes the place of.
struct Insertion {
    double flatness = 2 * inverted_flatness;
    Vec3 point{};
    std::vector<int> removed;
    std::vector<Tet> added;
};

class TetSplitter {
  public:
    explicit TetSplitter(TetComplex& complex) : complex_(complex), editor_(complex) {}

    void split(int tet) {
        best_ = {};
        const Tet& v = complex_.tets[tet];
        const auto& p = complex_.points;
        consider(std::array{tet}, {0, 1, 2, 3}, (p[v[0]] + p[v[1]] + p[v[2]] + p[v[3]]) / 4, v);
        for (const auto& [from, to] : edge_corners) {
            EdgeRing ring;
            if (find_ring(complex_, tet, from, to, ring))
                consider(ring.all_tets(), {from, to}, (p[ring.from] + p[ring.to]) / 2, v);
        }
        complex_.is_fixed[static_cast<std::size_t>(editor_.add_vertex(best_.point))] = 2;
        editor_.replace(best_.removed, best_.added);
    }

  private:
    /// All tets of `star` have the corners `shared` of the tet `v`; in each of them the new vertex takes their places
    /// in turn.
    void consider(std::span<const int> star, std::vector<int> shared, Vec3 point, const Tet& v) {
        const auto& p = complex_.points;
        const int fresh = static_cast<int>(p.size());
        StarShape shape;
        std::vector<Tet> added;
        for (const int t : star)
            for (const int corner : shared) {
                Tet tet = complex_.tets[t];
                const int gone = corner_of(tet, v[corner]);
                const auto& side = opposite_face[gone];
                shape.add(p[tet[side[0]]], p[tet[side[1]]], p[tet[side[2]]]);
                tet[gone] = fresh;
                added.push_back(tet);
            }
        const double flatness = shape.climb(point, 0);
        if (flatness >= best_.flatness) return;
        best_ = {flatness, point, {star.begin(), star.end()}, std::move(added)};
    }

    TetComplex& complex_;
    CavityEditor editor_;
    Insertion best_;
};

}  // namespace

OppositeWalls::OppositeWalls(const Brep& brep, const Mesh& mesh, const Projector& projector)
    : brep_(brep), mesh_(mesh), projector_(projector), neighbours_(brep.face_count()) {
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        for (const EdgeId edge : brep.edges_of(FaceId(f)))
            for (const FaceId other : brep.faces_of(edge)) neighbours_[f].push_back(other);
}

bool OppositeWalls::are_spanned_by(const std::array<NodeId, 4>& nodes) const {
    std::array<std::vector<FaceId>, 4> faces;
    for (int k = 0; k < 4; ++k) {
        if (!nodes[k].is_valid() || mesh_.entities[nodes[k].index()].dim == 3) return false;
        faces[k] = brep_.faces_at(mesh_.entities[nodes[k].index()]);
    }
    const auto first_off = [&](FaceId face) {
        int k = 0;
        while (k < 4 && holds(faces[k], face)) ++k;
        return k;
    };
    for (const FaceId a : faces[0]) {
        const int off_a = first_off(a);
        if (off_a == 4) continue;
        for (const FaceId b : faces[off_a]) {
            const int off_b = first_off(b);
            const bool covers =
                std::all_of(faces.begin(), faces.end(), [&](const auto& at) { return holds(at, a) || holds(at, b); });
            if (off_b < 4 && covers && are_opposite(a, nodes[off_b], b, nodes[off_a])) return true;
        }
    }
    return false;
}

bool OppositeWalls::are_opposite(FaceId a, NodeId on_a, FaceId b, NodeId on_b) const {
    return !holds(neighbours_[a.index()], b) && std::abs(dot(normal(a, on_a), normal(b, on_b))) > opposite_cosine;
}

Vec3 OppositeWalls::normal(FaceId face, NodeId node) const {
    return projector_.normal(face, projector_.nearest(face, mesh_.point(node)).uv);
}

std::size_t split_tets(TetComplex& complex, const std::function<bool(const std::array<int, 4>&)>& is_wanted) {
    TetSplitter splitter(complex);
    std::size_t count = 0;
    for (std::size_t t = 0; t < complex.tets.size(); ++t) {
        if (complex.tets[t][0] < 0 || !is_wanted(complex.tets[t])) continue;
        splitter.split(static_cast<int>(t));
        ++count;
    }
    return count;
}

std::size_t split_wall_tets(SeamRegion& region, const OppositeWalls& walls, double target_dihedral_deg,
                            RunContext& context) {
    const auto is_spanning = [&](const std::array<int, 4>& tet) {
        return walls.are_spanned_by(
            {region.node_of(tet[0]), region.node_of(tet[1]), region.node_of(tet[2]), region.node_of(tet[3])});
    };
    const int first_new = static_cast<int>(region.complex.points.size());
    std::size_t count = 0;
    // mending what was split may make others, so the last word is a split
    for (int round = 0; round <= mending_rounds; ++round) {
        const std::size_t split = split_tets(region.complex, is_spanning);
        count += split;
        if (split == 0 || round == mending_rounds) break;
        SliverOptions options;
        options.target_dihedral_deg = target_dihedral_deg;
        options.among = tets_with_vertices_from(region.complex, first_new);
        remove_slivers(region.complex, options, context);
    }
    return count;
}

}  // namespace featuremesh
