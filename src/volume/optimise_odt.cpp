// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "volume/cavity_editor.h"
#include "volume/edge_removal.h"
#include "volume/optimise.h"
#include "volume/tet_measures.h"

namespace featuremesh {

namespace {

/// A vertex whose optimum is nearer than this share of its star's size stays.
constexpr double still_enough = 0.01;
/// Moves may not press a tet below this share of the mean volume in the star.
constexpr double smallest_volume_share = 0.05;
constexpr std::size_t rounds_between_reports = 2048;

/// Sums over a star: weight * 6 V * (circumcentre - vertex), weight * 6 V, and 6 V.
struct StarSum {
    Vec3 moment{};
    double weight = 0, six_volumes = 0;
    /// The way to the optimum.
    Vec3 shift() const { return weight > 0 ? moment / weight : Vec3{}; }
    bool is_still() const {
        const double reach = still_enough * std::cbrt(six_volumes);
        return squared_length(shift()) <= reach * reach;
    }
};

/// 12 V times the vector from the first corner to the circumcentre, and 6 V.
struct Circumsphere {
    Circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        const Vec3 u = b - a, v = c - a, w = d - a;
        const Vec3 vw = cross(v, w);
        six_volumes = dot(u, vw);
        scaled = squared_length(u) * vw + squared_length(v) * cross(w, u) + squared_length(w) * cross(u, v);
    }
    Vec3 scaled;
    double six_volumes;
};

class OdtOptimiser {
  public:
    OdtOptimiser(TetComplex& complex, const SizingField& sizing, const OdtOptions& options, RunContext& context)
        : complex_(complex), sizing_(sizing), context_(context), editor_(complex), weighted_(options.weight_by_size) {}

    OdtReport run(int sweeps) {
        OdtReport report;
        report.energy_before = energy();
        prepare_sizes();
        queue_vertices_that_gain();
        restore_all();
        for (int sweep = 0; sweep < sweeps; ++sweep) {
            const std::size_t moved = move_queued(static_cast<double>(sweep) / sweeps, 1.0 / sweeps);
            report.moves += moved;
            if (moved == 0) break;
            restore_touched();
        }
        report.energy_after = energy();
        return report;
    }

  private:
    double energy() const {
        double sum = 0;
        for (const Tet& v : complex_.tets)
            if (v[0] >= 0) sum += odt_energy(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
        return sum;
    }

    const Vec3& point(int v) const { return complex_.points[v]; }

    void prepare_sizes() {
        if (!weighted_) return;
        sizes_.resize(complex_.points.size());
        parallel_for(context_, sizes_.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) sizes_[v] = sizing_.at(complex_.points[v]);
        });
    }

    double weight(const Tet& v) const {
        if (!weighted_) return 1;
        const double size = (sizes_[v[0]] + sizes_[v[1]] + sizes_[v[2]] + sizes_[v[3]]) / 4;
        return 1 / (size * size * size);
    }

    /// One pass over the tets in memory order instead of a star for every vertex.
    void queue_vertices_that_gain() {
        std::vector<StarSum> sums(complex_.points.size());
        for (const Tet& v : complex_.tets) {
            if (v[0] < 0) continue;
            const Circumsphere sphere(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
            const double share = weight(v), weighted = share * sphere.six_volumes;
            for (int corner : v) {
                sums[corner].moment += (share / 2) * sphere.scaled + weighted * (point(v[0]) - point(corner));
                sums[corner].weight += weighted;
                sums[corner].six_volumes += sphere.six_volumes;
            }
        }
        queued_.assign(complex_.points.size(), 0);
        touched_.assign(complex_.points.size(), 0);
        for (std::size_t v = 0; v < sums.size(); ++v) queued_[v] = !complex_.is_fixed[v] && !sums[v].is_still();
    }

    std::size_t move_queued(double share_before, double share) {
        std::vector<int> vertices;
        for (std::size_t v = 0; v < queued_.size(); ++v)
            if (queued_[v]) vertices.push_back(static_cast<int>(v));
        std::size_t moved = 0;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            if (i % rounds_between_reports == 0)
                context_.progress(share_before + share * static_cast<double>(i) / static_cast<double>(vertices.size()));
            queued_[vertices[i]] = 0;
            moved += move(vertices[i]);
        }
        return moved;
    }

    bool move(int vertex) {
        if (!gather_star(complex_, vertex, star_)) return false;
        StarSum sum;
        const Vec3 start = point(vertex);
        faces_.clear();
        for (int tet : star_) {
            const Tet& v = complex_.tets[tet];
            const auto& face = opposite_face[corner_of(v, vertex)];
            faces_.push_back({point(v[face[0]]), point(v[face[1]]), point(v[face[2]])});
            const Circumsphere sphere(start, faces_.back()[0], faces_.back()[1], faces_.back()[2]);
            const double share = weight(v);
            sum.moment += (share / 2) * sphere.scaled;
            sum.weight += share * sphere.six_volumes;
            sum.six_volumes += sphere.six_volumes;
        }
        if (sum.is_still()) return false;
        return try_shift(vertex, sum.shift(),
                         smallest_volume_share * sum.six_volumes / static_cast<double>(star_.size()));
    }

