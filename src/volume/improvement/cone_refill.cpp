// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "volume/improvement/cone_cavity.h"
#include "volume/improvement/operations.h"

namespace featuremesh {

namespace {

/// For an insertion the cavity is grown and the point moved this often in turn.
constexpr int insertion_rounds = 2;
/// Above a facet of the tet, in square roots of twice its area; a regular tet is 0.88 high.
constexpr std::array heights_of_insertion{0.5, 0.9};

class ConeRefill : public Operation {
  public:
    ConeRefill(const TetComplex& complex, const Objective& objective, const RefillOptions& options)
        : complex_(complex), objective_(objective), options_(options), cavity_(complex, objective) {}

    std::string_view name() const override { return "cone refill"; }
    bool is_dear() const override { return true; }

    std::unique_ptr<Operation> for_another_thread() const override {
        const bool may_run_out = options_.most_large_cavities > 0 && options_.most_large_cavities != any_number;
        return may_run_out ? nullptr : std::make_unique<ConeRefill>(complex_, objective_, options_);
    }

    bool plan(int tet, Change& change, Footprint& footprint) override {
        best_ = &change, footprint_ = &footprint;
        cavity_.note_in(footprint);
        const auto insert_at = [&](std::span<const int> start, const Vec3& point) { insert(start, point); };
        change.was_dear = true;
        change.after.worst = inverted_flatness;
        fill_from_corners(tet);
        if (is_wanting()) collapse(tet);
        if (is_wanting()) visit_starts(complex_, tet, footprint, insert_at);
        if (is_wanting() && options_.is_last_resort) insert_above(tet);
        if (change.after.worst > 1 && objective_.flaw(complex_, complex_.tets[tet]) > 1 &&
            options_.most_large_cavities > 0)
            insert_with_room(tet);
        return !change.removed.empty();
    }

  private:
    bool is_wanting() const { return best_->after.worst > objective_.target(); }

    void consider() {
        const Price price = cavity_.apex() < 0 ? price_of_new_vertex : Price{};
        const double wanted = Objective::improved(cavity_.worst_before(), price.angle);
        if (cavity_.worst_after() < std::min(best_->after.worst, wanted)) cavity_.describe_if_better(price, *best_);
    }

    void fill_from_corners(int tet) {
        for (int face = 0; face < 4; ++face) {
            const int corner = complex_.tets[tet][face];
            if (cavity_.grow(std::array{tet}, corner, complex_.points[corner])) consider();
            const int next = complex_.neighbours[tet][face];
            if (next < 0) continue;
            footprint_->add(next);
            const int apex = complex_.tets[next][face_towards(complex_.neighbours[next], tet)];
            if (cavity_.grow(std::array{tet, next}, apex, complex_.points[apex])) consider();
        }
    }

    void collapse(int tet) {
        for (const int v : complex_.tets[tet]) {
            if (!complex_.is_free(v)) continue;
            const bool is_whole = gather_star(complex_, v, star_);
            footprint_->add(star_);
            if (!is_whole) continue;
            gather_neighbours(complex_, v, star_, others_);
            for (const int apex : others_)
                if (cavity_.grow(star_, apex, complex_.points[apex])) consider();
        }
    }

    void insert_above(int tet) {
        const Tet& v = complex_.tets[tet];
        const auto& p = complex_.points;
        for (int face = 0; face < 4; ++face) {
            const auto& corner = opposite_face[face];
            const Vec3 &a = p[v[corner[0]]], &b = p[v[corner[1]]], &c = p[v[corner[2]]];
            const Vec3 middle = (a + b + c) / 3;
            Vec3 normal = cross(b - a, c - a);
            if (dot(normal, p[v[face]] - middle) < 0) normal = -1.0 * normal;
            const double reach = std::sqrt(length(normal));
            for (const double height : heights_of_insertion)
                insert(std::array{tet}, middle + (height / reach) * normal);
        }
    }

    void insert(std::span<const int> start, Vec3 point) {
        for (int round = 0; round < insertion_rounds && cavity_.grow(start, -1, point); ++round) {
            cavity_.climb(objective_.target());
            consider();
            point = cavity_.point();
        }
    }

    /// Where boundary nodes alone make a tet, as across a thin wall with a short edge at either wall.
    void insert_with_room(int tet) {
        if (options_.most_large_cavities != any_number) --options_.most_large_cavities;
        visit_starts(complex_, tet, *footprint_, [&](std::span<const int> start, const Vec3& point) {
            if (best_->after.worst > 1) cavity_.make_room(start, point, [&] { consider(); });
        });
    }

    const TetComplex& complex_;
    const Objective& objective_;
    RefillOptions options_;
    ConeCavity cavity_;
    Change* best_ = nullptr;
    Footprint* footprint_ = nullptr;
    std::vector<int> star_, others_;
};

}  // namespace

std::unique_ptr<Operation> cone_refill(LocalMesh& mesh, const Objective& objective, const RefillOptions& options) {
    return std::make_unique<ConeRefill>(mesh.complex(), objective, options);
}

}  // namespace featuremesh
