// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/operations.h"
#include "volume/improvement/star_shape.h"

namespace featuremesh {

namespace {

class TetSplit : public Operation {
  public:
    TetSplit(const TetComplex& complex, const Objective& objective) : complex_(complex), objective_(objective) {}

    std::string_view name() const override { return "split"; }
    bool moves_boundary() const override { return true; }  // so that a tet with a forced angle is looked at, too

    std::unique_ptr<Operation> for_another_thread() const override {
        return std::make_unique<TetSplit>(complex_, objective_);
    }

    bool plan(int tet, Change& change, Footprint& footprint) override {
        footprint.add(tet);
        if (!objective_.is_barred(complex_.tets[tet])) return false;
        const Tet& v = complex_.tets[tet];
        const auto& p = complex_.points;
        change.mobility = Mobility::kept;
        change.after.worst = inverted_flatness;
        consider(std::array{tet}, {0, 1, 2, 3}, (p[v[0]] + p[v[1]] + p[v[2]] + p[v[3]]) / 4, v, change);
        for (const auto& [from, to] : edge_corners) {
            EdgeRing ring;
            const bool is_inside = find_ring(complex_, tet, from, to, ring);
            footprint.add(ring.all_tets());
            if (is_inside) consider(ring.all_tets(), {from, to}, (p[ring.from] + p[ring.to]) / 2, v, change);
        }
        return !change.removed.empty();
    }

  private:
    /// All tets of `star` have the corners `shared` of the tet `v`; in each of them the new vertex takes their places
    /// in turn.
    void consider(std::span<const int> star, const std::vector<int>& shared, Vec3 point, const Tet& v,
                  Change& change) const {
        const auto& p = complex_.points;
        StarShape shape(objective_);
        std::vector<Tet> added;
        for (const int t : star)
            for (const int corner : shared) {
                Tet tet = complex_.tets[t];
                const int gone = corner_of(tet, v[corner]);
                const auto& face = opposite_face[gone];
                shape.add(p[tet[face[0]]], p[tet[face[1]]], p[tet[face[2]]]);
                tet[gone] = static_cast<int>(p.size());
                added.push_back(tet);
            }
        if (shape.climb(point, 0) >= change.after.worst) return;
        const Value before = objective_.value(complex_, star), after = shape.value(point);
        if (!objective_.is_better(before, after, {})) return;
        change.before = before, change.after = after;
        change.points = {point};
        change.removed.assign(star.begin(), star.end());
        change.added = std::move(added);
    }

    const TetComplex& complex_;
    const Objective& objective_;
};

}  // namespace

std::unique_ptr<Operation> tet_split(LocalMesh& mesh, const Objective& objective) {
    return std::make_unique<TetSplit>(mesh.complex(), objective);
}

}  // namespace featuremesh
