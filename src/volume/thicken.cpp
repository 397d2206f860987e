// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/thicken.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "volume/cavity_editor.h"
#include "volume/edge_removal.h"
#include "volume/tet_topology.h"

namespace featuremesh {

namespace {

/// Of six volumes against the product of three edges: some way above what the validation of a mesh refuses.
constexpr double least_share = 3e-6;
/// A step has to gain this factor, else passes would go on for nothing.
constexpr double least_gain = 1.05;
constexpr int most_passes = 12;

std::vector<int> thin_tets(const TetComplex& complex, double least_volume) {
    std::vector<int> thin;
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
        if (complex.tets[t][0] >= 0 && thickness(complex, complex.tets[t], least_volume) < 1)
            thin.push_back(static_cast<int>(t));
    return thin;
}

class Thickener {
  public:
    Thickener(TetComplex& complex, double least_volume, RunContext& context)
        : complex_(complex), least_volume_(least_volume), context_(context), editor_(complex) {}

    std::vector<int> run(std::vector<int> thin) {
        for (int pass = 0; pass < most_passes && !thin.empty(); ++pass) {
            bool gained = false;
            for (const int tet : thin) {
                context_.progress(static_cast<double>(pass) / most_passes);
                if (complex_.tets[tet][0] < 0 || thickness_of(complex_.tets[tet]) >= 1) continue;
                gained = (remove_edge(tet) || collapse(tet) || move(tet)) || gained;
            }
            thin = thin_tets(complex_, least_volume_);
            if (!gained) break;
        }
        return thin;
    }

  private:
    double thickness_of(const Tet& tet) const { return thickness(complex_, tet, least_volume_); }
    double thinnest(std::span<const int> tets) const {
        double least = 1;
        for (const int t : tets) least = std::min(least, thickness_of(complex_.tets[t]));
        return least;
    }
    static bool is_gain(double before, double after) { return after > 0 && after > std::max(0.0, before) * least_gain; }

    bool remove_edge(int tet) {
        EdgeRing ring;
        for (const auto& [from, to] : edge_corners) {
            if (!find_ring(complex_, tet, from, to, ring)) continue;
            const double before = std::max(1e-12, thinnest(ring.all_tets()));
            const auto cost = [&](int i, int j, int k) {
                const int a = ring.vertices[i], b = ring.vertices[j], c = ring.vertices[k];
                const double least = std::min(thickness_of({a, b, c, ring.to}), thickness_of({b, a, c, ring.from}));
                return least > 0 ? 1 / std::min(1.0, least) : std::numeric_limits<double>::infinity();
            };
            const RingTriangulation best = triangulate_ring<WorstOf>(ring.size, 1 / (before * least_gain), cost);
            if (std::isinf(best.cost)) continue;
            std::array<Tet, 2 * EdgeRing::max_size> added;
            const int count = tets_of_triangulation(ring, best, added);
            editor_.replace(ring.all_tets(), {added.data(), static_cast<std::size_t>(count)});
            return true;
        }
        return false;
    }

    bool collapse(int tet) {
        const Tet corners = complex_.tets[tet];
        for (const int gone : corners) {
            if (complex_.is_fixed[gone] || !gather_star(complex_, gone, star_)) continue;
            const double before = thinnest(star_);
            double best = before;
            std::vector<Tet> best_tets;
            for (const int apex : neighbours_of(gone)) {
                std::vector<Tet> cones;
                double least = 1;
                for (std::size_t i = 0; i < star_.size() && least > best; ++i) {
                    Tet cone = complex_.tets[star_[i]];
                    if (std::find(cone.begin(), cone.end(), apex) != cone.end()) continue;
                    cone[corner_of(cone, gone)] = apex;
                    least = std::min(least, thickness_of(cone));
                    cones.push_back(cone);
                }
                if (least > best) best = least, best_tets = std::move(cones);
            }
            if (!is_gain(before, best) || best_tets.empty()) continue;
            editor_.replace(star_, best_tets);
            return true;
        }
        return false;
    }

    std::vector<int> neighbours_of(int vertex) const {
        std::vector<int> around;
        for (const int t : star_) around.insert(around.end(), complex_.tets[t].begin(), complex_.tets[t].end());
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        std::erase(around, vertex);
        return around;
    }

    bool move(int tet) {
        bool gained = false;
        for (const int v : complex_.tets[tet])
            if (!complex_.is_fixed[v] && gather_star(complex_, v, star_)) gained = climb(v) || gained;
        return gained;
    }

    /// Hill climbing along the axes and the space diagonals, and towards the middle of the star.
    bool climb(int vertex) {
        Vec3& place = complex_.points[vertex];
        const double before = thinnest(star_);
        double best = before, reach = 0;
        Vec3 middle{};
        const std::vector<int> around = neighbours_of(vertex);
        for (const int n : around) {
            reach += distance(complex_.points[n], place) / static_cast<double>(around.size());
            middle = middle + (1.0 / static_cast<double>(around.size())) * complex_.points[n];
        }
        const auto try_at = [&](const Vec3& trial) {
            const Vec3 old = place;
            place = trial;
            const double now = thinnest(star_);
            if (now > best) {
                best = now;
                return true;
            }
            place = old;
            return false;
        };
        for (const double share : {1.0, 0.5, 0.25, 0.1}) try_at(place + share * (middle - place));
        for (double step = 0.3 * reach; step > 1e-4 * reach && best < 1;) {
            bool better = false;
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = -1; z <= 1; ++z)
                        better = try_at(place + step * Vec3{double(x), double(y), double(z)}) || better;
            if (!better) step *= 0.5;
        }
        return is_gain(before, best);
    }

    TetComplex& complex_;
    double least_volume_;
    RunContext& context_;
    CavityEditor editor_;
    std::vector<int> star_;
};

}  // namespace

double thickness(const TetComplex& complex, const std::array<int, 4>& tet, double least_volume) {
    const auto& p = complex.points;
    const double six_volumes = dot(cross(p[tet[1]] - p[tet[0]], p[tet[2]] - p[tet[0]]), p[tet[3]] - p[tet[0]]);
    double lengths = 0;  // the largest product of the three edges at a corner
    for (int i = 0; i < 4; ++i) {
        double squares = 1;
        for (int j = 0; j < 4; ++j)
            if (j != i) squares *= squared_length(p[tet[j]] - p[tet[i]]);
        lengths = std::max(lengths, std::sqrt(squares));
    }
    return std::min(six_volumes / (6 * least_volume), six_volumes / (least_share * lengths));
}

std::vector<int> thicken(TetComplex& complex, double least_volume, RunContext& context) {
    std::vector<int> thin = thin_tets(complex, least_volume);
    if (thin.empty()) return thin;
    return Thickener(complex, least_volume, context).run(std::move(thin));
}

}  // namespace featuremesh
