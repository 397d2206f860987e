// SPDX-License-Identifier: GPL-3.0-or-later
// What a good mesh is: the only place that says so. Every operation asks it, and it alone accepts or refuses a change.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "core/geometry.h"
#include "volume/tets/flatness_of_four.h"
#include "volume/tets/needles.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_measures.h"
#include "volume/tets/thin_tets.h"

namespace featuremesh {

/// How good some tets are together. Compared level by level: the worst first.
struct Value {
    double worst = 0;    ///< largest flaw
    double penalty = 0;  ///< sum over the tets that miss the target: one of 5 degrees weighs more than two of 10
    double shape = 0;    ///< sum of the radius ratios 3 r / R
    double count = 0;    ///< of tets
    double mean_shape() const { return count > 0 ? shape / count : 1; }
    Value& operator+=(const Value& other) {
        worst = std::max(worst, other.worst);
        penalty += other.penalty, shape += other.shape, count += other.count;
        return *this;
    }
};

/// What a change has to gain.
struct Price {
    double angle = 1e-3;        ///< share of the squared sine of the worst angle
    double shape = 1e-2;        ///< radius ratios, times the number of tets
    bool needs_target = false;  ///< a gain that stays short of the target counts only where the need is urgent
};
inline constexpr Price price_of_new_vertex{0.05, std::numeric_limits<double>::infinity(), true};
/// A kept node that moves is lost to what was kept; one of the surface costs how well the surface is met.
inline constexpr Price price_of_kept_move{1e-3, 0.3}, price_of_surface_move{0.02, 0.02},
    price_of_kept_surface_move{price_of_surface_move.angle, price_of_kept_move.shape};
inline constexpr Price price_of_lookahead{0.02};
inline constexpr Price price_of_fewer_tets{1e-3, 0};

struct ObjectiveOptions {
    double target_dihedral_deg = 30;
    double least_volume = 0;  ///< mm^3; 0: any positive volume will do
    double poor_shape = 0;    ///< tets of a smaller radius ratio, and stars of a smaller mean, are worth work
    bool is_steep = false;    ///< a few worst tets weigh more against many that nearly reach the target
    std::function<bool(const std::array<int, 4>&)> is_barred{};  ///< tets that must not be, however good their angles
};

class Objective {
  public:
    explicit Objective(ObjectiveOptions options = {})
        : options_(std::move(options)),
          asked_(flatness_of_angle(options_.target_dihedral_deg)),
          target_(flatness_to_reach(options_.target_dihedral_deg)),
          urgent_(flatness_of_angle(urgent_share * options_.target_dihedral_deg)) {}

    const ObjectiveOptions& options() const { return options_; }
    /// The flaw of a tet with the angle that was asked for: those with more miss it.
    double asked() const { return asked_; }
    /// What to work for: a hair better, so that rounding leaves no tet short of what was asked.
    double target() const { return target_; }

    /// How bad a tet is. Up to 1: the largest squared cosine of its dihedral angles (`flatness`), but for the angle
    /// that the CAD forces upon a needle. Above 1, worse than any angle: it is too thin or barred, 2 without volume.
    double flaw(const std::array<Vec3, 4>& corners, const std::array<bool, 4>& is_on_boundary) const {
        if (options_.least_volume > 0 && may_be_thin(corners, options_.least_volume))
            if (const double thick = thickness(corners, options_.least_volume); thick < 1)
                return thick < least_thickness ? inverted_flatness : inverted_flatness - thick;
        const double all = flatness(corners[0], corners[1], corners[2], corners[3]);
        return all < least_flatness_of_needle || all > 1 ? all : unforced_flatness(all, corners, is_on_boundary);
    }
    double flaw(const TetComplex& complex, const std::array<int, 4>& tet) const;
    double worst(const TetComplex& complex, std::span<const int> tets) const;
    /// The flaw of a tet, given what it is by its shape alone.
    double unless_barred(double by_shape, const std::array<int, 4>& tet) const {
        return by_shape < flaw_of_barred && is_barred(tet) ? flaw_of_barred : by_shape;
    }
    /// Those whose flaw is their flatness, wherever they are.
    PlainTets plain_tets() const {
        return {options_.least_volume, least_volume_share, least_flatness_of_needle, needle_share};
    }
    bool is_barred(const std::array<int, 4>& tet) const { return options_.is_barred && options_.is_barred(tet); }
    /// The tet is a needle whose worst angle is forced.
    bool is_excused(const TetComplex& complex, const std::array<int, 4>& tet) const;
    bool excuses_any(const TetComplex& complex, std::span<const int> tets) const;

    /// What of a flaw is left after a gain by this share: of the squared sine of its angle, or of the thickness.
    static double improved(double flaw, double gain) {
        if (flaw > 1)
            return std::max(1 + 1e-9, inverted_flatness - (1 + 10 * gain) * std::max(1e-12, inverted_flatness - flaw));
        return flaw - gain * std::max(1e-6, 1 - flaw);
    }
    /// 1 / sin of the angle, or its square, less that of the target. A tet that is too thin weighs more than all
    /// angles.
    double penalty(double flaw) const {
        if (flaw <= target_) return 0;
        if (flaw > 1) return penalty_of_thin * flaw;
        const double of_flaw = 1 / std::max(1e-6, 1 - flaw), of_target = 1 / (1 - target_);
        return options_.is_steep ? of_flaw - of_target : std::sqrt(of_flaw) - std::sqrt(of_target);
    }

    Value value(const TetComplex& complex, const std::array<int, 4>& tet) const;
    Value value(const TetComplex& complex, std::span<const std::array<int, 4>> tets) const;
    Value value(const TetComplex& complex, std::span<const int> tets) const;

    /// The one rule of acceptance. No tet is without volume. The worst gets better, and the penalty less unless the
    /// target is reached; or the worst no worse and the penalty clearly less; or neither any worse and the mean shape
    /// better.
    bool is_better(const Value& before, const Value& after, const Price& price) const;

    /// How much a tet is in need of work, 0 for none. Bad angles come before poor shapes.
    double need(const TetComplex& complex, const std::array<int, 4>& tet) const;
    bool looks_at_shapes() const { return options_.poor_shape > 0; }
    bool is_poor(double mean_shape) const { return mean_shape < options_.poor_shape; }

  private:
    /// Below this share of the target angle a new vertex is welcome even if the target stays out of reach.
    static constexpr double urgent_share = 0.85;
    /// What is thinner may be turned over but for rounding: no volume at all.
    static constexpr double least_thickness = 1e-6;
    static constexpr double flaw_of_barred = 1.999;  // all but as bad as a tet without volume
    static constexpr double penalty_of_thin = 1e8;

    ObjectiveOptions options_;
    double asked_, target_, urgent_;
};

}  // namespace featuremesh
