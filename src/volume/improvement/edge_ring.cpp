// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "volume/improvement/local_mesh.h"
#include "volume/improvement/operations.h"
#include "volume/tets/cavity_editor.h"
#include "volume/tets/edge_removal.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

class EdgeRingOperation : public Operation {
  public:
    EdgeRingOperation(const LocalMesh& mesh, const Objective& objective)
        : mesh_(mesh), complex_(mesh.complex()), objective_(objective) {}

    std::string_view name() const override { return "edge ring"; }

    std::unique_ptr<Operation> for_another_thread() const override {
        return std::make_unique<EdgeRingOperation>(mesh_, objective_);
    }

    bool plan(int tet, Change& change, Footprint& footprint) override {
        double least = inverted_flatness;
        tried_at_.resize(complex_.tets.size(), 0);
        const std::uint32_t last_try = std::exchange(tried_at_[tet], 0);
        const auto may_have_changed = [&](int vertex) { return mesh_.changed_at(vertex) > last_try; };
        const auto is_due = [&](int from, int to) {
            return last_try == 0 || footprint.is_kept() || (may_have_changed(from) && may_have_changed(to));
        };
        visit_rings(complex_, tet, footprint, is_due, [&](const EdgeRing& ring) {
            if (last_try > 0 && !mesh_.has_changed(ring.all_tets(), last_try)) return;
            const double limit =
                std::min(least, Objective::improved(objective_.worst(complex_, ring.all_tets()), change.price.angle));
            const RingTriangulation<> found = triangulate_ring<WorstOf>(ring.size, limit, [&](int i, int j, int k) {
                const int a = ring.vertices[i], b = ring.vertices[j], c = ring.vertices[k];
                const double upper = objective_.flaw(complex_, {a, b, c, ring.to});
                return upper >= limit ? upper : std::max(upper, objective_.flaw(complex_, {b, a, c, ring.from}));
            });
            if (std::isinf(found.cost)) return;
            std::array<Tet, 2 * EdgeRing::max_size> added;
            const std::span<const Tet> fresh{added.data(),
                                             static_cast<std::size_t>(tets_of_triangulation(ring, found, added))};
            const Value before = objective_.value(complex_, ring.all_tets()), after = objective_.value(complex_, fresh);
            if (!objective_.is_better(before, after, change.price)) return;
            least = found.cost;
            change.before = before, change.after = after;
            change.removed.assign(ring.all_tets().begin(), ring.all_tets().end());
            change.added.assign(fresh.begin(), fresh.end());
        });
        if (!change.removed.empty()) return true;
        tried_at_[tet] = mesh_.now();
        return false;
    }

  private:
    const LocalMesh& mesh_;
    const TetComplex& complex_;
    const Objective& objective_;
    std::vector<std::uint32_t> tried_at_;  // by tet: when all its rings were tried in vain; 0: never
};

}  // namespace

std::unique_ptr<Operation> edge_ring(LocalMesh& mesh, const Objective& objective) {
    return std::make_unique<EdgeRingOperation>(mesh, objective);
}

}  // namespace featuremesh
