// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/crowded_points.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "volume/cavity_editor.h"
#include "volume/edge_removal.h"
#include "volume/needles.h"
#include "volume/tet_measures.h"

namespace featuremesh {

namespace {

constexpr int most_sweeps = 10;

class CrowdRemover {
  public:
    CrowdRemover(TetComplex& complex, const WantedSize& size, double target_dihedral_deg)
        : complex_(complex), size_(size), target_(flatness_to_reach(target_dihedral_deg)), editor_(complex) {}

    std::size_t run(std::span<const int> vertices, const RunContext& context) {
        std::size_t count = 0;
        RoundWatch watch(context);
        for (int sweep = 0; sweep < most_sweeps; ++sweep) {
            const std::size_t before = count;
            for (const int v : vertices) {
                watch();
                count += collapse(v);
            }
            if (count == before) break;
        }
        return count;
    }

  private:
    bool collapse(int v) {
        if (complex_.is_fixed[v] != 0 || !gather_star(complex_, v, star_)) return false;
        gather_neighbours(complex_, v, star_, neighbours_);
        if (!is_crowded(v) || is_beside_needle()) return false;
        tets_.clear();
        for (const int t : star_) tets_.push_back(complex_.tets[t]);
        const double before = worst_flatness(complex_, star_), smallest_before = smallest_volume(tets_),
                     burden_before = burden_of(complex_, tets_, target_);
        double best = inverted_flatness;
        for (const int onto : neighbours_) {
            const double worst = plan_collapse(v, onto, best);
            if (worst >= best || worst > before || smallest_volume(tets_) < smallest_before ||
                burden_of(complex_, tets_, target_) > burden_before)
                continue;
            best = worst;
            best_tets_.swap(tets_);
        }
        if (best == inverted_flatness) return false;
        editor_.replace(star_, best_tets_);
        return true;
    }

    double smallest_volume(std::span<const Tet> tets) const {
        double smallest = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c, d] : tets)
            smallest = std::min(smallest, signed_volume(complex_.points[a], complex_.points[b], complex_.points[c],
                                                        complex_.points[d]));
        return smallest;
    }

    bool is_crowded(int v) const {
        const Vec3& p = complex_.points[v];
        const double least = SeedOptions{}.spacing * size_.at(p);
        return std::any_of(neighbours_.begin(), neighbours_.end(),
                           [&](int other) { return distance(p, complex_.points[other]) < least; });
    }

    /// Where volume is scarce, who is in the way of angles may be what makes room for it.
    bool is_beside_needle() const {
        return std::any_of(star_.begin(), star_.end(), [&](int t) { return is_excused(complex_, complex_.tets[t]); });
    }

    /// Puts into tets_ what is left of the star with v at `onto`. Flatness of the worst of them; as soon as that is
    /// `limit` or more, some are left out.
    double plan_collapse(int v, int onto, double limit) {
        tets_.clear();
        double worst = 0;
        const auto& p = complex_.points;
        for (const int t : star_) {
            Tet tet = complex_.tets[t];
            if (std::find(tet.begin(), tet.end(), onto) != tet.end()) continue;
            std::replace(tet.begin(), tet.end(), v, onto);
            worst = std::max(worst, flatness(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]));
            if (worst >= limit) break;
            tets_.push_back(tet);
        }
        return worst;
    }

    TetComplex& complex_;
    const WantedSize& size_;
    double target_;
    CavityEditor editor_;
    std::vector<int> star_, neighbours_;
    std::vector<Tet> tets_, best_tets_;
};

}  // namespace

std::size_t remove_crowded(TetComplex& complex, std::span<const int> vertices, const WantedSize& size,
                           double target_dihedral_deg, const RunContext& context) {
    return CrowdRemover(complex, size, target_dihedral_deg).run(vertices, context);
}

}  // namespace featuremesh
