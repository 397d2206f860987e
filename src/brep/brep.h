// SPDX-License-Identifier: GPL-3.0-or-later
// The final shape as numbered entities with their adjacency.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/dimension.h"
#include "core/entity_names.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/tolerances.h"

class TopoDS_Shape;
class TopoDS_Solid;
class TopoDS_Face;
class TopoDS_Edge;
class TopoDS_Vertex;

namespace featuremesh {

/// An edge in the wires of a face.
struct FaceEdge {
    EdgeId edge;
    bool is_forward = true;                         ///< against the face as it is oriented in the shape
    bool is_internal = false, is_external = false;  ///< drawn into the face, or beside it: no border
};

/// What `shape` is to be meshed as where nothing else is asked for.
Dimension dimension_of(const TopoDS_Shape& shape);

/// Solids, faces or edges, with faces, edges and vertices numbered as FreeCAD numbers them (TopExp order, 0 is
/// "Face1"). Cheap to copy; never changes.
class Brep {
  public:
    /// Takes the shape's solids, or its faces, or its edges: then it has no solids, whatever the shape has. From the
    /// shape it takes faces without a solid and edges without a face beside solids, and those edges beside faces.
    /// Throws InputError with the name of what is wrong (no solid, an open shell).
    explicit Brep(const TopoDS_Shape& shape, Dimension dimension = Dimension::solids);

    Dimension dimension() const;  ///< never `from_shape`
    const TopoDS_Shape& shape() const;
    std::size_t solid_count() const;
    std::size_t face_count() const;
    std::size_t edge_count() const;
    std::size_t vertex_count() const;
    const TopoDS_Solid& solid(SolidId id) const;
    const TopoDS_Face& face(FaceId id) const;  ///< oriented as it is first met in the shape
    const TopoDS_Edge& edge(EdgeId id) const;  ///< oriented forward
    const TopoDS_Vertex& vertex(VertexId id) const;

    /// Ids from entities of this very shape (orientation ignored); none for others.
    FaceId find(const TopoDS_Face& face) const;
    EdgeId find(const TopoDS_Edge& edge) const;
    VertexId find(const TopoDS_Vertex& vertex) const;

    std::span<const EdgeId> edges_of(FaceId face) const;      ///< each once
    std::span<const FaceEdge> uses_in(FaceId face) const;     ///< as its wires have them; a seam twice
    std::span<const FaceId> faces_of(EdgeId edge) const;      ///< each once
    std::span<const EdgeId> edges_of(VertexId vertex) const;  ///< each once
    /// The face's own vertices, beside those of its edges: where something touches it in a point.
    std::span<const VertexId> vertices_inside(FaceId face) const;
    /// First and last vertex by edge parameter; equal on a closed edge.
    std::array<VertexId, 2> ends_of(EdgeId edge) const;
    /// Solid behind (against the face's normal) and before it; none for outside.
    std::array<SolidId, 2> solids_beside(FaceId face) const;
    const std::vector<std::array<SolidId, 2>>& solids_beside_faces() const;  ///< by face
    /// What the face belongs to: the solids beside it, or its sheet, which is all faces joined by edges.
    std::array<BodyId, 2> bodies_of(FaceId face) const;
    std::size_t body_count() const;
    bool is_meshed(FaceId face) const;
    bool is_meshed(EdgeId edge) const;
    bool is_free(FaceId face) const;  ///< meshed, and bounds no solid: its triangles are shells
    bool is_free(EdgeId edge) const;  ///< meshed, and of no meshed face: its segments are beams
    bool has_free_faces() const;
    bool has_free_edges() const;
    /// The faces that what lies on a vertex, edge or face lies on; ascending. None for a solid.
    std::vector<FaceId> faces_at(Entity entity) const;
    bool is_degenerated(EdgeId edge) const;  ///< a pole: no length in space
    bool is_seam(EdgeId edge, FaceId face) const;

    Vec3 point_of(VertexId vertex) const;  ///< within its tolerance where its edges end (vertex_places)
    /// From that point, or from the kernel's own, where other meshers put the node.
    double distance_from(VertexId vertex, const Vec3& p) const;
    const Box& box_of(FaceId face) const;  ///< holds it, not the tightest
    const Box& box_of(EdgeId edge) const;  ///< the same; empty for a pole
    const Box& box() const;                ///< exact enough for sizes, not for topology
    Tolerances tolerances() const;
    double volume_of(SolidId solid) const;  ///< mm^3
    double volume() const;                  ///< of all solids, mm^3; what they share counts twice

  private:
    struct Data;
    std::shared_ptr<const Data> data_;
};

}  // namespace featuremesh
