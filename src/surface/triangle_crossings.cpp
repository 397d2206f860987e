// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/triangle_crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_set>

#include "brep/common_body.h"
#include "core/box_tree.h"
#include "core/geometry.h"

namespace featuremesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

std::uint64_t side_key(NodeId a, NodeId b) {
    const auto [low, high] = std::minmax(a.value, b.value);
    return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

Box box_of(const Mesh& mesh, const std::array<NodeId, 3>& t) {
    Box box;
    for (const NodeId n : t) box.add(mesh.point(n));
    return box;
}

/// The boxes of all triangles of each body. Kept triangles of one body do not cross; of two bodies either may have
/// moved.
class BodyBoxes {
  public:
    BodyBoxes(const Brep& brep, const Mesh& mesh, double reach) : brep_(brep), boxes_(brep.body_count()) {
        if (boxes_.size() < 2) return;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const BodyId body : brep.bodies_of(mesh.triangle_faces[t]))
                if (body.is_valid()) boxes_[body.index()].add(box_of(mesh, mesh.triangles[t]));
        for (Box& box : boxes_) box = box.grown(reach);
    }

    /// Whether another body than those of the face may be in the box.
    bool meet_at(FaceId face, const Box& box) const {
        if (boxes_.size() < 2) return false;
        const auto own = brep_.bodies_of(face);
        for (std::size_t body = 0; body < boxes_.size(); ++body)
            if (BodyId(body) != own[0] && BodyId(body) != own[1] && boxes_[body].overlaps(box)) return true;
        return false;
    }

  private:
    const Brep& brep_;
    std::vector<Box> boxes_;
};

class CrossingSearch {
  public:
    CrossingSearch(const Brep& brep, const Mesh& mesh, std::size_t first_new)
        : brep_(brep),
          mesh_(mesh),
          first_new_(first_new),
          reach_(brep.body_count() < 2 ? 0 : brep.tolerances().same_geometry()),
          bodies_(brep, mesh, reach_),
          is_plane_(brep.face_count(), unknown),
          is_line_(brep.edge_count(), unknown) {}

