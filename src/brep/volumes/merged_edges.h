// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of faces of two shapes, cut where one has a vertex on an edge of the other, each piece once.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <array>
#include <optional>
#include <vector>

#include "brep/volumes/patch_faces.h"
#include "core/geometry.h"

namespace featuremesh {

/// Vertices count as one within their tolerances, pieces of edges with the same ends and the same two points between.
/// Of equal ones that of the first face stands for all. Edges are not intersected: where two of them cross, nothing is
/// cut. Throws Standard_Failure where an edge cannot be worked with.
class MergedEdges {
  public:
    /// A stretch of an edge between two vertices along the edge's own parameters.
    struct Piece {
        int edge = 0;
        double first = 0, last = 0;
        std::array<int, 2> ends{};                 ///< vertices at `first` and `last`
        int merged = 0;                            ///< the piece that stands for it; often itself
        bool turned = false;                       ///< runs against the piece that stands for it
        std::optional<std::array<Vec3, 2>> inner;  ///< points at a quarter and three; none of a degenerated edge
    };
    /// A piece in the border of a face.
    struct Use {
        TopoDS_Edge edge;  ///< whole, as oriented in the face when that is oriented forward
        int own = 0;       ///< the piece of that edge
        int piece = 0;     ///< the one that stands for it
        int sense = 1;     ///< along `piece` or against it, in the face oriented forward
    };
    using Wire = std::vector<Use>;

    explicit MergedEdges(const std::vector<PatchFace>& faces);

    const std::vector<Wire>& wires_of(std::size_t face) const { return wires_[face]; }
    const Piece& piece(int index) const { return pieces_[std::size_t(index)]; }
    std::size_t piece_count() const { return pieces_.size(); }
    /// The edge that a piece is a stretch of, oriented forward.
    const TopoDS_Edge& edge_of(const Piece& piece) const { return edges_[std::size_t(piece.edge)].edge; }
    bool is_whole(const Piece& piece) const { return edges_[std::size_t(piece.edge)].pieces.size() == 1; }
    bool is_degenerated(const Piece& piece) const { return !piece.inner; }
    const TopoDS_Shape& vertex(int index) const { return vertices_(index + 1); }
    const Vec3& position(int vertex) const { return places_[std::size_t(vertex)].point; }

  private:
    struct Place {
        Vec3 point;
        double tolerance = 0;
        int merged = 0;
        bool is_of[2] = {false, false};  ///< faces that appeared, that vanished
    };
    struct Edge {
        TopoDS_Edge edge;
        std::array<int, 2> ends{};
        bool is_of[2] = {false, false};
        std::vector<int> pieces;  ///< in the order of its parameters
    };

    void collect(const std::vector<PatchFace>& faces);
    int add_edge(const TopoDS_Edge& edge, bool vanished);
    void merge_vertices();
    void cut(int index, const std::vector<int>& others);
    std::vector<std::pair<double, int>> cuts_of(const Edge& edge, const std::vector<int>& others) const;
    void merge_pieces();
    void resolve_uses();

    TopTools_IndexedMapOfShape edge_numbers_, vertices_;
    std::vector<Edge> edges_;
    std::vector<Place> places_;
    std::vector<Piece> pieces_;
    std::vector<std::vector<Wire>> wires_;
};

}  // namespace featuremesh
