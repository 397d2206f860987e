// SPDX-License-Identifier: GPL-3.0-or-later
// The vertex step of ODT: who gains, and moves that are the same for any number of threads.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"
#include "core/run_context.h"
#include "sizing/sizing_field.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

/// By vertex, 0 or 1: who may gain from a move, and who was moved since the flips looked.
struct OdtMarks {
    std::vector<std::uint8_t> queued, touched;
};

/// Moves vertices one at a time in effect (Gauss-Seidel, so that the energy cannot rise): space is cut into blocks six
/// edges wide with eight colours, blocks of one colour are far enough apart to be worked on at the same time.
class OdtMover {
  public:
    /// `sizing` is asked only when the volumes are weighted by it.
    OdtMover(TetComplex& complex, const SizingField& sizing, bool is_weighted, RunContext& context);

    /// Queues the free vertices that are away from their optimum.
    void queue_gainers(OdtMarks& marks) const;

    /// Moves what is queued, queues the neighbours of what was moved; gives the number of moves. `share` of the work is
    /// done before, `part` here.
    std::size_t sweep(OdtMarks& marks, double share, double part);

  private:
    struct Place {
        std::uint64_t block;  // colour first, so that blocks of a colour are next to each other
        int vertex;
    };
    struct Scratch;
    double weight(const Tet& v) const;
    double longest_edge(const OdtMarks& marks) const;
    std::vector<Place> places_of_queued(const OdtMarks& marks, double width) const;
    bool move(int vertex, double longest_shift, OdtMarks& marks, Scratch& scratch);
    bool try_shift(int vertex, const Vec3& shift, double smallest, OdtMarks& marks, const Scratch& scratch);

    TetComplex& complex_;
    const SizingField& sizing_;
    RunContext& context_;
    bool is_weighted_;
    std::vector<double> sizes_;
};

}  // namespace featuremesh
