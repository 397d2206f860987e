// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <span>

#include "volume/cavity_editor.h"
#include "volume/optimise.h"
#include "volume/tet_measures.h"
#include "volume/vertex_move.h"

namespace featuremesh {

namespace {

/// In mean edge lengths of the star.
constexpr double longest_step = 0.15;
/// A step is slope / (curvature x tets): twice to three times the way to the top of a good star, since poor ones have
/// theirs further away.
constexpr double curvature = 2;
/// Of a star's sum: less is not worth a move.
constexpr double least_gain_of_sum = 1e-2;
constexpr int most_halvings = 2;
constexpr std::size_t vertices_between_reports = 64;

class ShapeOptimiser {
  public:
    ShapeOptimiser(TetComplex& complex, const ShapeOptions& options, RunContext& context)
        : complex_(complex),
          options_(options),
          context_(context),
          target_(flatness_to_reach(options.target_dihedral_deg)),
          may_move_(complex.points.size(), 0),
          is_due_(complex.points.size(), 0) {
        for (const int v : options.among) may_move_[v] = complex.is_fixed[v] == 0;
        gather_stars();
    }

    ShapeReport run() {
        is_due_ = may_move_;
        ShapeReport report;
        for (int sweep = 0; sweep < options_.sweeps; ++sweep) {
            const std::size_t moves = move_all(sweep);
            report.moves += moves;
            if (moves == 0) break;
        }
        return report;
    }

  private:
    /// Once, since only places change.
    void gather_stars() {
        begin_.assign(complex_.points.size(), 0);
        std::vector<int> star;
        for (const int v : options_.among) {
            if (!may_move_[v]) continue;
            if (!gather_star(complex_, v, star)) may_move_[v] = 0;
            begin_[v] = stars_.size();
            stars_.push_back(static_cast<int>(star.size()));
            stars_.insert(stars_.end(), star.begin(), star.end());
        }
    }
    std::span<const int> star_of(int vertex) const {
        const int* count = stars_.data() + begin_[vertex];
        return {count + 1, static_cast<std::size_t>(*count)};
    }

    std::size_t move_all(int sweep) {
        std::size_t moves = 0, looked_at = 0;
        for (const int v : options_.among) {
            if (looked_at++ % vertices_between_reports == 0)
                context_.progress(
                    (sweep + static_cast<double>(looked_at) / static_cast<double>(options_.among.size())) /
                    options_.sweeps);
            if (!is_due_[v]) continue;
            is_due_[v] = 0;
            if (!move(v)) continue;
            ++moves;
            for (const int tet : star_of(v))
                for (const int corner : complex_.tets[tet]) is_due_[corner] = may_move_[corner];
        }
        return moves;
    }

    bool move(int vertex) {
        shape_.gather(complex_, star_of(vertex), vertex);
        const Vec3 start = complex_.points[vertex];
        const StarShape::Ratios ratios = shape_.radius_ratios(start);
        const double reach = shape_.mean_height(start), slope = length(ratios.gradient) * reach;  // by edge length
        double step = std::min(longest_step, slope / (curvature * static_cast<double>(shape_.size())));
        for (int k = 0; k <= most_halvings && slope * step > 2 * least_gain_of_sum; ++k, step /= 2) {
            const Vec3 trial = start + ratios.gradient * (step * reach * reach / slope);
            if (shape_.sum_of_radius_ratios(trial) < ratios.sum + least_gain_of_sum || is_worse(start, trial)) continue;
            complex_.points[vertex] = trial;
            return true;
        }
        return false;
    }

    bool is_worse(const Vec3& start, const Vec3& trial) const {
        const double worst = shape_.worst(trial, 2 * inverted_flatness);
        return worst > target_ && (worst > shape_.worst(start, 2 * inverted_flatness) ||
                                   shape_.burden(trial, target_) > shape_.burden(start, target_));
    }

    TetComplex& complex_;
    const ShapeOptions& options_;
    RunContext& context_;
    double target_;
    std::vector<std::uint8_t> may_move_, is_due_;  // by vertex
    std::vector<std::size_t> begin_;               // by vertex that may move: where its star begins, with its size
    std::vector<int> stars_;
    StarShape shape_;
};

}  // namespace

ShapeReport optimise_shapes(TetComplex& complex, const ShapeOptions& options, RunContext& context) {
    return ShapeOptimiser(complex, options, context).run();
}

}  // namespace featuremesh
