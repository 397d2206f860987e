// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/needle_neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "volume/cavity_editor.h"
#include "volume/cone_refill.h"
#include "volume/edge_removal.h"
#include "volume/needles.h"
#include "volume/tet_measures.h"
#include "volume/tet_topology.h"
#include "volume/thicken.h"
#include "volume/vertex_move.h"

namespace featuremesh {

namespace {

constexpr int most_passes = 12;

class NeedleNeighbours {
  public:
    NeedleNeighbours(TetComplex& complex, double target_deg, double least_volume, RunContext& context)
        : complex_(complex),
          context_(context),
          target_(flatness_to_reach(target_deg)),
          least_volume_(least_volume),
          editor_(complex),
          refill_(editor_, target_, flatness_of_angle(target_deg)) {}

    std::size_t improve(std::vector<int> mended) {
        changed_ = std::move(mended);
        note_changed(tets_beside_needles());
        std::size_t done = 0;
        for (int pass = 0; pass < most_passes && !changed_.empty(); ++pass) {
            const std::size_t before = done;
            const std::vector<Candidate> ranked = rank_changed();
            for (std::size_t i = 0; i < ranked.size(); ++i) {
                if (i % 64 == 0)
                    context_.progress((pass + static_cast<double>(i) / static_cast<double>(ranked.size())) /
                                      most_passes);
                const auto [value, tet] = ranked[i];
                if (complex_.tets[tet][0] < 0 || measure(complex_.tets[tet]) != value) continue;
                done += remove_edge(tet) || move_corners(tet) || refill(tet);
            }
            if (done == before) break;
        }
        return done;
    }

  private:
    struct Candidate {
        double flatness;
        int tet;
    };

    std::array<Vec3, 4> corners_of(const Tet& tet) const {
        const auto& p = complex_.points;
        return {p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]};
    }
    std::array<bool, 4> boundary_corners_of(const Tet& tet) const {
        const auto& fixed = complex_.is_fixed;
        return {fixed[tet[0]] == 1, fixed[tet[1]] == 1, fixed[tet[2]] == 1, fixed[tet[3]] == 1};
    }
    bool is_needle(const Tet& tet) const {
        const std::array<bool, 4> is_on_boundary = boundary_corners_of(tet);
        return std::count(is_on_boundary.begin(), is_on_boundary.end(), true) > 1 &&
               needle_side(corners_of(tet), is_on_boundary) >= 0;
    }

    /// More than 1 for a tet that is too thin: worse than any angle.
    double measure(const Tet& tet) const {
        const double thick = thickness(complex_, tet, least_volume_);
        if (thick < 1) return inverted_flatness - std::max(0.0, thick);
        return unforced_flatness(complex_, tet);
    }

    /// Two layers round the needles.
    std::vector<int> tets_beside_needles() const {
        std::vector<char> is_near(complex_.points.size(), 0);
        bool is_any = false;
        for (const Tet& tet : complex_.tets)
            if (tet[0] >= 0 && is_needle(tet))
                for (const int v : tet) is_near[v] = 1, is_any = true;
        std::vector<int> near;
        if (!is_any) return near;
        for (int layer = 0; layer < 2; ++layer) {
            near.clear();
            for (std::size_t t = 0; t < complex_.tets.size(); ++t) {
                const Tet& tet = complex_.tets[t];
                if (tet[0] >= 0 && std::any_of(tet.begin(), tet.end(), [&](int v) { return is_near[v] != 0; }))
                    near.push_back(static_cast<int>(t));
            }
            for (const int t : near)
                for (const int v : complex_.tets[t]) is_near[v] = 1;
        }
        return near;
    }

    /// The changed tets that miss the target, worst first.
    std::vector<Candidate> rank_changed() {
        std::sort(changed_.begin(), changed_.end());
        changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
        std::vector<Candidate> ranked;
        for (const int tet : changed_)
            if (complex_.tets[tet][0] >= 0)
                if (const double value = measure(complex_.tets[tet]); value > target_) ranked.push_back({value, tet});
        std::sort(ranked.begin(), ranked.end(), [](const Candidate& a, const Candidate& b) {
            return a.flatness != b.flatness ? a.flatness > b.flatness : a.tet < b.tet;
        });
        changed_.clear();
        return ranked;
    }

