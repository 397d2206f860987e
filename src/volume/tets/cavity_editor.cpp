// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/cavity_editor.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "core/sort_once.h"

namespace featuremesh {

RingWalk::RingWalk(const TetComplex& complex, int tet, int from_corner, int to_corner)
    : complex_(complex),
      tet_(tet),
      from_(complex.tets[tet][from_corner]),
      to_(complex.tets[tet][to_corner]),
      behind_(opposite_edge[from_corner][to_corner][0]),
      ahead_(opposite_edge[from_corner][to_corner][1]) {}

bool RingWalk::step() {
    const int hinge = next_vertex(), next = complex_.neighbours[tet_][behind_];
    if (next < 0) return false;
    const Tet& corners = complex_.tets[next];
    behind_ = corner_of(corners, hinge);
    ahead_ = 6 - behind_ - corner_of(corners, from_) - corner_of(corners, to_);
    tet_ = next;
    return true;
}

bool find_ring(const TetComplex& complex, int tet, int from_corner, int to_corner, EdgeRing& ring) {
    ring.from = complex.tets[tet][from_corner];
    ring.to = complex.tets[tet][to_corner];
    ring.size = 0;
    RingWalk walk(complex, tet, from_corner, to_corner);
    do {
        if (ring.size == EdgeRing::max_size) return false;
        ring.vertices[ring.size] = walk.vertex();
        ring.tets[ring.size++] = walk.tet();
        if (!walk.step()) return false;
    } while (walk.tet() != tet);
    return ring.size >= 3;
}

namespace {

/// The tets met so far, for the usual star of two dozen: a mark per tet of the complex would be out of the cache and
/// not for several threads. Whether a tet is new nobody can foretell, so nothing branches on it.
class SmallStar {
  public:
    SmallStar() { places_.fill(-1); }
    void add(int tet) {
        std::size_t at = static_cast<std::uint32_t>(tet) * 0x9E3779B1u >> 25;
        while (places_[at] >= 0 && places_[at] != tet) at = (at + 1) % places_.size();
        tets_[size_] = tet;
        size_ += places_[at] < 0;
        places_[at] = tet;
    }
    bool has_room() const { return size_ + 3 < tets_.size(); }
    std::size_t size() const { return size_; }
    int operator[](std::size_t i) const { return tets_[i]; }
    std::span<const int> tets() const { return {tets_.data(), size_}; }

