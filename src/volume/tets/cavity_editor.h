// SPDX-License-Identifier: GPL-3.0-or-later
// The one way in which connectivity changes: a set of tets is replaced by others with the same outside. And the queries
// that plan it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_marks.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

/// The tets round an inner edge: tet i is (from, to, vertices[i], vertices[i+1]), in an even permutation.
struct EdgeRing {
    static constexpr int max_size = 10;
    int from = -1, to = -1, size = 0;
    std::array<int, max_size> vertices{}, tets{};
    std::span<const int> all_tets() const { return {tets.data(), static_cast<std::size_t>(size)}; }
};

/// A walk round an edge, from tet to tet: `vertex` is the corner that is left behind, so that (from, to, vertex, the
/// next vertex) is an even permutation.
class RingWalk {
  public:
    RingWalk(const TetComplex& complex, int tet, int from_corner, int to_corner);
    int tet() const { return tet_; }
    int vertex() const { return complex_.tets[tet_][behind_]; }
    int next_vertex() const { return complex_.tets[tet_][ahead_]; }
    /// False at the boundary, where it stays.
    bool step();

  private:
    const TetComplex& complex_;
    int tet_, from_, to_, behind_, ahead_;
};

/// False where the edge (two corners of the tet) is on the boundary or has more than max_size tets.
bool find_ring(const TetComplex& complex, int tet, int from_corner, int to_corner, EdgeRing& ring);

/// All tets of a vertex that is inside. False, with some of them, when it lies on the boundary or has no tet.
bool gather_star(const TetComplex& complex, int vertex, std::vector<int>& star);
/// The other corners of a vertex's star, ascending.
void gather_neighbours(const TetComplex& complex, int vertex, std::span<const int> star, std::vector<int>& neighbours);

/// The worst angle of a tet of this flatness lies between two boundary triangles: no operation can change it.
bool is_forced(const TetComplex& complex, int tet, double flatness);

/// Works on one complex; keeps its marks, free slots and scratch memory between operations.
class CavityEditor {
  public:
    explicit CavityEditor(TetComplex& complex);

    /// Takes `removed` out and puts `added` in, which must have the same outside. Gives the ids of the added tets
    /// (slots are used again). Vertices that lose their last tet get tet_of_vertex -1. The result is valid until the
    /// next call and may not be passed to it.
    std::span<const int> replace(std::span<const int> removed, std::span<const Tet> added);

    /// Appends a free vertex without a tet.
    int add_vertex(const Vec3& point);

    /// Marks of tets, all cleared by begin_marks.
    void begin_marks() { marks_.begin(complex_.tets.size()); }
    void mark(int tet) { marks_.mark(tet); }
    bool is_marked(int tet) const { return marks_.is_marked(tet); }

  private:
    /// A triangle that waits for the tet beyond it.
    struct OpenFace {
        std::array<int, 3> key{};
        int tet = -1, face = 0;  // -1 at the boundary
        std::uint32_t stamp = 0;
    };
    void begin_table(std::size_t faces);
    OpenFace& slot_of(const std::array<int, 3>& key);
    void file_outside(std::span<const int> removed);
    void clear(std::span<const int> removed);
    void take_slots(std::span<const int> removed, std::size_t count);
    void link(int tet, int face);

    TetComplex& complex_;
    TetMarks marks_;
    std::uint32_t table_stamp_ = 0;
    std::vector<int> free_slots_, added_;
    std::vector<OpenFace> table_;
};

}  // namespace featuremesh
