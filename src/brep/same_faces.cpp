// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/same_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "brep/occt_geometry.h"
#include "core/geometry.h"

namespace featuremesh {

namespace {

std::vector<TopoDS_Face> faces_of_solids(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
        for (TopExp_Explorer it(solid.Current(), TopAbs_FACE); it.More(); it.Next())
            faces.push_back(TopoDS::Face(it.Current()));
    return faces;
}

/// What does not depend on the order of a face's edges nor on their direction: sums over points of its border, and
/// where these agree, as they do after a turn of a regular polygon on the spot, the points. What is inside the border
/// costs most and is only looked at where the borders agree.
class Signature {
  public:
    explicit Signature(const TopoDS_Face& face) : face_(face), kind_(BRepAdaptor_Surface(face, false).GetType()) {
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) add_edge(TopoDS::Edge(it.Current()));
        std::sort(border_.begin(), border_.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
    }

    double key() const { return moments_[0]; }
    /// Of the points of its border.
    const Box& box() const { return box_; }
    /// How far the keys of equal faces in a shape of that size may be apart.
    double reach(double size) const { return 1e-9 * size * double(border_.size()); }

    bool matches(const Signature& other, double size) const {
        if (kind_ != other.kind_ || border_.size() != other.border_.size()) return false;
        for (std::size_t i = 0; i < moments_.size(); ++i)
            if (std::abs(moments_[i] - other.moments_[i]) > reach(size) * (i < 3 ? 1 : size)) return false;
        const auto is_near_other = [&](const Vec3& p) { return other.has_point_near(p, reach(size)); };
        if (!std::all_of(border_.begin(), border_.end(), is_near_other)) return false;
        const auto& [p, n] = inner();
        const auto& [q, m] = other.inner();
        for (int i = 0; i < 3; ++i)
            if (std::abs(n[i] - m[i]) > 1e-6 || std::abs(p[i] - q[i]) > reach(size) + 1e-9 * size) return false;
        return true;
    }

  private:
    /// A point of the surface within the range of the face's parameters, and the normal there. Of a plane, which its
    /// border determines, the normal only: the range costs as much as all else.
    const std::pair<Vec3, Vec3>& inner() const {
        if (inner_) return *inner_;
        const BRepAdaptor_Surface surface(face_, false);
        if (surface.GetType() == GeomAbs_Plane) return inner_.emplace(Vec3{}, outward_normal(surface, face_, 0, 0));
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        BRepTools::UVBounds(face_, u1, u2, v1, v2);
        const double u = (u1 + u2) / 2, v = (v1 + v2) / 2;
        return inner_.emplace(to_vec3(surface.Value(u, v)), outward_normal(surface, face_, u, v));
    }
    bool has_point_near(const Vec3& p, double reach) const {
        auto it = std::lower_bound(border_.begin(), border_.end(), p.x - reach,
                                   [](const Vec3& q, double x) { return q.x < x; });
        for (; it != border_.end() && it->x <= p.x + reach; ++it)
            if (std::abs(it->y - p.y) <= reach && std::abs(it->z - p.z) <= reach) return true;
        return false;
    }
    void add_edge(const TopoDS_Edge& edge) {
        const BRepAdaptor_Curve curve(edge);
        if (!curve.Is3DCurve() && !curve.IsCurveOnSurface()) return;
        const double first = curve.FirstParameter(), last = curve.LastParameter();
        for (const double share : {0.0, 0.25, 0.75, 1.0}) add(to_vec3(curve.Value(first + share * (last - first))));
    }
    void add(const Vec3& p) {
        const std::array<double, 9> terms{p.x,       p.y,       p.z,       p.x * p.x, p.y * p.y,
                                          p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x};
        for (std::size_t i = 0; i < terms.size(); ++i) moments_[i] += terms[i];
        border_.push_back(p);
        box_.add(p);
    }

    TopoDS_Face face_;
    int kind_ = 0;
    std::vector<Vec3> border_;  // some of its points, by their x
    Box box_;
    std::array<double, 9> moments_{};  // first and second of the border points
    mutable std::optional<std::pair<Vec3, Vec3>> inner_;
};

/// Signatures along the first moment, so that a face is compared with its few neighbours there only.
class SignatureIndex {
  public:
    explicit SignatureIndex(const std::vector<TopoDS_Face>& faces) {
        Box box;
        for (const TopoDS_Face& face : faces) {
            sorted_.emplace_back(face);
            box.add(sorted_.back().box());
        }
        std::sort(sorted_.begin(), sorted_.end(),
                  [](const Signature& a, const Signature& b) { return a.key() < b.key(); });
        size_ = std::max({box.diagonal(), std::abs(box.low.x), std::abs(box.low.y), std::abs(box.low.z)});
    }

