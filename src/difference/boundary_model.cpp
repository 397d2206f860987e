// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/boundary_model.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <cmath>
#include <numbers>

namespace featuremesh {

namespace {
// An arc reaches furthest at its ends or where the whole circle or ellipse does.
Box box_of_edge(const BoundaryEdge& edge, const TopoDS_Edge& shape) {
    const UnderlyingCurve& curve = edge.curve;
    if (curve.kind == CurveKind::free_form) return box_of(shape);
    Box box;
    box.add(edge.first), box.add(edge.last);
    if (curve.kind == CurveKind::line) return box;
    const double across = curve.kind == CurveKind::ellipse ? curve.second : curve.radius;
    for (int axis = 1; axis <= 3; ++axis) {
        const double furthest = std::atan2(across * curve.position.YDirection().Coord(axis),
                                           curve.radius * curve.position.XDirection().Coord(axis));
        for (const double parameter : {furthest, furthest + std::numbers::pi}) {
            const double turn = 2 * std::numbers::pi;
            const double in_range = parameter + turn * std::ceil((curve.first - parameter) / turn);
            if (in_range < curve.last) box.add(point_at(curve, in_range));
        }
    }
    return box;
}
}  // namespace

BoundaryModel::BoundaryModel(const Brep& brep) : brep_(brep), trims_(brep.face_count()) {
    for (std::size_t e = 0; e < brep.edge_count(); ++e) take_edge(EdgeId(e));
    for (std::size_t f = 0; f < brep.face_count(); ++f) take_face(FaceId(f));
}

void BoundaryModel::take_edge(EdgeId id) {
    BoundaryEdge edge;
    edge.is_degenerated = brep_.is_degenerated(id);
    if (!edge.is_degenerated) {
        edge.curve = underlying_of(brep_.edge(id));
        edge.first = point_at(edge.curve, edge.curve.first);
        edge.last = point_at(edge.curve, edge.curve.last);
        edge.box = box_of_edge(edge, brep_.edge(id));
    }
    edges_.push_back(std::move(edge));
}

void BoundaryModel::take_face(FaceId id) {
    BoundaryFace face;
    face.underlying = underlying_of(brep_.face(id));
    for (const FaceEdge& use : brep_.uses_in(id))
        if (!edges_[use.edge.index()].is_degenerated)
            face.uses.push_back({use.edge, use.is_forward, use.is_internal || use.is_external});
    const auto [behind, before] = brep_.solids_beside(id);
    face.material_behind = behind.is_valid();
    face.material_before = before.is_valid();
    face.box = box_of_face(face, id);
    find_sense(id, face);
    faces_.push_back(std::move(face));
}

// A point of a plane, a cylinder or a cone lies between two points of the border, so the edges' box holds the face.
Box BoundaryModel::box_of_face(const BoundaryFace& face, FaceId id) const {
    const UnderlyingSurface& c = face.underlying;
    if (c.kind == SurfaceKind::free_form) return brep_.box_of(id);
    Box box;
    if (c.kind == SurfaceKind::sphere || c.kind == SurfaceKind::torus) {
        box.add(to_vec3(c.position.Location()));
        return box.grown(c.radius + c.second);
    }
    for (const EdgeUse& use : face.uses) box.add(edges_[use.edge.index()].box);
    for (const EdgeId e : brep_.edges_of(id))
        for (const VertexId v : brep_.ends_of(e))
            if (v.is_valid()) box.add(brep_.point_of(v));
    return box;
}

void BoundaryModel::find_sense(FaceId id, BoundaryFace& face) const {
    const TopoDS_Face& shape = brep_.face(id);
    for (const EdgeUse& use : face.uses) {
        double first = 0, last = 0;
        const Handle(Geom2d_Curve) trace = BRep_Tool::CurveOnSurface(brep_.edge(use.edge), shape, first, last);
        if (trace.IsNull()) continue;
        const gp_Pnt2d uv = trace->Value(0.4 * first + 0.6 * last);
        gp_Pnt point;
        gp_Vec du, dv;
        face.underlying.surface->D1(uv.X(), uv.Y(), point, du, dv);
        point.Transform(face.underlying.placement);
        const gp_Vec normal = du.Crossed(dv).Transformed(face.underlying.placement);
        if (normal.Magnitude() <= 1e-12 * (du.Magnitude() * dv.Magnitude())) continue;
        const double along = dot(to_vec3(normal), outward_at(face.underlying, to_vec3(point), to_vec3(normal)));
        face.normal_is_outward = (along > 0) == (shape.Orientation() != TopAbs_REVERSED);
        return;
    }
}

Containment BoundaryModel::classify(FaceId face, std::array<double, 2> uv) const {
    std::optional<FaceTrim>& trim = trims_[face.index()];
    if (!trim) trim.emplace(brep_.face(face));
    return trim->containment_of(uv[0], uv[1]);
}

}  // namespace featuremesh
