// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/delaunay/delaunay_flips.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry.h"
#include "volume/tets/edge_removal.h"
#include "volume/tets/tet_measures.h"

namespace featuremesh {

namespace {
/// A flip has to lower the energy by more than rounding.
constexpr double least_energy_gain = 1e-9;
/// Below this share of the energy a new tet counts as flat, and the edge it would be flat at is in the way.
constexpr double flat_share = 1e-6;
constexpr std::size_t tets_between_reports = 1 << 17;
constexpr std::size_t tets_per_chunk = 1 << 13;
}  // namespace

/// The first face, from `first_face` on, whose other apex is inside the circumsphere; not those where skip(next,
/// corners) is true.
template <class Skip>
DelaunayFlipper::Violation DelaunayFlipper::find_violation(int tet, int first_face, const Skip& skip) const {
    const Tet& v = complex_.tets[tet];
    const auto& p = complex_.points;
    const Circumsphere sphere(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
    const Vec3 to_center = sphere.scaled / (2 * sphere.six_volumes);
    const Vec3 center = p[v[0]] + to_center;
    const double squared_radius = squared_length(to_center) * (1 - least_energy_gain);
    for (int face = first_face; face < 4; ++face) {
        const int next = complex_.neighbours[tet][face];
        if (next < 0) continue;
        const Tet& w = complex_.tets[next];
        if (skip(next, w)) continue;
        // what the two tets share cancels out; looking for the face in next's neighbours would be one more cache miss
        const int apex = w[0] ^ w[1] ^ w[2] ^ w[3] ^ v[0] ^ v[1] ^ v[2] ^ v[3] ^ v[face];
        if (!(squared_length(p[apex] - center) >= squared_radius)) return {face, next, apex};
    }
    return {};
}

std::size_t DelaunayFlipper::restore(OdtMarks& marks) {
    flips_ = 0;
    const std::size_t count = complex_.tets.size();
    flagged_.assign(count, 0);
    for (std::size_t begin = 0; begin < count; begin += tets_between_reports) {
        context_.check_cancelled();
        const std::size_t end = std::min(count, begin + tets_between_reports);
        parallel_for(context_, end - begin, tets_per_chunk,
                     [&](std::size_t from, std::size_t to) { flag_violations(marks, begin + from, begin + to); });
    }
    for (std::size_t t = 0; t < count; ++t)
        if (flagged_[t]) flip_from(static_cast<int>(t), marks);
    std::fill(marks.touched.begin(), marks.touched.end(), 0);
    return flips_;
}

void DelaunayFlipper::flag_violations(const OdtMarks& marks, std::size_t begin, std::size_t end) {
    const auto is_touched = [&](const Tet& v) {
        return (marks.touched[v[0]] | marks.touched[v[1]] | marks.touched[v[2]] | marks.touched[v[3]]) != 0;
    };
    for (std::size_t t = begin; t < end; ++t) {
        const int tet = static_cast<int>(t);
        if (complex_.tets[t][0] < 0 || !is_touched(complex_.tets[t])) continue;
        // a face between two touched tets is looked at from one of them
        const auto skip = [&](int next, const Tet& w) { return next < tet && is_touched(w); };
        flagged_[t] = find_violation(tet, 0, skip).face >= 0;
    }
}

void DelaunayFlipper::flip_from(int start, OdtMarks& marks) {
    pending_.push_back(start);
    while (!pending_.empty()) {
        const int tet = pending_.back();
        pending_.pop_back();
        for (int face = 0; complex_.tets[tet][0] >= 0;) {
            const Violation violation = find_violation(tet, face, [](int, const Tet&) { return false; });
            if (violation.face < 0 || flip(tet, violation, marks)) break;
            face = violation.face + 1;
        }
    }
}

/// The 2-3 flip where it is possible, else the removal of the one edge in its way.
bool DelaunayFlipper::flip(int tet, const Violation& violation, OdtMarks& marks) {
    const Tet v = complex_.tets[tet];
    const auto& corner = opposite_face[violation.face];
    const double before = energy(v) + energy(complex_.tets[violation.next]);
    std::array<Tet, 3> fresh;
    double after = 0;
    int blocked = -1, blocks = 0;
    for (int i = 0; i < 3; ++i) {
        fresh[i] = {v[violation.face], v[corner[i]], v[corner[(i + 1) % 3]], violation.apex};
        const double part = energy(fresh[i]);
        if (part <= flat_share * before) blocked = i, ++blocks;
        after += part;
    }
    if (blocks == 1) return remove_edge(tet, corner[blocked], corner[(blocked + 1) % 3], marks);
    if (blocks > 1 || after >= before * (1 - least_energy_gain)) return false;
    replace(std::array{tet, violation.next}, fresh, marks);
    return true;
}

bool DelaunayFlipper::remove_edge(int tet, int from, int to, OdtMarks& marks) {
    EdgeRing ring;
    if (!find_ring(complex_, tet, from, to, ring)) return false;
    double before = 0;
    for (int t : ring.all_tets()) before += energy(complex_.tets[t]);
    const auto best =
        lowest_energy_triangulation(complex_, ring, flat_share * before, before * (1 - least_energy_gain));
    if (std::isinf(best.cost)) return false;
    std::array<Tet, 2 * EdgeRing::max_size> fresh;
    const int count = tets_of_triangulation(ring, best, fresh);
    replace(ring.all_tets(), {fresh.data(), static_cast<std::size_t>(count)}, marks);
    return true;
}

void DelaunayFlipper::replace(std::span<const int> removed, std::span<const Tet> added, OdtMarks& marks) {
    ++flips_;
    for (int tet : editor_.replace(removed, added)) {
        pending_.push_back(tet);
        for (int v : complex_.tets[tet]) marks.queued[v] = complex_.is_free(v);
    }
}

double DelaunayFlipper::energy(const Tet& v) const {
    const auto& p = complex_.points;
    return odt_energy(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
}

}  // namespace featuremesh
