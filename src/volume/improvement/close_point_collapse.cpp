// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/geometry.h"
#include "volume/delaunay/lattice_seeds.h"
#include "volume/improvement/corner_operation.h"
#include "volume/improvement/operations.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

class ClosePointCollapse : public CornerOperation {
  public:
    ClosePointCollapse(const LocalMesh& mesh, const Objective& objective, const WantedSize& size,
                       std::shared_ptr<TriedMarks> tried)
        : CornerOperation(mesh, objective, std::move(tried)), size_(size) {}

    std::string_view name() const override { return "close point collapse"; }
    bool moves_boundary() const override { return true; }  // what is forced need not be close

    std::unique_ptr<Operation> for_another_thread() const override {
        return std::make_unique<ClosePointCollapse>(mesh_, objective_, size_, tried_);
    }

  private:
    bool may_help(Mobility corner) const override { return corner == Mobility::free; }

    bool plan_at(int v, Change& change) override {
        const std::vector<int>& star = star_.tets;
        if (!mesh_.gather(v, star_)) return false;
        gather_neighbours(complex_, v, star, neighbours_);
        // where volume is scarce, a vertex that blocks one change may make room for another
        if (!is_too_close(v) || objective_.excuses_any(complex_, star)) return false;
        change.before = objective_.value(complex_, star);
        change.price = price_of_fewer_tets;
        change.after.worst = inverted_flatness;
        for (const int onto : neighbours_) {
            if (!collapse(v, onto, change.after.worst)) continue;
            const Value after = objective_.value(complex_, tets_);
            if (!objective_.is_better(change.before, after, change.price)) continue;
            change.after = after;
            change.added.swap(tets_);
            change.removed = star;
        }
        return !change.removed.empty();
    }

    /// Puts what becomes of the star's tets in `tets_`, unless one of them is no better than that.
    bool collapse(int v, int onto, double worst) {
        tets_.clear();
        for (const int t : star_.tets) {
            Tet tet = complex_.tets[t];
            if (std::find(tet.begin(), tet.end(), onto) != tet.end()) continue;
            std::replace(tet.begin(), tet.end(), v, onto);
            if (objective_.flaw(complex_, tet) >= worst) return false;
            tets_.push_back(tet);
        }
        return true;
    }

    bool is_too_close(int v) const {
        const Vec3& p = complex_.points[v];
        const double least = SeedOptions{}.spacing * size_.at(p);
        return std::any_of(neighbours_.begin(), neighbours_.end(),
                           [&](int other) { return distance(p, complex_.points[other]) < least; });
    }

    const WantedSize& size_;
    std::vector<int> neighbours_;
    std::vector<Tet> tets_;
};

}  // namespace

std::unique_ptr<Operation> close_point_collapse(LocalMesh& mesh, const Objective& objective, const WantedSize& size) {
    return std::make_unique<ClosePointCollapse>(mesh, objective, size, std::make_shared<TriedMarks>());
}

}  // namespace featuremesh
