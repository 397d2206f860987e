// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
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
/// Of a kept vertex, before it is known whether that is worth it.
constexpr int most_steps_of_kept = 4;
constexpr std::size_t vertices_between_reports = 64;

class ShapeOptimiser {
  public:
    ShapeOptimiser(TetComplex& complex, const ShapeOptions& options, RunContext& context)
        : complex_(complex),
          options_(options),
          context_(context),
          target_(flatness_to_reach(options.target_dihedral_deg)),
          may_move_(complex.points.size(), 0),
          is_kept_(complex.points.size(), 0),
          is_due_(complex.points.size(), 0) {
        for (const int v : options.among) {
            is_kept_[v] = complex.is_fixed[v] == 2 && options.least_gain_of_kept.has_value();
            may_move_[v] = complex.is_fixed[v] == 0 || is_kept_[v];
        }
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

    struct Place {
        Vec3 point;
        double sum;  // of the star's radius ratios
    };

    bool move(int vertex) {
        shape_.gather(complex_, star_of(vertex), vertex);
        const Vec3 start = complex_.points[vertex];
        const StarShape::Ratios ratios = shape_.radius_ratios(start);
        std::optional<Place> place = step(start, ratios);
        if (!place) return false;
        if (is_kept_[vertex]) {
            for (int steps = 1; steps < most_steps_of_kept; ++steps) {
                const std::optional<Place> next = step(place->point, shape_.radius_ratios(place->point));
                if (!next) break;
                place = next;
            }
            if (place->sum < ratios.sum + *options_.least_gain_of_kept) return false;
            is_kept_[vertex] = 0;
        }
        complex_.points[vertex] = place->point;
        return true;
    }

    std::optional<Place> step(const Vec3& start, const StarShape::Ratios& ratios) const {
        const double reach = shape_.mean_height(start), slope = length(ratios.gradient) * reach;  // by edge length
        double step = std::min(longest_step, slope / (curvature * static_cast<double>(shape_.size())));
        for (int k = 0; k <= most_halvings && slope * step > 2 * least_gain_of_sum; ++k, step /= 2) {
            const Vec3 trial = start + ratios.gradient * (step * reach * reach / slope);
            const double sum = shape_.sum_of_radius_ratios(trial);
            if (sum >= ratios.sum + least_gain_of_sum && !is_worse(start, trial)) return Place{trial, sum};
        }
        return {};
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
    std::vector<std::uint8_t> may_move_, is_kept_, is_due_;  // by vertex; a kept one that was moved is none any more
    std::vector<std::size_t> begin_;  // by vertex that may move: where its star begins, with its size
    std::vector<int> stars_;
    StarShape shape_;
};

}  // namespace

ShapeReport optimise_shapes(TetComplex& complex, const ShapeOptions& options, RunContext& context) {
    return ShapeOptimiser(complex, options, context).run();
}

}  // namespace featuremesh
