// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "volume/delaunay/delaunay_flips.h"
#include "volume/delaunay/odt_moves.h"
#include "volume/delaunay/optimise_odt.h"
#include "volume/tets/tet_measures.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

constexpr int graded_sweeps = 3;

// sums of chunks, so that the rounding does not depend on the number of threads
double total_energy(const TetComplex& complex, RunContext& context) {
    constexpr std::size_t chunk = 1 << 13;
    std::vector<double> sums(complex.tets.size() / chunk + 1, 0);
    parallel_for(context, complex.tets.size(), chunk, [&](std::size_t begin, std::size_t end) {
        const auto& p = complex.points;
        for (std::size_t t = begin; t < end; ++t) {
            const Tet& v = complex.tets[t];
            if (v[0] >= 0) sums[begin / chunk] += odt_energy(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
        }
    });
    double sum = 0;
    for (double part : sums) sum += part;
    return sum;
}

}  // namespace

OdtReport optimise_odt(TetComplex& complex, const SizingField& sizing, const OdtOptions& options, RunContext& context) {
    OdtReport report;
    report.energy_before = total_energy(complex, context);
    OdtMarks marks;
    marks.queued.assign(complex.points.size(), 0);
    marks.touched.assign(complex.points.size(), 0);
    OdtMover mover(complex, sizing, options.weight_by_size, context);
    DelaunayFlipper flipper(complex, context);
    mover.queue_gainers(marks);
    // far from the boundary and at their optimum the seeds are a lattice that Delaunay has connected already
    for (std::size_t v = 0; v < complex.points.size(); ++v)
        marks.touched[v] = !complex.is_free(static_cast<int>(v)) || marks.queued[v];
    report.flips += flipper.restore(marks);
    const int sweeps = options.weight_by_size ? graded_sweeps * options.sweeps : options.sweeps;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        const std::size_t moved = mover.sweep(marks, static_cast<double>(sweep) / sweeps, 1.0 / sweeps);
        if (moved == 0) break;
        report.moves += moved;
        report.flips += flipper.restore(marks);
    }
    report.energy_after = total_energy(complex, context);
    return report;
}

}  // namespace featuremesh
