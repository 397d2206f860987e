// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_parameters.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>

namespace featuremesh {

namespace {

using Uv = std::array<double, 2>;

/// The point of the edge's curve in the face's parameters, at a parameter or (0 or 1) at an end.
std::optional<Uv> on_edge(const Brep& brep, EdgeId edge, FaceId face, double t, bool is_end = false) {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(brep.edge(edge), brep.face(face), first, last);
    if (curve.IsNull()) return std::nullopt;
    const gp_Pnt2d p = curve->Value(is_end ? (t > 0 ? last : first) : std::clamp(t, first, last));
    return Uv{p.X(), p.Y()};
}

}  // namespace

std::optional<Uv> parameters_on(const Brep& brep, FaceId face, const Mesh& mesh, NodeId node) {
    const Entity entity = mesh.entities[node.index()];
    if (entity == entity_of(face)) return mesh.parameters[node.index()];
    if (entity.dim == 1) return on_edge(brep, EdgeId(entity.index), face, mesh.parameters[node.index()][0]);
    if (entity.dim != 0) return std::nullopt;
    for (const EdgeId edge : brep.edges_of(VertexId(entity.index)))
        if (const auto faces = brep.faces_of(edge); std::find(faces.begin(), faces.end(), face) != faces.end())
            return on_edge(brep, edge, face, brep.ends_of(edge)[0] == VertexId(entity.index) ? 0 : 1, true);
    return std::nullopt;
}

}  // namespace featuremesh
