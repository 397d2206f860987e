// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/star_shape.h"

#include <algorithm>
#include <utility>

#include "core/directions.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

void StarShape::add(const Vec3& a, const Vec3& b, const Vec3& c, const std::array<bool, 3>& is_on_boundary) {
    const std::size_t lane = faces_.size() % FourTriangles::count;
    faces_.push_back({{a, b, c}, is_on_boundary});
    if (lane == 0) fours_.emplace_back();
    fours_.back().set(lane, faces_.back());
    fours_.back().fill_up(lane + 1);
}

void StarShape::gather(const TetComplex& complex, std::span<const int> star, int vertex) {
    clear(is_on_boundary(complex.mobility[vertex]));
    for (const int t : star) {
        const Tet& v = complex.tets[t];
        const auto& face = opposite_face[corner_of(v, vertex)];
        const std::array seen{v[face[0]], v[face[1]], v[face[2]]};
        add(complex.points[seen[0]], complex.points[seen[1]], complex.points[seen[2]], are_on_boundary(complex, seen));
    }
}

/// Calls visit(place, flaw) for the tets in turn until it says that this is enough.
template <class Visit>
void StarShape::visit_flaws(const Vec3& point, const Visit& visit) const {
    const PlainTets plain = objective_.plain_tets();
    for (std::size_t begin = 0; begin < faces_.size(); begin += FourTriangles::count) {
        const auto flatness = flatness_of_four(point, fours_[begin / FourTriangles::count], plain);
        const std::size_t end = std::min(begin + FourTriangles::count, faces_.size());
        for (std::size_t i = begin; i < end; ++i) {
            const double known = flatness[i - begin];
            if (visit(i, known < 0 ? flaw_at(point, faces_[i]) : known)) return;
        }
    }
}

double StarShape::worst(const Vec3& point, double limit) const {
    const PlainTets plain = objective_.plain_tets();
    double result = 0;
    for (std::size_t four = 0; four < fours_.size(); ++four) {
        const PlainRun run = plain_run(point, fours_, four, plain, limit);
        result = std::max(result, run.most);
        four = run.end;
        const std::size_t begin = four * FourTriangles::count,
                          end = std::min(begin + FourTriangles::count, faces_.size());
        for (std::size_t i = begin; i < end; ++i) {
            const double known = run.flatness[i - begin], flaw = known < 0 ? flaw_at(point, faces_[i]) : known;
            result = std::max(result, flaw);
            if (!(flaw >= limit)) continue;
            if (i > 0) swap_faces(i, 0);
            return result;
        }
    }
    return result;
}

void StarShape::swap_faces(std::size_t i, std::size_t j) const {
    std::swap(faces_[i], faces_[j]);
    for (const std::size_t k : {i, j}) fours_[k / FourTriangles::count].set(k % FourTriangles::count, faces_[k]);
}

Value StarShape::value(const Vec3& point) const {
    Value sum{.shape = sum_of_radius_ratios(point), .count = static_cast<double>(faces_.size())};
    visit_flaws(point, [&](std::size_t, double flaw) {
        sum.worst = std::max(sum.worst, flaw);
        sum.penalty += objective_.penalty(flaw);
        return false;
    });
    return sum;
}

double StarShape::mean_distance(const Vec3& point) const {
    double sum = 0;
    for (const auto& f : faces_) sum += distance(point, f.corners[0]);
    return sum / static_cast<double>(std::max<std::size_t>(1, faces_.size()));
}

Vec3 StarShape::middle() const {
    Vec3 sum{};
    for (const auto& f : faces_) sum += f.corners[0] + f.corners[1] + f.corners[2];
    return sum / static_cast<double>(std::max<std::size_t>(1, 3 * faces_.size()));
}

double StarShape::climb(Vec3& point, double good_enough) const {
    return climb(point, good_enough, directions_in_space(), [](const Vec3&) { return true; });
}

}  // namespace featuremesh
