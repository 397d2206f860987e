// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "volume/improvement/operations.h"
#include "volume/tets/cavity_editor.h"
#include "volume/tets/edge_removal.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

class EdgeRingOperation : public Operation {
  public:
    EdgeRingOperation(const TetComplex& complex, const Objective& objective)
        : complex_(complex), objective_(objective) {}

    std::string_view name() const override { return "edge ring"; }

    std::unique_ptr<Operation> for_another_thread() const override {
        return std::make_unique<EdgeRingOperation>(complex_, objective_);
    }

    bool plan(int tet, Change& change, Footprint& footprint) override {
        double least = inverted_flatness;
        visit_rings(complex_, tet, footprint, [&](const EdgeRing& ring) {
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
        return !change.removed.empty();
    }

  private:
    const TetComplex& complex_;
    const Objective& objective_;
};

}  // namespace

std::unique_ptr<Operation> edge_ring(LocalMesh& mesh, const Objective& objective) {
    return std::make_unique<EdgeRingOperation>(mesh.complex(), objective);
}

}  // namespace featuremesh
