// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/chart_domain.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <set>

namespace featuremesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

struct FaceInfo {
    int label = 0;   ///< 1 inside, -1 outside, 0 not known
    int index = -1;  ///< in the patch
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                       CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Vertex = Cdt::Vertex_handle;
using Face = Cdt::Face_handle;

/// Points in the order of a space-filling curve: each insertion starts where the last one ended.
std::vector<std::size_t> curve_order(const std::vector<Point>& points) {
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto map = CGAL::make_property_map(points.data());
    CGAL::spatial_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map));
    return order;
}

bool do_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
    return CGAL::do_intersect(Kernel::Segment_2(a, b), Kernel::Segment_2(c, d));
}

}  // namespace

struct ChartDomain::Data {
    Cdt cdt;
    std::vector<Vertex> vertices;  ///< by point of the boundary, then by seed
    std::vector<Crossing> crossings;
    std::vector<std::array<int, 2>> segments;
    std::set<std::array<int, 2>> inner;  ///< both directions
    std::size_t boundary_points = 0;
    bool valid = false;

    explicit Data(const FaceBoundary& boundary) {
        boundary_points = boundary.points.size();
        vertices.resize(boundary_points);
        for (const auto& s : boundary.segments) segments.push_back({s.a, s.b});
        for (const auto& s : boundary.inner) inner.insert({s.a, s.b}), inner.insert({s.b, s.a});
        insert_points(boundary);
        if (!insert_constraints(boundary)) {
            find_crossings(boundary);
            return;
        }
        valid = label_regions();
        if (!valid) {
            find_crossings(boundary);
            return;
        }
        find_pieces_that_cut_off(boundary);
        valid = crossings.empty();
    }

    void insert_points(const FaceBoundary& boundary) {
        std::vector<char> used(boundary_points, 0);
        for (const auto& s : boundary.segments)
            used[static_cast<std::size_t>(s.a)] = used[static_cast<std::size_t>(s.b)] = 1;
        for (const auto& s : boundary.inner)
            used[static_cast<std::size_t>(s.a)] = used[static_cast<std::size_t>(s.b)] = 1;
        for (const int p : boundary.lone_points) used[static_cast<std::size_t>(p)] = 1;
        std::vector<Point> points;
        std::vector<int> indices;
        for (std::size_t i = 0; i < boundary_points; ++i)
            if (used[i])
                points.emplace_back(boundary.points[i].x, boundary.points[i].y), indices.push_back(static_cast<int>(i));
        Face hint;
        for (const std::size_t i : curve_order(points)) {
            const Vertex v = cdt.insert(points[i], hint);
            hint = v->face();
            vertices[static_cast<std::size_t>(indices[i])] = v;
            v->info() = indices[i];
        }
    }

    bool insert_constraints(const FaceBoundary& boundary) {
        const auto all_there = [&](const std::vector<BoundarySegment>& list) {
            for (const auto& s : list) {
                const Vertex a = vertices[static_cast<std::size_t>(s.a)], b = vertices[static_cast<std::size_t>(s.b)];
                if (a->info() != s.a || b->info() != s.b || a == b) return false;  // two points at one place
                cdt.insert_constraint(a, b);
                if (!cdt.is_edge(a, b)) return false;  // a point on the piece
            }
            return true;
        };
        try {
            return all_there(boundary.segments) && all_there(boundary.inner);
        } catch (const Cdt::Intersection_of_constraints_exception&) {
            return false;
        }
    }

    void find_crossings(const FaceBoundary& boundary) {
        const auto point = [&](int p) {
            return Point(boundary.points[static_cast<std::size_t>(p)].x,
                         boundary.points[static_cast<std::size_t>(p)].y);
        };
        // Sorted by their left ends, so that only pieces that overlap in x are compared.
        const auto left = [&](std::size_t i) { return std::min(point(segments[i][0]).x(), point(segments[i][1]).x()); };
        const auto right = [&](std::size_t i) {
            return std::max(point(segments[i][0]).x(), point(segments[i][1]).x());
        };
        std::vector<std::size_t> order(segments.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(),
                  [&](std::size_t i, std::size_t j) { return std::pair(left(i), i) < std::pair(left(j), j); });
        for (std::size_t m = 0; m < order.size(); ++m)
            for (std::size_t n = m + 1; n < order.size() && left(order[n]) <= right(order[m]); ++n) {
                const auto [a, b] = segments[order[m]];
                const auto [c, d] = segments[order[n]];
                if (touches_wrongly(point, a, b, c, d))
                    crossings.push_back({std::min(order[m], order[n]), std::max(order[m], order[n])});
            }
    }

    template <class PointOf>
    static bool touches_wrongly(const PointOf& point, int a, int b, int c, int d) {
        if (a == d && b == c) return true;  // there and back again
        if (a == c || a == d || b == c || b == d) {
            const int shared = a == c || a == d ? a : b, p = shared == a ? b : a, q = shared == c ? d : c;
            // Two pieces from one point overlap when they go the same way.
            return p == q || (CGAL::orientation(point(shared), point(p), point(q)) == CGAL::COLLINEAR &&
                              CGAL::angle(point(p), point(shared), point(q)) == CGAL::ACUTE);
        }
        return do_cross(point(a), point(b), point(c), point(d));
    }

