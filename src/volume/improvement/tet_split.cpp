// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/cone_cavity.h"
#include "volume/improvement/operations.h"

namespace featuremesh {

namespace {

class TetSplit : public Operation {
  public:
    TetSplit(const TetComplex& complex, const Objective& objective)
        : complex_(complex), objective_(objective), cavity_(complex, objective) {}

    std::string_view name() const override { return "split"; }
    bool moves_boundary() const override { return true; }  // so that a tet with a forced angle is looked at, too

    std::unique_ptr<Operation> for_another_thread() const override {
        return std::make_unique<TetSplit>(complex_, objective_);
    }

    bool plan(int tet, Change& change, Footprint& footprint) override {
        footprint.add(tet);
        if (!objective_.is_barred(complex_.tets[tet])) return false;
        change.mobility = Mobility::kept;
        change.after.worst = inverted_flatness;
        visit_starts(complex_, tet, footprint, [&](std::span<const int> start, const Vec3& point) {
            cavity_.open(start, point);
            cavity_.climb(0);
            if (cavity_.worst_after() < change.after.worst) cavity_.describe_if_better({}, change);
        });
        return !change.removed.empty();
    }

  private:
    const TetComplex& complex_;
    const Objective& objective_;
    ConeCavity cavity_;
};

}  // namespace

std::unique_ptr<Operation> tet_split(LocalMesh& mesh, const Objective& objective) {
    return std::make_unique<TetSplit>(mesh.complex(), objective);
}

}  // namespace featuremesh