    bool has(const Signature& wanted) const {
        const double reach = wanted.reach(size_);
        auto it = std::lower_bound(sorted_.begin(), sorted_.end(), wanted.key() - reach,
                                   [](const Signature& s, double x) { return s.key() < x; });
        for (; it != sorted_.end() && it->key() <= wanted.key() + reach; ++it)
            if (it->matches(wanted, size_)) return true;
        return false;
    }

  private:
    std::vector<Signature> sorted_;
    double size_ = 0;
};

/// The edges of some faces, known again by identity or, since sharing is lost when a document is saved, by points.
class EdgeIndex {
  public:
    explicit EdgeIndex(const std::vector<TopoDS_Shape>& faces) {
        for (const TopoDS_Shape& face : faces) TopExp::MapShapes(face, TopAbs_EDGE, edges_);
        for (int i = 1; i <= edges_.Extent(); ++i)
            if (const auto points = points_of(TopoDS::Edge(edges_(i)))) sorted_.emplace_back(key_of(*points), *points);
        std::sort(sorted_.begin(), sorted_.end());
        for (const auto& [key, points] : sorted_)
            for (const double x : points) size_ = std::max(size_, std::abs(x));
    }

    bool has(const TopoDS_Edge& edge) const {
        if (edges_.Contains(edge)) return true;
        const auto wanted = points_of(edge);
        if (!wanted) return false;
        const double close = 1e-9 * size_, key = key_of(*wanted);
        auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{key - 4 * close, Points{}});
        for (; it != sorted_.end() && it->first <= key + 4 * close; ++it)
            if (are_near(it->second, *wanted, close) || are_near(it->second, turned(*wanted), close)) return true;
        return false;
    }

  private:
    using Points = std::array<double, 12>;

    static std::optional<Points> points_of(const TopoDS_Edge& edge) {
        const BRepAdaptor_Curve curve(edge);
        if (!curve.Is3DCurve() && !curve.IsCurveOnSurface()) return std::nullopt;
        const double first = curve.FirstParameter(), last = curve.LastParameter();
        Points points;
        std::size_t i = 0;
        for (const double share : {0.0, 0.25, 0.75, 1.0}) {
            const Vec3 p = to_vec3(curve.Value(first + share * (last - first)));
            for (const double x : {p.x, p.y, p.z}) points[i++] = x;
        }
        return points;
    }
    /// The same for both directions.
    static double key_of(const Points& p) { return (p[0] + p[9]) + (p[3] + p[6]); }
    static Points turned(const Points& p) {
        return {p[9], p[10], p[11], p[6], p[7], p[8], p[3], p[4], p[5], p[0], p[1], p[2]};
    }
    static bool are_near(const Points& a, const Points& b, double close) {
        for (std::size_t i = 0; i < a.size(); ++i)
            if (std::abs(a[i] - b[i]) > close) return false;
        return true;
    }