    bool try_shift(int vertex, const Vec3& shift, double smallest) {
        const Vec3 start = point(vertex);
        for (double step : {1.0, 0.5, 0.25}) {
            const Vec3 trial = start + step * shift;
            const bool is_valid = std::all_of(faces_.begin(), faces_.end(), [&](const auto& f) {
                return dot(cross(f[0] - trial, f[1] - trial), f[2] - trial) > smallest;
            });
            if (!is_valid) continue;
            complex_.points[vertex] = trial;
            if (weighted_) sizes_[vertex] = sizing_.at(trial);
            touched_[vertex] = 1;
            for (int tet : star_)
                for (int v : complex_.tets[tet]) queued_[v] = !complex_.is_fixed[v];
            queued_[vertex] = step < 1;
            return true;
        }
        return false;
    }

    void restore_all() {
        std::fill(touched_.begin(), touched_.end(), 1);
        restore_touched();
    }

    bool is_touched(const Tet& v) const { return touched_[v[0]] | touched_[v[1]] | touched_[v[2]] | touched_[v[3]]; }

    /// Flips until every face near a touched vertex is locally Delaunay or no flip lowers the energy.
    void restore_touched() {
        const std::size_t count = complex_.tets.size();
        for (std::size_t t = 0; t < count; ++t) {
            if (t % (16 * rounds_between_reports) == 0) context_.check_cancelled();
            if (complex_.tets[t][0] >= 0 && is_touched(complex_.tets[t])) pending_.push_back(static_cast<int>(t));
            while (!pending_.empty()) {
                const int tet = pending_.back();
                pending_.pop_back();
                if (complex_.tets[tet][0] >= 0) flip_faces_of(tet);
            }
        }
        std::fill(touched_.begin(), touched_.end(), 0);
    }

    void flip_faces_of(int tet) {
        const Tet v = complex_.tets[tet];
        const Circumsphere sphere(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
        const Vec3 to_center = sphere.scaled / (2 * sphere.six_volumes);
        const Vec3 center = point(v[0]) + to_center;
        const double squared_radius = squared_length(to_center) * (1 - 1e-9);
        for (int face = 0; face < 4; ++face) {
            const int next = complex_.neighbours[tet][face];
            if (next < 0) continue;
            const Tet& w = complex_.tets[next];
            // what the two tets share cancels out
            const int apex = w[0] ^ w[1] ^ w[2] ^ w[3] ^ v[0] ^ v[1] ^ v[2] ^ v[3] ^ v[face];
            if (squared_length(point(apex) - center) >= squared_radius) continue;
            if (flip(tet, face, next, apex)) return;
        }
    }

    /// The 2-3 flip where it is possible, else the removal of the one edge in its way.
    bool flip(int tet, int face, int next, int apex) {
        const Tet v = complex_.tets[tet];
        const auto& corner = opposite_face[face];
        const std::array<int, 3> f{v[corner[0]], v[corner[1]], v[corner[2]]};
        const double before = tet_energy(v) + tet_energy(complex_.tets[next]);
        std::array<Tet, 3> fresh;
        double after = 0;
        int blocked = -1, blocks = 0;
        for (int i = 0; i < 3; ++i) {
            fresh[i] = {v[face], f[i], f[(i + 1) % 3], apex};
            const double part = tet_energy(fresh[i]);
            if (part <= 1e-6 * before) blocked = i, ++blocks;
            after += part;
        }
        if (blocks == 1) return remove_edge(tet, corner[blocked], corner[(blocked + 1) % 3]);
        if (blocks > 1 || after >= before * (1 - 1e-9)) return false;
        replace(std::array{tet, next}, fresh);
        return true;
    }

    double tet_energy(const Tet& v) const { return odt_energy(point(v[0]), point(v[1]), point(v[2]), point(v[3])); }

    bool remove_edge(int tet, int from, int to) {
        EdgeRing ring;
        if (!find_ring(complex_, tet, from, to, ring)) return false;
        double before = 0;
        for (int i = 0; i < ring.size; ++i) before += tet_energy(complex_.tets[ring.tets[i]]);
        const auto best = lowest_energy_triangulation(complex_, ring, before * (1 - 1e-9));
        if (std::isinf(best.cost)) return false;
        std::array<Tet, 2 * EdgeRing::max_size> fresh;
        const int count = tets_of_triangulation(ring, best, fresh);
        replace({ring.tets.data(), static_cast<std::size_t>(ring.size)},
                {fresh.data(), static_cast<std::size_t>(count)});
        return true;
    }

    void replace(std::span<const int> removed, std::span<const Tet> added) {
        for (int tet : editor_.replace(removed, added)) {
            pending_.push_back(tet);
            for (int v : complex_.tets[tet]) queued_[v] = !complex_.is_fixed[v];
        }
    }

    TetComplex& complex_;
    const SizingField& sizing_;
    RunContext& context_;
    CavityEditor editor_;
    bool weighted_;
    std::vector<double> sizes_;
    std::vector<std::uint8_t> queued_, touched_;
    std::vector<int> pending_, star_;
    std::vector<std::array<Vec3, 3>> faces_;
};

}  // namespace

OdtReport optimise_odt(TetComplex& complex, const SizingField& sizing, const OdtOptions& options, RunContext& context) {
    return OdtOptimiser(complex, sizing, options, context).run(options.sweeps);
}

}  // namespace featuremesh
