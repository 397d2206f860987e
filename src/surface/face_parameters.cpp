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

/// The edge's curve in the face and its range; null where there is none.
struct Trace {
    Trace(const Brep& brep, FaceId face, EdgeId edge)
        : curve(BRep_Tool::CurveOnSurface(brep.edge(edge), brep.face(face), first, last)) {}
    std::optional<Uv> at(double t) const {
        if (curve.IsNull()) return std::nullopt;
        const gp_Pnt2d p = curve->Value(t);
        return Uv{p.X(), p.Y()};
    }
    double first = 0, last = 0;
    Handle(Geom2d_Curve) curve;
};

}  // namespace

std::optional<Uv> parameters_on(const Brep& brep, FaceId face, EdgeId edge, double t) {
    const Trace trace(brep, face, edge);
    return trace.at(std::clamp(t, trace.first, trace.last));
}

std::optional<Uv> parameters_on(const Brep& brep, FaceId face, const Mesh& mesh, NodeId node) {
    const Entity entity = mesh.entities[node.index()];
    if (entity == entity_of(face)) return mesh.parameters[node.index()];
    if (entity.dim == 1) return parameters_on(brep, face, EdgeId(entity.index), mesh.parameters[node.index()][0]);
    if (entity.dim != 0) return std::nullopt;
    for (const EdgeId edge : brep.edges_of(VertexId(entity.index)))
        if (const auto faces = brep.faces_of(edge); std::find(faces.begin(), faces.end(), face) != faces.end()) {
            const Trace trace(brep, face, edge);
            return trace.at(brep.ends_of(edge)[0] == VertexId(entity.index) ? trace.first : trace.last);
        }
    return std::nullopt;
}

}  // namespace featuremesh