    TopTools_IndexedMapOfShape edges_;
    std::vector<std::pair<double, Points>> sorted_;
    double size_ = 0;
};

bool is_simple(const TopoDS_Shape& wire) {
    for (TopExp_Explorer it(wire, TopAbs_EDGE); it.More(); it.Next())
        if (BRepAdaptor_Curve(TopoDS::Edge(it.Current())).GetType() > GeomAbs_Parabola) return false;
    return true;
}

TopoDS_Face without_common_holes(const TopoDS_Face& face, const EdgeIndex& others) {
    std::vector<std::pair<double, TopoDS_Shape>> wires;  // with their sizes: the largest is the outer border
    for (TopoDS_Iterator it(face); it.More(); it.Next()) {
        if (it.Value().ShapeType() != TopAbs_WIRE || !is_simple(it.Value())) return face;
        wires.emplace_back(box_of(it.Value()).diagonal(), it.Value());
    }
    if (wires.size() < 2) return face;
    std::stable_sort(wires.begin(), wires.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    TopoDS_Face simpler = TopoDS::Face(face.EmptyCopied());
    const BRep_Builder builder;
    for (const auto& wire : wires) {
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(wire.second, TopAbs_EDGE, edges);
        bool is_common = &wire != &wires.front();
        for (int i = 1; i <= edges.Extent() && is_common; ++i) is_common = others.has(TopoDS::Edge(edges(i)));
        if (!is_common) builder.Add(simpler, wire.second);
    }
    return simpler;
}

}  // namespace

std::vector<TopoDS_Shape> without_common_holes(const std::vector<TopoDS_Shape>& faces,
                                               const std::vector<TopoDS_Shape>& others) {
    const EdgeIndex edges(others);
    std::vector<TopoDS_Shape> simpler;
    for (const TopoDS_Shape& shape : faces) {
        const TopoDS_Face& face = TopoDS::Face(shape);
        const bool is_plane = BRepAdaptor_Surface(face, false).GetType() == GeomAbs_Plane;
        simpler.push_back(is_plane ? without_common_holes(face, edges) : face);
    }
    return simpler;
}

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

ChangeOutline::ChangeOutline(const std::vector<TopoDS_Shape>& vanished, const std::vector<TopoDS_Shape>& appeared) {
    vanished_ = faces_of(vanished, appeared, size_);
    appeared_ = faces_of(appeared, vanished, size_);
}

std::vector<ChangeOutline::Face> ChangeOutline::faces_of(const std::vector<TopoDS_Shape>& faces,
                                                         const std::vector<TopoDS_Shape>& others, double& size) {
    const EdgeIndex left_out(others);
    std::vector<Face> list;
    for (const TopoDS_Shape& shape : faces) {
        const TopoDS_Face& face = TopoDS::Face(shape);
        const BRepAdaptor_Surface surface(face, false);
        Face& outline = list.emplace_back();
        outline.kind = static_cast<int>(surface.GetType());
        const auto add_point = [&](const Vec3& p, const Vec3& n) {
            const std::array<double, 12> terms{p.x,       p.y,       p.z,       p.x * p.x, p.y * p.y, p.z * p.z,
                                               p.x * p.y, p.y * p.z, p.z * p.x, n.x,       n.y,       n.z};
            for (std::size_t i = 0; i < terms.size(); ++i) outline.moments[i] += terms[i];
            ++outline.points;
            size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        };
        const auto add = [&](double u, double v) {
            gp_Pnt point;
            gp_Vec du, dv;
            surface.D1(u, v, point, du, dv);
            add_point(to_vec3(point), outward_normal(face, du, dv));
        };
        const bool is_plane = surface.GetType() == GeomAbs_Plane;
        const Vec3 plane_normal = is_plane ? outward_normal(surface, face, 0, 0) : Vec3{};
        const auto add_edge = [&](const auto& curve, auto&& add_at) {
            const double first = curve.FirstParameter(), last = curve.LastParameter();
            for (const double share : {0.0, 0.25, 0.75, 1.0}) add_at(curve.Value(first + share * (last - first)));
        };
        const auto add_edges = [&](auto&& is_left_out) {
            for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
                const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
                if (is_left_out(edge)) continue;
                // On a plane the kernel would have to make the curve of parameters first.
                if (const BRepAdaptor_Curve curve(edge); is_plane && curve.Is3DCurve())
                    add_edge(curve, [&](const gp_Pnt& p) { add_point(to_vec3(p), plane_normal); });
                else
                    add_edge(BRepAdaptor_Curve2d(edge, face), [&](const gp_Pnt2d& uv) { add(uv.X(), uv.Y()); });
            }
        };
        add_edges([&](const TopoDS_Edge& edge) { return left_out.has(edge); });
        // Between the edges of faces of the other kind only the surface matters: what a pocket left of a face has a
        // hole.
        if (outline.points == 0 && is_plane) {
            add_point(plane_normal * dot(plane_normal, to_vec3(surface.Value(0, 0))), plane_normal);
        } else if (outline.points == 0) {
            add_edges([](const TopoDS_Edge&) { return false; });
        }
        if (outline.points == 0 || surface.GetType() <= GeomAbs_Torus) continue;
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;  // a free-form surface may bulge between the same edges
        BRepTools::UVBounds(face, u1, u2, v1, v2);
        add((u1 + u2) / 2, (v1 + v2) / 2);
    }
    return list;
}

bool ChangeOutline::matches(const ChangeOutline& other) const {
    const double size = std::max(size_, other.size_);
    return match(vanished_, other.vanished_, size) && match(appeared_, other.appeared_, size);
}

bool ChangeOutline::match(const std::vector<Face>& a, const std::vector<Face>& b, double size) {
    if (a.size() != b.size()) return false;
    std::vector<char> is_taken(b.size(), 0);
    for (const Face& face : a) {
        const auto is_same = [&](const Face& f) {
            if (f.kind != face.kind || f.points != face.points || f.points == 0) return false;
            const double first = 1e-9 * size * f.points, second = first * size;
            for (std::size_t i = 0; i < f.moments.size(); ++i)
                if (std::abs(f.moments[i] - face.moments[i]) > (i < 3 ? first : i < 9 ? second : 1e-6 * f.points))
                    return false;
            return true;
        };
        std::size_t i = 0;
        while (i < b.size() && (is_taken[i] || !is_same(b[i]))) ++i;
        if (i == b.size()) return false;
        is_taken[i] = 1;
    }
    return true;
}

}  // namespace featuremesh