  private:
    std::array<int, 128> places_;
    std::array<int, 96> tets_;
    std::size_t size_ = 0;
};

constexpr std::array<std::array<int, 3>, 4> other_faces{{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};

/// From the tets met so far on, of which the first `begin` have been left through all their faces. False where the star
/// is not whole.
bool gather_large_star(const TetComplex& complex, int vertex, std::size_t begin, std::vector<int>& star) {
    for (std::size_t i = begin; i < star.size(); ++i)
        for (const int face : other_faces[corner_of(complex.tets[star[i]], vertex)]) {
            const int next = complex.neighbours[star[i]][face];
            if (next < 0) return false;
            if (std::find(star.begin(), star.end(), next) == star.end()) star.push_back(next);
        }
    return true;
}

}  // namespace

bool gather_star(const TetComplex& complex, int vertex, std::vector<int>& star) {
    star.clear();
    if (complex.tet_of_vertex[vertex] < 0) return false;
    SmallStar met;
    met.add(complex.tet_of_vertex[vertex]);
    std::size_t i = 0;
    for (; i < met.size() && met.has_room(); ++i) {
        const auto& next = complex.neighbours[met[i]];
        for (const int face : other_faces[corner_of(complex.tets[met[i]], vertex)]) {
            if (next[face] < 0) return false;
            met.add(next[face]);
        }
    }
    star.assign(met.tets().begin(), met.tets().end());
    return i == met.size() || gather_large_star(complex, vertex, i, star);
}

void gather_neighbours(const TetComplex& complex, int vertex, std::span<const int> star, std::vector<int>& neighbours) {
    neighbours.clear();
    for (const int t : star) neighbours.insert(neighbours.end(), complex.tets[t].begin(), complex.tets[t].end());
    sort_once(neighbours);
    std::erase(neighbours, vertex);
}

bool is_forced(const TetComplex& complex, int tet, double flatness) {
    std::array<Vec3, 4> normal;
    int count = 0;
    for (int face = 0; face < 4; ++face) {
        if (complex.neighbours[tet][face] >= 0) continue;
        const auto& corner = opposite_face[face];
        const auto at = [&](int k) { return complex.points[complex.tets[tet][corner[k]]]; };
        normal[count++] = normalized(cross(at(1) - at(0), at(2) - at(0)));
    }
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < i; ++j) {
            const double cosine = dot(normal[i], normal[j]);
            if (cosine * cosine >= flatness * (1 - 1e-9)) return true;
        }
    return false;
}

CavityEditor::CavityEditor(TetComplex& complex) : complex_(complex) {
    for (std::size_t t = complex.tets.size(); t-- > 0;)
        if (complex.tets[t][0] < 0) free_slots_.push_back(static_cast<int>(t));
}

int CavityEditor::add_vertex(const Vec3& point) {
    complex_.points.push_back(point);
    complex_.mobility.push_back(Mobility::free);
    complex_.tet_of_vertex.push_back(-1);
    return static_cast<int>(complex_.points.size()) - 1;
}

void CavityEditor::begin_table(std::size_t faces) {
    if (table_.size() < 2 * faces) table_.assign(std::bit_ceil(2 * faces), {});
    if (++table_stamp_ != 0) return;
    for (OpenFace& open : table_) open.stamp = 0;
    table_stamp_ = 1;
}

CavityEditor::OpenFace& CavityEditor::slot_of(const std::array<int, 3>& key) {
    const std::uint32_t hash = static_cast<std::uint32_t>(key[0]) * 0x9E3779B1u ^
                               static_cast<std::uint32_t>(key[1]) * 0x85EBCA77u ^
                               static_cast<std::uint32_t>(key[2]) * 0xC2B2AE3Du;
    const std::size_t last = table_.size() - 1;
    std::size_t at = (hash ^ hash >> 15) & last;
    while (table_[at].stamp == table_stamp_ && table_[at].key != key) at = (at + 1) & last;
    return table_[at];
}

void CavityEditor::file_outside(std::span<const int> removed) {
    // marks of tets here and there are out of the cache: a few tets are compared one by one
    constexpr std::size_t few = 12;
    const bool are_few = removed.size() <= few;
    if (!are_few) {
        begin_marks();
        for (int tet : removed) mark(tet);
    }
    const auto is_removed = [&](int tet) {
        return are_few ? std::find(removed.begin(), removed.end(), tet) != removed.end() : is_marked(tet);
    };
    for (int tet : removed) {
        for (int face = 0; face < 4; ++face) {
            const int next = complex_.neighbours[tet][face];
            if (next >= 0 && is_removed(next)) continue;
            const auto key = sorted_face(complex_.tets[tet], face);
            slot_of(key) = {key, next, next < 0 ? 0 : face_towards(complex_.neighbours[next], tet), table_stamp_};
        }
    }
}

void CavityEditor::clear(std::span<const int> removed) {
    for (int tet : removed) {
        for (int v : complex_.tets[tet]) complex_.tet_of_vertex[v] = -1;
        complex_.tets[tet] = {-1, -1, -1, -1};
        complex_.neighbours[tet] = {-1, -1, -1, -1};
    }
}

void CavityEditor::take_slots(std::span<const int> removed, std::size_t count) {
    added_.assign(removed.begin(), removed.begin() + static_cast<std::ptrdiff_t>(std::min(removed.size(), count)));
    for (std::size_t i = count; i < removed.size(); ++i) free_slots_.push_back(removed[i]);
    while (added_.size() < count) {
        if (!free_slots_.empty()) {
            added_.push_back(free_slots_.back());
            free_slots_.pop_back();
            continue;
        }
        added_.push_back(static_cast<int>(complex_.tets.size()));
        complex_.tets.push_back({-1, -1, -1, -1});
        complex_.neighbours.push_back({-1, -1, -1, -1});
        if (!complex_.regions.empty()) complex_.regions.push_back(-1);
    }
}

void CavityEditor::link(int tet, int face) {
    const auto key = sorted_face(complex_.tets[tet], face);
    OpenFace& open = slot_of(key);
    if (open.stamp != table_stamp_) {
        open = {key, tet, face, table_stamp_};
        return;
    }
    complex_.neighbours[tet][face] = open.tet;
    if (open.tet >= 0) complex_.neighbours[open.tet][open.face] = tet;
}

std::span<const int> CavityEditor::replace(std::span<const int> removed, std::span<const Tet> added) {
    assert(!removed.empty());
    begin_table(4 * (removed.size() + added.size()));
    file_outside(removed);
    const int region = complex_.regions.empty() ? -1 : complex_.regions[removed[0]];
    clear(removed);
    take_slots(removed, added.size());
    for (std::size_t i = 0; i < added.size(); ++i) {
        complex_.tets[added_[i]] = added[i];
        if (!complex_.regions.empty()) complex_.regions[added_[i]] = region;
        for (int v : added[i]) complex_.tet_of_vertex[v] = added_[i];
    }
    for (int tet : added_)
        for (int face = 0; face < 4; ++face) link(tet, face);
    return added_;
}

}  // namespace featuremesh
