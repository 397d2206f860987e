// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/wall_rays.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <optional>

#include "brep/occt_geometry.h"

namespace featuremesh {
namespace {

constexpr std::size_t triangles_per_leaf = 4;
/// Walls are opposite when their normals are less than 45 degrees from it.
constexpr double opposite_cosine = 0.7;

/// Where along the ray the box begins; none when the ray misses it before `limit`.
std::optional<double> entry(const Box& box, const Vec3& origin, const Vec3& direction, double limit) {
    double from = 0, to = limit;
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1.0 / direction[axis];
        double near = (box.low[axis] - origin[axis]) * inverse, far = (box.high[axis] - origin[axis]) * inverse;
        if (near > far) std::swap(near, far);
        if (near > from) from = near;
        if (far < to) to = far;
    }
    return from <= to ? std::optional<double>(from) : std::nullopt;
}

/// Moeller and Trumbore 1997.
std::optional<double> hit(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& origin, const Vec3& direction) {
    const Vec3 u = b - a, v = c - a, p = cross(direction, v);
    const double determinant = dot(u, p);
    if (determinant == 0) return std::nullopt;
    const Vec3 s = origin - a;
    const double alpha = dot(s, p) / determinant;
    const Vec3 q = cross(s, u);
    const double beta = dot(direction, q) / determinant;
    // a little tolerance so that no ray slips between two triangles
    constexpr double slack = 1e-9;
    if (alpha < -slack || beta < -slack || alpha + beta > 1 + slack) return std::nullopt;
    return dot(v, q) / determinant;
}

}  // namespace

WallRays::WallRays(const Brep& brep, double deflection)
    : diagonal_(brep.box().diagonal()), deflection_(deflection), neighbours_(brep.face_count()) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(brep.shape(), false, false).Shape();
    const BRepMesh_IncrementalMesh mesher(copy, deflection, false, 0.35, false);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(copy, TopAbs_FACE, faces);
    for (int f = 1; f <= faces.Extent(); ++f) {
        TopLoc_Location place;
        const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(TopoDS::Face(faces(f)), place);
        if (part.IsNull()) continue;
        const auto point = [&](int i) { return to_vec3(part->Node(i).Transformed(place.Transformation())); };
        for (int t = 1; t <= part->NbTriangles(); ++t) {
            int i, j, k;
            part->Triangle(t).Get(i, j, k);
            if (faces(f).Orientation() == TopAbs_REVERSED) std::swap(j, k);
            triangles_.push_back({point(i), point(j), point(k), FaceId(f - 1)});
        }
    }
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        const auto solids = brep.solids_beside(FaceId(f));
        is_between_solids_.push_back(solids[0].is_valid() && solids[1].is_valid());
        for (const EdgeId edge : brep.edges_of(FaceId(f)))
            for (const FaceId other : brep.faces_of(edge))
                if (other != FaceId(f)) neighbours_[f].push_back(other);
    }
    if (!triangles_.empty()) build(0, triangles_.size());
}

std::int32_t WallRays::build(std::size_t begin, std::size_t end) {
    Box box;
    for (std::size_t i = begin; i < end; ++i)
        box.add(triangles_[i].a), box.add(triangles_[i].b), box.add(triangles_[i].c);
    const auto index = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({box, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end - begin)});
    if (end - begin <= triangles_per_leaf) return index;
    const Vec3 extent = box.size();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto middle = begin + (end - begin) / 2;
    const auto center = [axis](const Triangle& t) { return t.a[axis] + t.b[axis] + t.c[axis]; };
    std::nth_element(triangles_.begin() + static_cast<std::ptrdiff_t>(begin),
                     triangles_.begin() + static_cast<std::ptrdiff_t>(middle),
                     triangles_.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](const Triangle& s, const Triangle& t) { return center(s) < center(t); });
    build(begin, middle);
    const std::int32_t second = build(middle, end);
    nodes_[static_cast<std::size_t>(index)].first = second;
    nodes_[static_cast<std::size_t>(index)].count = 0;
    return index;
}

bool WallRays::is_neighbour(FaceId a, FaceId b) const {
    const auto& near = neighbours_[a.index()];
    return std::find(near.begin(), near.end(), b) != near.end();
}

double WallRays::thickness(FaceId face, const Vec3& point, const Vec3& direction, double limit) const {
    double nearest = limit;
    bool is_wall = false;
    std::vector<std::int32_t> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
        const std::int32_t n = open.back();
        open.pop_back();
        const Node& node = nodes_[static_cast<std::size_t>(n)];
        if (!entry(node.box.grown(1e-9 * diagonal_), point, direction, nearest)) continue;
        if (node.count == 0) {
            open.push_back(node.first);
            open.push_back(n + 1);
            continue;
        }
        for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
            const Triangle& triangle = triangles_[static_cast<std::size_t>(i)];
            const auto t = hit(triangle.a, triangle.b, triangle.c, point, direction);
            if (!t || *t >= nearest || *t <= 1e-9 * diagonal_) continue;
            const double cosine = dot(normalized(cross(triangle.b - triangle.a, triangle.c - triangle.a)), direction);
            // the ray begins in the material: what it seems to enter is a chord of the face it comes from
            const bool is_exit =
                is_between_solids_[triangle.face.index()] ? triangle.face != face || *t > 2 * deflection_ : cosine > 0;
            if (!is_exit) continue;
            nearest = *t;
            is_wall = std::abs(cosine) > opposite_cosine && !is_neighbour(face, triangle.face);
        }
    }
    return is_wall ? nearest : limit;
}

}  // namespace featuremesh