    struct Worth {
        double worst = 0, burden = 0;
    };
    Worth worth_of(std::span<const Tet> tets) const {
        Worth worth;
        for (const Tet& tet : tets) {
            const double value = measure(tet);
            worth.worst = std::max(worth.worst, value);
            worth.burden += burden(value, target_);
        }
        return worth;
    }
    Worth worth_of(std::span<const int> tets) const {
        std::vector<Tet> corners;
        for (const int t : tets) corners.push_back(complex_.tets[t]);
        return worth_of(corners);
    }

    bool remove_edge(int tet) {
        EdgeRing ring, best_ring;
        RingTriangulation<> best;
        for (const auto& [from, to] : edge_corners) {
            if (!find_ring(complex_, tet, from, to, ring)) continue;
            const double limit = std::min(improved_flatness(worth_of(ring.all_tets()).worst, least_gain), best.cost);
            const RingTriangulation found = triangulate_ring<WorstOf>(ring.size, limit, [&](int i, int j, int k) {
                const int a = ring.vertices[i], b = ring.vertices[j], c = ring.vertices[k];
                return std::max(measure({a, b, c, ring.to}), measure({b, a, c, ring.from}));
            });
            if (std::isinf(found.cost)) continue;
            best = found;
            best_ring = ring;
        }
        if (std::isinf(best.cost)) return false;
        std::array<Tet, 2 * EdgeRing::max_size> added;
        const int count = tets_of_triangulation(best_ring, best, added);
        const std::span<const Tet> fresh{added.data(), static_cast<std::size_t>(count)};
        if (worth_of(fresh).burden >= worth_of(best_ring.all_tets()).burden) return false;
        note_changed(editor_.replace(best_ring.all_tets(), fresh));
        return true;
    }

    bool move_corners(int tet) {
        const Tet corners = complex_.tets[tet];
        bool gained = false;
        for (const int v : corners) gained |= complex_.is_fixed[v] != 1 && move(v);
        return gained;
    }

    /// Climbs by the angles, and asks the thickness afterwards: with part of the way a tet may still be thick enough.
    bool move(int vertex) {
        if (!gather_star(complex_, vertex, star_)) return false;
        const Worth before = worth_of(star_);
        if (before.worst <= target_) return false;
        const Vec3 old = complex_.points[vertex];
        Vec3 place = old;
        shape_.gather(complex_, star_, vertex);
        shape_.climb(place, target_);
        for (const double share : {1.0, 0.5, 0.25}) {
            complex_.points[vertex] = old + share * (place - old);
            const Worth after = worth_of(star_);
            if (after.worst < improved_flatness(before.worst, least_gain) && after.burden < before.burden) {
                note_changed(star_);
                return true;
            }
        }
        complex_.points[vertex] = old;
        return false;
    }

    /// Collapses and flips of several faces, of the worst tets: where vertices lie on one another there is no room to
    /// move.
    bool refill(int tet) {
        constexpr double urgent_deg = 5;
        if (measure(complex_.tets[tet]) < flatness_of_angle(urgent_deg)) return false;
        const ConePlan* plan = refill_.plan(tet);
        if (!plan || plan->is_insertion) return false;
        const Worth before = worth_of(plan->removed), after = worth_of(plan->added);
        if (after.worst >= improved_flatness(before.worst, least_gain) || after.burden >= before.burden) return false;
        note_changed(editor_.replace(plan->removed, plan->added));
        return true;
    }

    void note_changed(std::span<const int> tets) { changed_.insert(changed_.end(), tets.begin(), tets.end()); }

    TetComplex& complex_;
    RunContext& context_;
    double target_, least_volume_;
    CavityEditor editor_;
    ConeRefill refill_;
    StarShape shape_;
    std::vector<int> changed_, star_;
};

}  // namespace

std::size_t improve_beside_needles(TetComplex& complex, std::vector<int> mended, double target_dihedral_deg,
                                   double least_volume, RunContext& context) {
    complex.excuses_needles = true;
    return NeedleNeighbours(complex, target_dihedral_deg, least_volume, context).improve(std::move(mended));
}

}  // namespace featuremesh
