// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/cone_cavity.h"

#include <algorithm>

#include "volume/tets/flatness_of_four.h"

namespace featuremesh {

void ConeCavity::reset(std::span<const int> start, int apex, const Vec3& point) {
    apex_ = apex, point_ = point;
    tets_.clear(), faces_.clear();
    marks_.begin(complex_.tets.size());
    for (const int tet : start) take_in(tet);
    worst_before_ = worst_of(start);
    measure_new_cones();
}

void ConeCavity::add(int tet) {
    take_in(tet);
    worst_before_ = std::max(worst_before_, objective_.flaw(complex_, complex_.tets[tet]));
    measure_new_cones();
}

void ConeCavity::take_in(int tet) {
    tets_.push_back(tet);
    marks_.mark(tet);
    if (footprint_) footprint_->add(tet);
    for (int face = 0; face < 4; ++face) {
        const int next = complex_.neighbours[tet][face];
        if (next >= 0 && marks_.is_marked(next))
            remove_face(next, face_towards(complex_.neighbours[next], tet));
        else
            add_face(tet, face);
    }
}

double ConeCavity::worst_of(std::span<const int> start) {
    if (!std::equal(start.begin(), start.end(), last_start_.begin(), last_start_.end())) {
        last_start_.assign(start.begin(), start.end());
        worst_of_last_ = objective_.worst(complex_, start);
    }
    return worst_of_last_;
}

double ConeCavity::cone_flaw(const std::array<int, 3>& f) const {
    if (apex_ >= 0) return objective_.flaw(complex_, {apex_, f[0], f[1], f[2]});
    const auto& p = complex_.points;
    const auto [a, b, c] = are_on_boundary(complex_, f);
    return objective_.flaw({point_, p[f[0]], p[f[1]], p[f[2]]}, {false, a, b, c});
}

void ConeCavity::add_face(int tet, int face) {
    const Tet& v = complex_.tets[tet];
    const auto& corner = opposite_face[face];
    faces_.push_back({tet, face, {v[corner[0]], v[corner[1]], v[corner[2]]}, not_measured});
}

void ConeCavity::measure_new_cones() {
    const PlainTets plain = objective_.plain_tets();
    std::array<Face*, FourTriangles::count> faces{};
    FourTriangles four;
    std::size_t count = 0;
    const auto measure = [&] {
        four.fill_up(count);
        const auto flatness = flatness_of_four(point_, four, plain);
        for (std::size_t i = 0; i < count; ++i) {
            const auto& [a, b, c] = faces[i]->vertices;
            faces[i]->value = flatness[i] < 0 ? cone_flaw(faces[i]->vertices)
                              : apex_ < 0     ? flatness[i]
                                              : objective_.unless_barred(flatness[i], {apex_, a, b, c});
        }
        count = 0;
    };
    for (Face& face : faces_) {
        if (face.value != not_measured) continue;
        // a triangle with the apex makes no cone, but is part of the outside
        face.value = 0;
        if (face.has(apex_)) continue;
        const auto [a, b, c] = face.vertices;
        faces[count] = &face;
        four.set(count, {{complex_.points[a], complex_.points[b], complex_.points[c]}});
        if (++count == FourTriangles::count) measure();
    }
    if (count > 0) measure();
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

bool ConeCavity::loses_lasting_vertex() const {
    for (const int tet : tets_)
        for (const int v : complex_.tets[tet]) {
            if (complex_.is_free(v) || v == apex_) continue;
            if (std::none_of(faces_.begin(), faces_.end(), [&](const Face& f) { return f.has(v); })) return true;
        }
    return false;
}

bool ConeCavity::grow(std::span<const int> start, int apex, const Vec3& point) {
    if (start.size() >= most_tets) return false;
    reset(start, apex, point);
    double best_gain = 0;
    std::size_t best_count = 0;
    while (tets_.size() < most_tets && !faces_.empty()) {
        const Face* worst = worst_face();
        const double gain = worst_before_ - worst->value;
        if (gain > best_gain && !loses_lasting_vertex()) {
            best_gain = gain;
            best_count = tets_.size();
        }
        const int next = behind(*worst);
        if (next < 0) break;
        add(next);
    }
    if (best_count == 0) return false;
    rebuild(best_count);
    return true;
}

void ConeCavity::describe_if_better(const Price& price, Change& change) {
    const Value before = objective_.value(complex_, tets_), after = value_of_cones();
    if (!objective_.is_better(before, after, price)) return;
    change.before = before, change.after = after, change.price = price;
    change.removed = tets_;
    const auto made = cones(apex_ < 0 ? static_cast<int>(complex_.points.size()) : apex_);
    change.added.assign(made.begin(), made.end());
    change.points.clear();
    if (apex_ < 0) change.points.push_back(point_);
}

void ConeCavity::rebuild(std::size_t count) {
    order_.assign(tets_.begin(), tets_.begin() + static_cast<std::ptrdiff_t>(count));
    reset(order_, apex_, point_);
    worst_after_ = worst_face()->value;
}

bool ConeCavity::make_visible() {
    for (;;) {
        const Face* hidden = worst_face();
        if (hidden->value < inverted_flatness) return true;
        if (behind(*hidden) < 0 || tets_.size() >= most_tets_with_room) return false;
        add(behind(*hidden));
    }
}

bool ConeCavity::give_room() {
    constexpr std::size_t most_at_once = 4;
    std::vector<std::pair<double, int>> thinnest;
    for (Face& f : faces_) {
        f.value = cone_flaw(f.vertices);
        if (behind(f) < 0) continue;
        thinnest.emplace_back(-f.value, behind(f));
        if (footprint_) footprint_->add(behind(f));
    }
    std::sort(thinnest.begin(), thinnest.end());
    std::size_t added = 0;
    for (const auto& [value, tet] : thinnest)
        if (added < most_at_once && tets_.size() < most_tets_with_room && !marks_.is_marked(tet)) add(tet), ++added;
    return added > 0;
}

void ConeCavity::gather_shape() {
    const auto& p = complex_.points;
    shape_.clear(apex_ >= 0 && is_on_boundary(complex_.mobility[apex_]));
    for (const Face& f : faces_)
        if (const auto& [a, b, c] = f.vertices; !f.has(apex_))
            shape_.add(p[a], p[b], p[c], are_on_boundary(complex_, f.vertices));
}

void ConeCavity::climb(double good_enough) {
    gather_shape();
    worst_after_ = shape_.climb(point_, good_enough);
}

Value ConeCavity::value_of_cones() {
    if (apex_ >= 0) return objective_.value(complex_, cones(apex_));
    gather_shape();
    return shape_.value(point_);
}

std::span<const Tet> ConeCavity::cones(int apex) {
    cones_.clear();
    for (const Face& f : faces_)
        if (!f.has(apex)) cones_.push_back({apex, f.vertices[0], f.vertices[1], f.vertices[2]});
    return cones_;
}

}  // namespace featuremesh
