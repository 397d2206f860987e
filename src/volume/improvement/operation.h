// SPDX-License-Identifier: GPL-3.0-or-later
// A local operation plans a change on the untouched mesh; `improve` decides whether it is made.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "volume/improvement/objective.h"
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

class Operation {
  public:
    virtual ~Operation() = default;
    virtual std::string_view name() const = 0;
    /// Puts a change that `Objective::is_better` accepts, the best that was found for this tet, into `change`, which is
    /// empty. False where there is none.
    virtual bool plan(int tet, Change& change) = 0;
    /// It may cost a hundred times what others do, which counts against the budget where it does.
    virtual bool is_dear() const { return false; }
    /// It may help a tet whose worst angle lies between two boundary triangles.
    virtual bool moves_boundary() const { return false; }
};

using Operations = std::vector<std::unique_ptr<Operation>>;

}  // namespace featuremesh
