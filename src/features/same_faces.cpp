// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/same_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "features/occt_geometry.h"

namespace featuremesh {

namespace {

std::vector<TopoDS_Face> faces_of_solids(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
        for (TopExp_Explorer it(solid.Current(), TopAbs_FACE); it.More(); it.Next())
            faces.push_back(TopoDS::Face(it.Current()));
    return faces;
}

/// Numbers that do not depend on the order of a face's edges nor on their direction.
struct Signature {
    int kind = 0, points = 0;
    std::array<double, 13> moments{};  // first and second of the border points, normal and inner point

    explicit Signature(const TopoDS_Face& face) {
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) add_edge(TopoDS::Edge(it.Current()));
        const BRepAdaptor_Surface surface(face, false);
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        BRepTools::UVBounds(face, u1, u2, v1, v2);
        const double u = (u1 + u2) / 2, v = (v1 + v2) / 2;
        const Vec3 p = to_vec3(surface.Value(u, v)), n = outward_normal(surface, face, u, v);
        kind = static_cast<int>(surface.GetType());
        add(p);
        for (int i = 0; i < 3; ++i) moments[9 + i] = n[i];
        moments[12] = p.x + 2 * p.y + 3 * p.z;
    }

    bool matches(const Signature& other, double size) const {
        if (kind != other.kind || points != other.points) return false;
        const double first = 1e-9 * size * points, second = first * size;
        for (int i = 0; i < 13; ++i) {
            const double tolerance = i < 3 ? first : i < 9 ? second : i < 12 ? 1e-6 : first;
            if (std::abs(moments[i] - other.moments[i]) > tolerance) return false;
        }
        return true;
    }

  private:
    void add_edge(const TopoDS_Edge& edge) {
        const BRepAdaptor_Curve curve(edge);
        if (!curve.Is3DCurve() && !curve.IsCurveOnSurface()) return;
        const double first = curve.FirstParameter(), last = curve.LastParameter();
        for (const double share : {0.0, 0.25, 0.75, 1.0}) add(to_vec3(curve.Value(first + share * (last - first))));
    }
    void add(const Vec3& p) {
        const std::array<double, 9> terms{p.x,       p.y,       p.z,       p.x * p.x, p.y * p.y,
                                          p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x};
        for (int i = 0; i < 9; ++i) moments[i] += terms[i];
        ++points;
    }
};

/// Signatures along the first moment, so that a face is compared with its few neighbours there only.
class SignatureIndex {
  public:
    explicit SignatureIndex(const std::vector<TopoDS_Face>& faces) {
        for (const TopoDS_Face& face : faces) {
            sorted_.emplace_back(face);
            box_.add(box_of(face));
        }
        std::sort(sorted_.begin(), sorted_.end(),
                  [](const Signature& a, const Signature& b) { return a.moments[0] < b.moments[0]; });
        size_ = std::max({box_.diagonal(), std::abs(box_.low.x), std::abs(box_.low.y), std::abs(box_.low.z)});
    }

    bool has(const Signature& wanted) const {
        const double reach = 1e-9 * size_ * wanted.points;
        auto it = std::lower_bound(sorted_.begin(), sorted_.end(), wanted.moments[0] - reach,
                                   [](const Signature& s, double x) { return s.moments[0] < x; });
        for (; it != sorted_.end() && it->moments[0] <= wanted.moments[0] + reach; ++it)
            if (it->matches(wanted, size_)) return true;
        return false;
    }

  private:
    std::vector<Signature> sorted_;
    Box box_;
    double size_ = 0;
};

}  // namespace

std::vector<TopoDS_Shape> unshared_faces(const TopoDS_Shape& shape, const TopoDS_Shape& other) {
    const std::vector<TopoDS_Face> faces = faces_of_solids(shape), other_faces = faces_of_solids(other);
    TopTools_IndexedMapOfShape others;
    for (const TopoDS_Face& face : other_faces) others.Add(face);
    std::vector<TopoDS_Face> left;
    for (const TopoDS_Face& face : faces) {
        const int index = others.FindIndex(face);
        if (index == 0 || others(index).Orientation() != face.Orientation()) left.push_back(face);
    }
    if (left.empty() || other_faces.empty()) return {left.begin(), left.end()};
    const SignatureIndex index(other_faces);
    std::erase_if(left, [&](const TopoDS_Face& face) { return index.has(Signature(face)); });
    return {left.begin(), left.end()};
}

}  // namespace featuremesh
