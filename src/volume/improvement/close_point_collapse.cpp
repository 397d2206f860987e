// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "volume/delaunay/lattice_seeds.h"
#include "volume/improvement/operations.h"
#include "volume/improvement/tried_marks.h"

namespace featuremesh {

namespace {

class ClosePointCollapse : public Operation {
  public:
    ClosePointCollapse(const LocalMesh& mesh, const Objective& objective, const WantedSize& size,
                       std::shared_ptr<TriedMarks> tried)
        : mesh_(mesh), complex_(mesh.complex()), objective_(objective), size_(size), tried_(std::move(tried)) {}

    std::string_view name() const override { return "close point collapse"; }
    bool moves_boundary() const override { return true; }  // what is forced need not be close

    std::unique_ptr<Operation> for_another_thread() const override {
        return std::make_unique<ClosePointCollapse>(mesh_, objective_, size_, tried_);
    }
    void prepare() override { tried_->make_room(mesh_); }

    bool plan(int tet, Change& change, Footprint& footprint) override {
        tried_->make_room(mesh_);
        for (const int v : complex_.tets[tet]) {
            if (!complex_.is_free(v) || tried_->has(v, mesh_)) continue;
            const bool is_found = collapse(v, change);
            footprint.add(star_);
            if (is_found) return true;
            tried_->note(v, mesh_);
        }
        return false;
    }

  private:
    bool collapse(int v, Change& change) {
        if (!gather_star(complex_, v, star_)) return false;
        gather_neighbours(complex_, v, star_, neighbours_);
        // where volume is scarce, a vertex that blocks one change may make room for another
        if (!is_too_close(v) || objective_.excuses_any(complex_, star_)) return false;
        change.before = objective_.value(complex_, star_);
        change.price = price_of_fewer_tets;
        change.after.worst = inverted_flatness;
        for (const int onto : neighbours_) {
            tets_.clear();
            for (const int t : star_) {
                Tet tet = complex_.tets[t];
                if (std::find(tet.begin(), tet.end(), onto) != tet.end()) continue;
                std::replace(tet.begin(), tet.end(), v, onto);
                tets_.push_back(tet);
            }
            const Value after = objective_.value(complex_, tets_);
            if (after.worst >= change.after.worst || !objective_.is_better(change.before, after, change.price))
                continue;
            change.after = after;
            change.added.swap(tets_);
            change.removed = star_;
        }
        return !change.removed.empty();
    }

    bool is_too_close(int v) const {
        const Vec3& p = complex_.points[v];
        const double least = SeedOptions{}.spacing * size_.at(p);
        return std::any_of(neighbours_.begin(), neighbours_.end(),
                           [&](int other) { return distance(p, complex_.points[other]) < least; });
    }

    const LocalMesh& mesh_;
    const TetComplex& complex_;
    const Objective& objective_;
    const WantedSize& size_;
    std::vector<int> star_, neighbours_;
    std::shared_ptr<TriedMarks> tried_;
    std::vector<Tet> tets_;
};

}  // namespace

std::unique_ptr<Operation> close_point_collapse(LocalMesh& mesh, const Objective& objective, const WantedSize& size) {
    return std::make_unique<ClosePointCollapse>(mesh, objective, size, std::make_shared<TriedMarks>());
}

}  // namespace featuremesh
