// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "volume/improvement/corner_operation.h"
#include "volume/improvement/operations.h"
#include "volume/improvement/star_shape.h"

namespace featuremesh {

namespace {

class VertexMove : public CornerOperation {
  public:
    VertexMove(const LocalMesh& mesh, const Objective& objective, std::shared_ptr<TriedMarks> tried,
               std::unique_ptr<Projector> own = {})
        : CornerOperation(mesh, objective, std::move(tried)),
          own_projector_(std::move(own)),
          projector_(own_projector_ ? own_projector_.get() : mesh.surface().projector),
          shape_(objective) {}

    std::string_view name() const override { return "vertex move"; }
    bool moves_boundary() const override { return !mesh_.surface().vertices.empty(); }

    std::unique_ptr<Operation> for_another_thread() const override {
        return std::make_unique<VertexMove>(mesh_, objective_, tried_,
                                            projector_ ? std::make_unique<Projector>(projector_->another()) : nullptr);
    }

  private:
    bool may_help(Mobility corner) const override { return corner != Mobility::fixed; }

    bool plan_at(int vertex, Change& change) override {
        if (!mesh_.gather(vertex, star_) || mesh_.is_held(vertex, star_)) return false;
        // where a vertex of the surface moves, a needle may become none, and the angle that was excused counts
        if (mesh_.is_on_surface(vertex) && objective_.excuses_any(complex_, star_.tets)) return false;
        shape_.gather(complex_, star_.tets, vertex);
        vertex_ = vertex, start_ = complex_.points[vertex];
        if (!objective_.looks_at_shapes() && shape_.worst(start_) <= objective_.target()) return false;
        change.before = shape_.value(start_);
        change.price = mesh_.price_of_moving(vertex);
        if (change.before.worst > objective_.target() && climb(change)) return true;
        return objective_.is_poor(change.before.mean_shape()) && go_uphill(change);
    }

    /// Climbs in the worst angle, along the tangents; back on a curved face or edge, part of the way may be better.
    bool climb(Change& change) {
        Vec3 aim = start_;
        const double wanted = Objective::improved(change.before.worst, change.price.angle);
        const double best = shape_.climb(aim, objective_.target(), mesh_.ways_from(vertex_, star_, projector_),
                                         [&](const Vec3& trial) { return mesh_.keeps_triangles(star_, trial); });
        if (best >= wanted) return false;
        for (const double share : {1.0, 0.5, 0.25})
            if (take(start_ + share * (aim - start_), change)) return true;
        return false;
    }

    /// Climbs in the sum of the radius ratios. A step is slope / (curvature x tets): two to three times the way to the
    /// top in a good star, since in a poor one it is further.
    bool go_uphill(Change& change) {
        constexpr double longest_step = 0.15, curvature = 2;  // in mean edge lengths of the star
        constexpr int most_halvings = 2, most_steps = 4;
        const double least = std::min(change.price.shape, Price{}.shape);
        Vec3 place = start_;
        double sum = change.before.shape;
        // a dear move may take some steps before it is known whether it is worth it
        for (int steps = 0; steps < (change.price.shape > least ? most_steps : 1); ++steps) {
            const Vec3 way = mesh_.along(vertex_, shape_.radius_ratios(place).gradient, projector_);
            const double reach = shape_.mean_distance(place), slope = length(way) * reach;  // by edge length
            double step = std::min(longest_step, slope / (curvature * change.before.count));
            bool is_higher = false;
            for (int k = 0; k <= most_halvings && !is_higher && slope * step > 2 * least; ++k, step /= 2) {
                const Vec3 trial = place + way * (step * reach * reach / slope);
                const double there = shape_.sum_of_radius_ratios(trial);
                if (there < sum + least || shape_.worst(trial) > std::max(change.before.worst, objective_.target()))
                    continue;
                place = trial, sum = there, is_higher = true;
            }
            if (!is_higher) break;
        }
        return sum >= change.before.shape + change.price.shape && take(place, change);
    }

    bool take(const Vec3& aim, Change& change) {
        const std::optional<Change::Move> there = mesh_.place_near(vertex_, aim, projector_);
        if (!there || !mesh_.keeps_triangles(star_, there->place)) return false;
        change.after = shape_.value(there->place);
        if (!objective_.is_better(change.before, change.after, change.price) ||
            !mesh_.keeps_volume(vertex_, star_, there->place) || !mesh_.stays_within(*there, projector_))
            return false;
        change.moves.push_back(*there);
        change.bent = star_.tets;
        return true;
    }

    std::unique_ptr<Projector> own_projector_;  // of another thread's
    const Projector* projector_;
    StarShape shape_;
    int vertex_ = -1;
    Vec3 start_{};
};

}  // namespace

std::unique_ptr<Operation> vertex_move(LocalMesh& mesh, const Objective& objective) {
    return std::make_unique<VertexMove>(mesh, objective, std::make_shared<TriedMarks>());
}

}  // namespace featuremesh
