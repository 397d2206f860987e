// SPDX-License-Identifier: GPL-3.0-or-later
// Flips that lower the ODT energy where vertices have moved: towards Delaunay, on connectivity that need not be.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "volume/delaunay/odt_moves.h"
#include "volume/tets/cavity_editor.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

class DelaunayFlipper {
  public:
    DelaunayFlipper(TetComplex& complex, RunContext& context)
        : complex_(complex), context_(context), editor_(complex) {}

    /// Flips until every face of the tets with a touched vertex is locally Delaunay or no flip there lowers the energy.
    /// Clears `touched`, queues the vertices of flipped tets. Gives the number of flips.
    std::size_t restore(OdtMarks& marks);

  private:
    struct Violation {
        int face = -1, next = -1, apex = -1;
    };
    template <class Skip>
    Violation find_violation(int tet, int first_face, const Skip& skip) const;
    void flag_violations(const OdtMarks& marks, std::size_t begin, std::size_t end);
    void flip_from(int tet, OdtMarks& marks);
    bool flip(int tet, const Violation& violation, OdtMarks& marks);
    bool remove_edge(int tet, int from, int to, OdtMarks& marks);
    void replace(std::span<const int> removed, std::span<const Tet> added, OdtMarks& marks);
    double energy(const Tet& v) const;

    TetComplex& complex_;
    RunContext& context_;
    CavityEditor editor_;
    std::size_t flips_ = 0;
    std::vector<std::uint8_t> flagged_;
    std::vector<int> pending_;
};

}  // namespace featuremesh