    /// A lone point lies outside where the arc beside it is drawn by chords that are too long.
    void find_pieces_that_cut_off(const FaceBoundary& boundary) {
        for (const int p : boundary.lone_points) {
            const Vertex lone = vertices[static_cast<std::size_t>(p)];
            const Face around = lone->face();
            if (!cdt.is_infinite(around) && around->info().label > 0) continue;
            const auto distance_to = [&](const std::array<int, 2>& ends) {
                const auto place = [&](int end) { return vertices[static_cast<std::size_t>(end)]->point(); };
                return CGAL::squared_distance(lone->point(), Kernel::Segment_2(place(ends[0]), place(ends[1])));
            };
            const auto nearest = std::min_element(segments.begin(), segments.end(), [&](const auto& s, const auto& t) {
                return distance_to(s) < distance_to(t);
            });
            const auto piece = static_cast<std::size_t>(nearest - segments.begin());
            crossings.push_back({piece, piece});
        }
    }

    /// Marks what lies left of the segments and what lies right; false when something lies left and right.
    bool label_regions() {
        for (auto f = cdt.all_faces_begin(); f != cdt.all_faces_end(); ++f) f->info() = {};
        std::vector<Face> queue;
        const auto mark = [&](Face f, int label) {
            if (f->info().label == -label) return false;
            if (f->info().label == 0) f->info().label = label, queue.push_back(f);
            return true;
        };
        for (const auto& [a, b] : segments) {
            Face f;
            int i = 0;
            if (!cdt.is_edge(vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)], f, i))
                return false;
            const bool f_is_left = f->vertex(Cdt::ccw(i))->info() == a && !cdt.is_infinite(f->vertex(Cdt::ccw(i)));
            const Face other = f->neighbor(i);
            if (!mark(f_is_left ? f : other, 1) || !mark(f_is_left ? other : f, -1)) return false;
        }
        while (!queue.empty()) {
            const Face f = queue.back();
            queue.pop_back();
            if (f->info().label > 0 && cdt.is_infinite(f)) return false;
            for (int i = 0; i < 3; ++i) {
                if (f->is_constrained(i) && !is_inner(f, i)) continue;
                if (!mark(f->neighbor(i), f->info().label)) return false;
            }
        }
        return true;
    }

    bool is_inner(Face f, int i) const {
        return !inner.empty() && inner.count({f->vertex(Cdt::ccw(i))->info(), f->vertex(Cdt::cw(i))->info()}) > 0;
    }
};

ChartDomain::ChartDomain(const FaceBoundary& boundary) : data_(std::make_unique<Data>(boundary)) {}
ChartDomain::~ChartDomain() = default;
ChartDomain::ChartDomain(ChartDomain&&) noexcept = default;

const std::vector<Crossing>& ChartDomain::crossings() const { return data_->crossings; }
bool ChartDomain::is_valid() const { return data_->valid; }

bool ChartDomain::contains(Vec2 p, void*& hint) const {
    const Cdt& cdt = data_->cdt;
    const Face start = hint ? Face(static_cast<Structure::Face_handle::pointer>(hint)) : Face();
    const Face f = cdt.locate(Point(p.x, p.y), start);
    if (cdt.is_infinite(f)) return false;
    hint = &*f;
    return f->info().label > 0;
}

void ChartDomain::insert(std::span<const Vec2> seeds, const Heartbeat& heart) {
    std::vector<Point> points;
    points.reserve(seeds.size());
    for (const Vec2& p : seeds) points.emplace_back(p.x, p.y);
    data_->vertices.resize(data_->boundary_points + seeds.size());
    Face hint;
    const std::size_t before = data_->boundary_points;
    for (const std::size_t i : curve_order(points)) {
        const std::size_t count = data_->cdt.number_of_vertices();
        if (count % 4096 == 0) heart.beat();
        Cdt::Locate_type type;
        int side;
        hint = data_->cdt.locate(points[i], type, side, hint);
        // on a point that is there already, or on the border
        if (type == Cdt::VERTEX || (type == Cdt::EDGE && data_->cdt.is_constrained({hint, side}))) continue;
        const Vertex v = data_->cdt.insert(points[i], type, hint, side);
        hint = v->face();
        data_->vertices[before + i] = v;
        v->info() = static_cast<int>(before + i);
    }
    data_->label_regions();
}

TrianglePatch ChartDomain::patch() const {
    TrianglePatch patch;
    for (const Vertex& v : data_->vertices)
        patch.points.push_back(v == Vertex() ? Vec2{} : Vec2{v->point().x(), v->point().y()});
    patch.is_fixed.assign(patch.points.size(), 0);
    std::fill_n(patch.is_fixed.begin(), data_->boundary_points, 1);
    patch.nodes.assign(patch.points.size(), -1);
    patch.triangle_of.assign(patch.points.size(), -1);
    int count = 0;
    for (const Face f : data_->cdt.finite_face_handles()) f->info().index = f->info().label > 0 ? count++ : -1;
    patch.triangles.reserve(static_cast<std::size_t>(count)), patch.neighbours.reserve(static_cast<std::size_t>(count));
    for (const Face f : data_->cdt.finite_face_handles()) {
        if (f->info().index < 0) continue;
        std::array<int, 3> corners{}, around{};
        for (int i = 0; i < 3; ++i) {
            corners[static_cast<std::size_t>(i)] = f->vertex(i)->info();
            const Face n = f->neighbor(i);
            const bool is_barrier = f->is_constrained(i);
            around[static_cast<std::size_t>(i)] = is_barrier || data_->cdt.is_infinite(n) ? -1 : n->info().index;
        }
        for (const int c : corners)
            patch.triangle_of[static_cast<std::size_t>(c)] = static_cast<int>(patch.triangles.size());
        patch.triangles.push_back(corners);
        patch.neighbours.push_back(around);
    }
    return patch;
}

}  // namespace featuremesh