    Crossings find(RunContext& context) {
        gather_near_new();
        const bool is_one_body = brep_.body_count() == 1;
        if (is_one_body) leave_out_clear_of_inexact();
        const auto kept_count =
            std::size_t(std::lower_bound(triangles_.begin(), triangles_.end(), first_new_) - triangles_.begin());
        const BoxTree all_boxes{boxes_};
        const BoxTree new_boxes{std::span(boxes_).subspan(kept_count > 0 ? kept_count : boxes_.size())};
        constexpr std::size_t chunk = 4096;
        std::vector<std::vector<std::array<TriangleId, 2>>> found((triangles_.size() + chunk - 1) / chunk);
        parallel_for(context, triangles_.size(), chunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (is_exact_[i] && is_one_body) continue;
                const bool is_with_new_only = i < kept_count && !bodies_.meet_at(face_of(triangles_[i]), boxes_[i]);
                find_with(is_with_new_only ? new_boxes : all_boxes, is_with_new_only ? kept_count : 0, i,
                          found[begin / chunk]);
            }
        });
        Crossings all;
        for (const auto& part : found)
            for (const auto& pair : part)
                (have_common_body(brep_, face_of(pair[0].index()), face_of(pair[1].index())) ? all.within : all.between)
                    .push_back(pair);
        return all;
    }

  private:
    void gather_near_new() {
        Box region;
        for (std::size_t t = first_new_; t < mesh_.triangles.size(); ++t) region.add(box_of(mesh_, mesh_.triangles[t]));
        std::vector<char> is_near(mesh_.node_count(), 0);
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            const Box box = box_of(mesh_, mesh_.triangles[t]);
            if (t < first_new_ && !box.overlaps(region) && !bodies_.meet_at(face_of(t), box)) continue;
            triangles_.push_back(t);
            boxes_.push_back(box);
            for (const NodeId n : mesh_.triangles[t]) is_near[n.index()] = 1;
        }
        for (std::size_t s = 0; s < mesh_.segments.size(); ++s) {
            const auto& [a, b] = mesh_.segments[s];
            if (is_near[a.index()] && is_near[b.index()] && !is_line(mesh_.segment_edges[s]))
                chords_.insert(side_key(a, b));
        }
        for (const std::size_t t : triangles_) is_exact_.push_back(lies_in_face(t));
    }

    /// Of two triangles that cross one is new and one, perhaps the same, does not lie in its face.
    void leave_out_clear_of_inexact() {
        Box fresh, inexact, fresh_inexact;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const bool is_new = triangles_[i] >= first_new_;
            if (is_new) fresh.add(boxes_[i]);
            if (!is_exact_[i]) inexact.add(boxes_[i]);
            if (is_new && !is_exact_[i]) fresh_inexact.add(boxes_[i]);
        }
        std::size_t count = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const bool is_new = triangles_[i] >= first_new_;
            const bool may_cross = boxes_[i].overlaps(fresh_inexact) || (is_new && boxes_[i].overlaps(inexact)) ||
                                   (!is_exact_[i] && boxes_[i].overlaps(fresh));
            if (!may_cross) continue;
            triangles_[count] = triangles_[i], boxes_[count] = boxes_[i], is_exact_[count++] = is_exact_[i];
        }
        triangles_.resize(count), boxes_.resize(count), is_exact_.resize(count);
    }

    bool is_line(EdgeId edge) {
        char& known = is_line_[edge.index()];
        if (known == unknown)
            known = brep_.is_degenerated(edge) || BRepAdaptor_Curve(brep_.edge(edge)).GetType() == GeomAbs_Line;
        return known == 1;
    }
    bool is_plane(FaceId face) {
        char& known = is_plane_[face.index()];
        if (known == unknown) known = BRepAdaptor_Surface(brep_.face(face), Standard_False).GetType() == GeomAbs_Plane;
        return known == 1;
    }

    bool lies_in_face(std::size_t t) {
        const auto& c = mesh_.triangles[t];
        if (!is_plane(mesh_.triangle_faces[t])) return false;
        return !chords_.count(side_key(c[0], c[1])) && !chords_.count(side_key(c[1], c[2])) &&
               !chords_.count(side_key(c[2], c[0]));
    }

    /// The tree has the boxes from `first` on.
    void find_with(const BoxTree& tree, std::size_t first, std::size_t i,
                   std::vector<std::array<TriangleId, 2>>& found) const {
        const std::size_t before = found.size();
        const auto meets = [&, reached = boxes_[i].grown(reach_)](const Box& box) { return box.overlaps(reached); };
        tree.visit_where(meets, [&](std::int32_t other) {
            const auto j = first + std::size_t(other);
            if (j == i || (is_exact_[j] == is_exact_[i] && j < i) || (is_exact_[i] && !is_exact_[j])) return;
            const std::size_t a = triangles_[i], b = triangles_[j];
            if (is_smooth_pair(a, b)) return;
            const bool is_known = std::max(a, b) < first_new_ || (is_exact_[i] && is_exact_[j]);
            if (is_known && have_common_body(brep_, face_of(a), face_of(b))) return;
            if (!do_cross(mesh_.triangles[a], mesh_.triangles[b]) &&
                (reach_ == 0 || have_common_body(brep_, face_of(a), face_of(b)) ||
                 !lie_on_one_another(mesh_.triangles[a], mesh_.triangles[b])))
                return;
            found.push_back({TriangleId(std::max(a, b)), TriangleId(std::min(a, b))});
        });
        std::sort(found.begin() + std::ptrdiff_t(before), found.end());
    }

    FaceId face_of(std::size_t t) const { return mesh_.triangle_faces[t]; }

    /// Two triangles of one face that share a node and have about one normal cannot cross: they do not overlap in the
    /// face's chart.
    bool is_smooth_pair(std::size_t t, std::size_t u) const {
        if (mesh_.triangle_faces[t] != mesh_.triangle_faces[u]) return false;
        const auto &a = mesh_.triangles[t], &b = mesh_.triangles[u];
        const bool touch =
            std::any_of(a.begin(), a.end(), [&](NodeId n) { return n == b[0] || n == b[1] || n == b[2]; });
        if (!touch) return false;
        const Vec3 m = normal(a), n = normal(b);
        return dot(m, n) > 0.5 * length(m) * length(n);
    }

    Vec3 normal(const std::array<NodeId, 3>& t) const {
        return cross(mesh_.point(t[1]) - mesh_.point(t[0]), mesh_.point(t[2]) - mesh_.point(t[0]));
    }

    Point point(NodeId n) const { return {mesh_.point(n).x, mesh_.point(n).y, mesh_.point(n).z}; }

    bool do_cross(std::array<NodeId, 3> a, std::array<NodeId, 3> b) const {
        // Shared nodes first, in the same order in both.
        std::size_t shared = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = shared; j < 3; ++j)
                if (i >= shared && a[i] == b[j]) {
                    std::swap(a[shared], a[i]);
                    std::swap(b[shared], b[j]);
                    ++shared;
                    break;
                }
        const Point p0 = point(a[0]), p1 = point(a[1]), p2 = point(a[2]), q1 = point(b[1]), q2 = point(b[2]);
        if (shared == 3) return true;
        if (shared == 2)
            return CGAL::orientation(p0, p1, p2, q2) == CGAL::COPLANAR &&
                   CGAL::coplanar_orientation(p0, p1, p2, q2) == CGAL::POSITIVE;
        const Kernel::Triangle_3 one(p0, p1, p2), other(point(b[0]), q1, q2);
        if (one.is_degenerate() || other.is_degenerate()) return false;
        if (shared == 1)
            return CGAL::do_intersect(Kernel::Segment_3(p1, p2), other) ||
                   CGAL::do_intersect(Kernel::Segment_3(q1, q2), one);
        return CGAL::do_intersect(one, other);
    }

    /// Without a node in common, but for a gap that rounding leaves, as of solids that a joint has put together.
    bool lie_on_one_another(const std::array<NodeId, 3>& a, const std::array<NodeId, 3>& b) const {
        if (std::any_of(a.begin(), a.end(), [&](NodeId n) { return n == b[0] || n == b[1] || n == b[2]; }))
            return false;
        const Vec3 m = normal(a);
        const auto is_in_plane = [&](NodeId n) {
            return std::abs(dot(m, mesh_.point(n) - mesh_.point(a[0]))) <= reach_ * length(m);
        };
        if (!std::all_of(b.begin(), b.end(), is_in_plane)) return false;
        const double x = std::abs(m.x), y = std::abs(m.y), z = std::abs(m.z);
        const auto flat = [&](NodeId n) -> Kernel::Point_2 {
            const Vec3& p = mesh_.point(n);
            if (x >= y && x >= z) return {p.y, p.z};
            return y >= z ? Kernel::Point_2(p.z, p.x) : Kernel::Point_2(p.x, p.y);
        };
        const Kernel::Triangle_2 one(flat(a[0]), flat(a[1]), flat(a[2])), other(flat(b[0]), flat(b[1]), flat(b[2]));
        return !one.is_degenerate() && !other.is_degenerate() && CGAL::do_intersect(one, other);
    }

    static constexpr char unknown = 2;
    const Brep& brep_;
    const Mesh& mesh_;
    std::size_t first_new_;
    double reach_;  ///< mm, over a gap between bodies
    BodyBoxes bodies_;
    std::vector<char> is_plane_, is_line_;      ///< by face and edge, once asked for
    std::unordered_set<std::uint64_t> chords_;  ///< segments on curved edges
    std::vector<std::size_t> triangles_;
    std::vector<Box> boxes_;
    std::vector<char> is_exact_;
};

}  // namespace

Crossings crossing_triangles(const Brep& brep, const Mesh& mesh, std::size_t first_new, RunContext& context) {
    if (first_new == mesh.triangles.size() && brep.body_count() < 2) return {};
    return CrossingSearch(brep, mesh, first_new).find(context);
}

}  // namespace featuremesh
