// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/cone_cavity.h"

#include <algorithm>

#include "volume/edge_removal.h"
#include "volume/needles.h"
#include "volume/tet_measures.h"

namespace featuremesh {

namespace {
constexpr std::size_t most_tets = 48;
}  // namespace

void ConeCavity::reset(std::span<const int> start) {
    tets_.clear();
    faces_.clear();
    worst_before_ = 0;
    editor_.begin_marks();
    for (int tet : start) add(tet);
}

void ConeCavity::add(int tet) {
    tets_.push_back(tet);
    editor_.mark(tet);
    worst_before_ = std::max(worst_before_, worst_flatness(editor_.complex(), std::array{tet}));
    for (int face = 0; face < 4; ++face) {
        const int next = editor_.complex().neighbours[tet][face];
        if (next >= 0 && editor_.is_marked(next))
            remove_face(next, face_towards(editor_.complex().neighbours[next], tet));
        else
            add_face(tet, face);
    }
}

std::array<bool, 3> ConeCavity::are_outside(const std::array<int, 3>& corners) const {
    const TetComplex& complex = editor_.complex();
    return {may_have_needle(complex, corners[0]), may_have_needle(complex, corners[1]),
            may_have_needle(complex, corners[2])};
}

double ConeCavity::cone_flatness(const std::array<int, 3>& f) const {
    const auto& p = editor_.complex().points;
    const double all = flatness(point_, p[f[0]], p[f[1]], p[f[2]]);
    if (all < least_flatness_of_needle || all == inverted_flatness) return all;
    const auto [a, b, c] = are_outside(f);
    return unforced_flatness(all, {point_, p[f[0]], p[f[1]], p[f[2]]},
                             {apex_ >= 0 && may_have_needle(editor_.complex(), apex_), a, b, c});
}

void ConeCavity::add_face(int tet, int face) {
    const Tet& v = editor_.complex().tets[tet];
    const auto& corner = opposite_face[face];
    const std::array<int, 3> f{v[corner[0]], v[corner[1]], v[corner[2]]};
    const bool has_apex = apex_ >= 0 && (f[0] == apex_ || f[1] == apex_ || f[2] == apex_);
    // a triangle with the apex makes no cone, but is part of the outside
    faces_.push_back({tet, face, f, has_apex ? 0 : cone_flatness(f)});
}

void ConeCavity::remove_face(int tet, int face) {
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        if (faces_[i].tet != tet || faces_[i].face != face) continue;
        faces_[i] = faces_.back();
        faces_.pop_back();
        return;
    }
}

const ConeCavity::Face* ConeCavity::worst_face() const {
    return &*std::max_element(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) {
        return a.value != b.value ? a.value < b.value : std::pair(a.tet, a.face) > std::pair(b.tet, b.face);
    });
}

bool ConeCavity::loses_fixed_vertex() const {
    const TetComplex& complex = editor_.complex();
    for (int tet : tets_)
        for (int v : complex.tets[tet]) {
            if (!complex.is_fixed[v] || v == apex_) continue;
            const bool is_outside = std::any_of(faces_.begin(), faces_.end(), [&](const Face& f) {
                return f.vertices[0] == v || f.vertices[1] == v || f.vertices[2] == v;
            });
            if (!is_outside) return true;
        }
    return false;
}

bool ConeCavity::grow(std::span<const int> start, int apex, const Vec3& point) {
    if (start.size() >= most_tets) return false;
    apex_ = apex;
    point_ = point;
    reset(start);
    double best_gain = 0;
    std::size_t best_count = 0;
    while (tets_.size() < most_tets && !faces_.empty()) {
        const Face* worst = worst_face();
        const double gain = worst_before_ - worst->value;
        if (gain > best_gain && !loses_fixed_vertex()) {
            best_gain = gain;
            best_count = tets_.size();
        }
        const int next = editor_.complex().neighbours[worst->tet][worst->face];
        if (next < 0) break;
        add(next);
    }
    if (best_count == 0) return false;
    rebuild(best_count);
    return true;
}

void ConeCavity::rebuild(std::size_t count) {
    order_.assign(tets_.begin(), tets_.begin() + static_cast<std::ptrdiff_t>(count));
    reset(order_);
    worst_after_ = worst_face()->value;
}

void ConeCavity::climb(double good_enough) {
    const auto& p = editor_.complex().points;
    shape_.clear();
    for (const Face& f : faces_)
        shape_.add(p[f.vertices[0]], p[f.vertices[1]], p[f.vertices[2]], are_outside(f.vertices));
    worst_after_ = shape_.climb(point_, good_enough);
}

double ConeCavity::burden_before(double target) const { return burden_of(editor_.complex(), tets_, target); }

double ConeCavity::burden_after(double target) const {
    double sum = 0;
    for (const Face& f : faces_) {
        const auto& v = f.vertices;
        if (v[0] == apex_ || v[1] == apex_ || v[2] == apex_) continue;
        sum += burden(cone_flatness(v), target);
    }
    return sum;
}

std::span<const Tet> ConeCavity::cones(int apex) {
    cones_.clear();
    for (const Face& f : faces_) {
        const auto& v = f.vertices;
        if (v[0] != apex && v[1] != apex && v[2] != apex) cones_.push_back({apex, v[0], v[1], v[2]});
    }
    return cones_;
}

}  // namespace featuremesh
