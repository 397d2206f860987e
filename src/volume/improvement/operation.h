// SPDX-License-Identifier: GPL-3.0-or-later
// A local operation plans a change on the untouched mesh; `improve` decides whether it is made.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/geometry.h"
#include "volume/improvement/objective.h"
#include "volume/tets/cavity_editor.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

/// What it takes to do an operation, and what it is worth. Vertices are moved, new ones get the numbers from
/// points.size() on, and some tets are replaced by others with the same outside.
struct Change {
    struct Move {
        int vertex;
        Vec3 place;
        std::array<double, 2> parameters;  ///< there, on an edge or face
    };
    std::vector<Move> moves;
    std::vector<Vec3> points;
    Mobility mobility = Mobility::free;  ///< of the new vertices
    std::vector<int> removed;
    std::vector<Tet> added;
    std::vector<int> bent;  ///< tets that stay, with a corner that moves
    Value before, after;    ///< of what is removed or bent, and of what is there instead
    Price price;
    bool was_dear = false;  ///< to plan, in vain or not
};

/// The tets that a plan depends on: while none of them changes, nor the star of a corner of the tet it is for, the plan
/// stays what it is. Kept for those who plan ahead.
class Footprint {
  public:
    void begin(bool is_kept) { tets_.clear(), is_kept_ = is_kept; }
    void add(int tet) {
        if (is_kept_) tets_.push_back(tet);
    }
    void add(std::span<const int> tets) {
        if (is_kept_) tets_.insert(tets_.end(), tets.begin(), tets.end());
    }
    bool is_kept() const { return is_kept_; }
    std::span<const int> tets() const { return tets_; }  ///< some of them more than once

  private:
    bool is_kept_ = false;
    std::vector<int> tets_;
};

/// Calls visit(ring) for the inner edges of the tet where is_due(from, to) says so of their vertices. Whatever rings
/// are looked at join the footprint.
template <class IsDue, class Visit>
void visit_rings(const TetComplex& complex, int tet, Footprint& footprint, const IsDue& is_due, const Visit& visit) {
    for (const auto& [from, to] : edge_corners) {
        if (!is_due(complex.tets[tet][from], complex.tets[tet][to])) continue;
        EdgeRing ring;
        const bool is_inside = find_ring(complex, tet, from, to, ring);
        footprint.add(ring.all_tets());
        if (is_inside) visit(ring);
    }
}

template <class Visit>
void visit_rings(const TetComplex& complex, int tet, Footprint& footprint, const Visit& visit) {
    visit_rings(
        complex, tet, footprint, [](int, int) { return true; }, visit);
}

class Operation {
  public:
    virtual ~Operation() = default;
    virtual std::string_view name() const = 0;
    /// Puts a change that `Objective::is_better` accepts, the best that was found for this tet, into `change`, which is
    /// empty. False where there is none. Adds what it looks at to the footprint.
    virtual bool plan(int tet, Change& change, Footprint& footprint) = 0;
    /// The same operation with scratch memory of its own, for another thread: what it plans is the same. None where a
    /// plan depends on those made before it.
    virtual std::unique_ptr<Operation> for_another_thread() const = 0;
    /// Called before plans that several threads make at the same time.
    virtual void prepare() {}
    /// It may cost a hundred times what others do, which counts against the budget where it does.
    virtual bool is_dear() const { return false; }
    /// It may help a tet whose worst angle lies between two boundary triangles.
    virtual bool moves_boundary() const { return false; }
};

using Operations = std::vector<std::unique_ptr<Operation>>;

}  // namespace featuremesh
