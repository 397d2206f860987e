// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/constrained_delaunay.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/make_conforming_constrained_Delaunay_triangulation_3.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/box_tree.h"
#include "core/errors.h"
#include "core/isolated_run.h"
#include "core/sort_once.h"
#include "volume/recovery/stray_pieces.h"

namespace featuremesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
/// Where two facets meet at a tiny angle the library may add points without end, and offers no way to stop it: its
/// vertices count themselves, and the one too many throws. So does a vertex or cell that is made after a cancel.
struct TooManyPoints {};
class VertexBudget {
  public:
    VertexBudget(std::size_t limit, const RunContext& context) {
        left_ = limit;
        context_ = &context;
    }
    ~VertexBudget() {
        left_ = std::numeric_limits<std::size_t>::max();
        context_ = nullptr;
    }
    static void spend() {
        if (left_ == 0) throw TooManyPoints();
        --left_;
    }
    static void look() {
        if (context_ && ++looks_ % 1024 == 0) context_->check_cancelled();
    }

  private:
    static thread_local std::size_t left_;
    static thread_local const RunContext* context_;
    static thread_local std::uint32_t looks_;
};
thread_local std::size_t VertexBudget::left_ = std::numeric_limits<std::size_t>::max();
thread_local const RunContext* VertexBudget::context_ = nullptr;
thread_local std::uint32_t VertexBudget::looks_ = 0;

template <class Base = CGAL::Triangulation_vertex_base_3<Kernel>>
struct CountedVertex : Base {
    template <class TDS>
    struct Rebind_TDS {
        using Other = CountedVertex<typename Base::template Rebind_TDS<TDS>::Other>;
    };
    using Base::Base;
    CountedVertex() { VertexBudget::spend(); }
};

/// Runs in every constructor.
struct Look {
    Look() { VertexBudget::look(); }
};

template <class Base = CGAL::Triangulation_cell_base_with_info_3<int, Kernel>>
struct WatchedCell : Base {
    template <class TDS>
    struct Rebind_TDS {
        using Other = WatchedCell<typename Base::template Rebind_TDS<TDS>::Other>;
    };
    using Base::Base;
    [[no_unique_address]] Look look;
};

using VertexBase = CGAL::Conforming_constrained_Delaunay_triangulation_vertex_base_3<Kernel, CountedVertex<>>;
using CellBase = CGAL::Conforming_constrained_Delaunay_triangulation_cell_base_3<Kernel, WatchedCell<>>;
using Constrained = CGAL::Conforming_constrained_Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>>;
using Vertex = Constrained::Triangulation::Vertex_handle;
using Cell = Constrained::Triangulation::Cell_handle;

void append_converted(std::span<const Vec3> points, std::vector<Point>& result) {
    for (const Vec3& p : points) result.emplace_back(p.x, p.y, p.z);
}

std::vector<std::array<std::size_t, 3>> corners_of(std::span<const Facet> facets) {
    std::vector<std::array<std::size_t, 3>> result;
    result.reserve(facets.size());
    for (const Facet& f : facets)
        result.push_back({static_cast<std::size_t>(f.corners[0]), static_cast<std::size_t>(f.corners[1]),
                          static_cast<std::size_t>(f.corners[2])});
    return result;
}

/// The facets with a normal, as far as numbers tell: the library leaves out any other, but only after writing it to the
/// standard error and a file of its own. Their regions are those of their neighbours.
std::vector<int> facets_with_normal(const Cavity& cavity) {
    std::vector<int> facets;
    for (std::size_t f = 0; f < cavity.facets.size(); ++f) {
        const auto& [i, j, k] = cavity.facets[f].corners;
        const Vec3 &a = cavity.points[i], &b = cavity.points[j], &c = cavity.points[k];
        const std::array<Vec3, 3> normals{cross(a - c, b - c), cross(b - a, c - a), cross(c - b, a - b)};
        if (std::find(normals.begin(), normals.end(), Vec3{}) == normals.end()) facets.push_back(static_cast<int>(f));
    }
    return facets;
}

/// Reads the library's triangulation back into indices.
class Reading {
  public:
    /// `points` are the cavity's own and the seeds; `facet_of` tells the cavity's facet of each constraint.
    Reading(const Constrained& constrained, const std::vector<Point>& points, const Cavity& cavity,
            std::span<const int> facet_of)
        : constrained_(constrained),
          all_(constrained.triangulation()),
          points_(points),
          cavity_(cavity),
          own_(static_cast<int>(cavity.points.size())),
          facet_of_(facet_of) {}

    ConstrainedTriangulation read() {
        number_vertices();
        read_tets();
        read_pieces();
        find_edges();
        result_.failed = drop_stray_pieces(cavity_, result_.split);
        if (!result_.failed.empty()) result_.split = {}, result_.triangulation = {};
        return std::move(result_);
    }

  private:
    int index_of(Vertex v) const { return index_[v->time_stamp()]; }

    /// The given points are found by their coordinates; the others follow in the order of their coordinates.
    void number_vertices() {
        std::vector<std::size_t> order(points_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points_[a] < points_[b]; });
        std::vector<Vertex> vertices;
        std::size_t largest_stamp = 0;
        for (Vertex v : all_.all_vertex_handles()) {
            largest_stamp = std::max(largest_stamp, static_cast<std::size_t>(v->time_stamp()));
            if (!all_.is_infinite(v)) vertices.push_back(v);
        }
        std::sort(vertices.begin(), vertices.end(), [](Vertex a, Vertex b) { return a->point() < b->point(); });
        const int added_count = static_cast<int>(vertices.size() - points_.size());
        index_.assign(largest_stamp + 1, -1);
        std::size_t next = 0;
        for (Vertex v : vertices) {
            int& index = index_[v->time_stamp()];
            if (next < order.size() && points_[order[next]] == v->point()) {
                index = static_cast<int>(order[next++]);
                if (index >= own_) index += added_count;
                continue;
            }
            index = own_ + static_cast<int>(result_.split.added.size());
            FacetSplit::Added added;
            added.point = {v->point().x(), v->point().y(), v->point().z()};
            if (v->ccdt_3_data().is_Steiner_vertex_in_face())
                added.facet = facet_of_[static_cast<std::size_t>(v->ccdt_3_data().face_index())];
            result_.split.added.push_back(added);
        }
    }

    void read_tets() {
        Triangulation& t = result_.triangulation;
        for (Cell c : all_.all_cell_handles()) {
            c->info() = all_.is_infinite(c) ? -1 : static_cast<int>(t.tets.size());
            if (c->info() >= 0)
                t.tets.push_back(
                    {index_of(c->vertex(0)), index_of(c->vertex(1)), index_of(c->vertex(2)), index_of(c->vertex(3))});
        }
        for (Cell c : all_.finite_cell_handles())
            t.neighbours.push_back(
                {c->neighbor(0)->info(), c->neighbor(1)->info(), c->neighbor(2)->info(), c->neighbor(3)->info()});
    }

    void read_pieces() {
        for (const auto& [cell, k] : constrained_.constrained_facets()) {
            const int facet = facet_of_[static_cast<std::size_t>(constrained_.face_constraint_index(cell, k))];
            FacetSplit::Piece piece{{index_of(cell->vertex((k + 1) % 4)), index_of(cell->vertex((k + 2) % 4)),
                                     index_of(cell->vertex((k + 3) % 4))},
                                    facet};
            if (is_whole(piece)) continue;
            if (!turns_like_facet(piece)) std::swap(piece.corners[1], piece.corners[2]);
            result_.split.pieces.push_back(piece);
        }
        std::sort(result_.split.pieces.begin(), result_.split.pieces.end(), [](const auto& a, const auto& b) {
            return std::tie(a.facet, a.corners) < std::tie(b.facet, b.corners);
        });
    }

    bool is_whole(const FacetSplit::Piece& piece) const {
        return *std::max_element(piece.corners.begin(), piece.corners.end()) < own_;
    }
    Vec3 point_of(int index) const {
        if (index >= own_) return result_.split.added[index - own_].point;
        return {points_[index].x(), points_[index].y(), points_[index].z()};
    }
    Vec3 normal_of(const std::array<int, 3>& c) const {
        return cross(point_of(c[1]) - point_of(c[0]), point_of(c[2]) - point_of(c[0]));
    }
    bool turns_like_facet(const FacetSplit::Piece& piece) const {
        return dot(normal_of(piece.corners), normal_of(cavity_.facets[piece.facet].corners)) > 0;
    }

    /// The edge of an added point is the one that the facets around it share.
    void find_edges() {
        std::vector<std::vector<int>> facets_around(result_.split.added.size());
        for (const auto& piece : result_.split.pieces)
            for (const int c : piece.corners)
                if (c >= own_ && (facets_around[c - own_].empty() || facets_around[c - own_].back() != piece.facet))
                    facets_around[c - own_].push_back(piece.facet);
        for (std::size_t i = 0; i < result_.split.added.size(); ++i) {
            if (result_.split.added[i].facet >= 0 || facets_around[i].size() < 2) continue;
            std::array<int, 3> a = cavity_.facets[facets_around[i][0]].corners,
                               b = cavity_.facets[facets_around[i][1]].corners;
            std::sort(a.begin(), a.end()), std::sort(b.begin(), b.end());
            std::vector<int> shared;
            std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
            if (shared.size() == 2) result_.split.added[i].edge = {shared[0], shared[1]};
        }
    }

    const Constrained& constrained_;
    const Constrained::Triangulation& all_;
    const std::vector<Point>& points_;
    const Cavity& cavity_;
    int own_;
    std::span<const int> facet_of_;  ///< by constraint
    std::vector<int> index_;
    ConstrainedTriangulation result_;
};

ConstrainedTriangulation given_up() {
    ConstrainedTriangulation result;
    result.is_given_up = true;
    return result;
}

ConstrainedTriangulation triangulate(const Cavity& cavity, const std::vector<Point>& points,
                                     std::span<const int> facet_of) {
    std::vector<Facet> facets;
    for (const int f : facet_of) facets.push_back(cavity.facets[static_cast<std::size_t>(f)]);
    try {
        const Constrained constrained(points, corners_of(facets));
        return Reading(constrained, points, cavity, facet_of).read();
    } catch (const CGAL::Constrained_triangulation_insertion_exception& error) {
        ConstrainedTriangulation result;
        for (const auto facet : error.failed_faces())
            result.failed.push_back(facet_of[static_cast<std::size_t>(facet)]);
        return result;
    } catch (const Cancelled&) {
        throw;
    } catch (const TooManyPoints&) {
        return given_up();
    } catch (const std::runtime_error&) {  // the library found no place for a point
        return given_up();
    } catch (const std::logic_error&) {  // nor for a facet
        return given_up();
    }
}

/// A triangulation as bytes, for the way from one process to another.
class Bytes {
  public:
    Bytes() = default;
    explicit Bytes(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}

    static std::vector<std::byte> of(const ConstrainedTriangulation& t) {
        Bytes all;
        all.put(std::vector<char>(1, t.is_given_up));
        all.put(t.failed), all.put(t.split.added), all.put(t.split.pieces);
        all.put(t.triangulation.tets), all.put(t.triangulation.neighbours);
        return std::move(all.bytes_);
    }
    ConstrainedTriangulation read() {
        ConstrainedTriangulation t;
        std::vector<char> is_given_up;
        take(is_given_up), take(t.failed), take(t.split.added), take(t.split.pieces);
        take(t.triangulation.tets), take(t.triangulation.neighbours);
        t.is_given_up = is_given_up.front() != 0;
        return t;
    }

  private:
    template <class T>
    void put(const std::vector<T>& list) {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::size_t count = list.size(), at = bytes_.size();
        bytes_.resize(at + sizeof count + count * sizeof(T));
        std::memcpy(bytes_.data() + at, &count, sizeof count);
        if (count > 0) std::memcpy(bytes_.data() + at + sizeof count, list.data(), count * sizeof(T));
    }
    template <class T>
    void take(std::vector<T>& list) {
        std::size_t count = 0;
        std::memcpy(&count, bytes_.data() + next_, sizeof count);
        next_ += sizeof count;
        list.resize(count);
        if (count > 0) std::memcpy(list.data(), bytes_.data() + next_, count * sizeof(T));
        next_ += count * sizeof(T);
    }

    std::vector<std::byte> bytes_;
    std::size_t next_ = 0;
};

/// Of these facets, ascending, those that cut or overlap others of them, or have no area.
std::vector<int> crossing_among(const Cavity& cavity, std::span<const int> facets) {
    std::vector<Point> points;
    append_converted(cavity.points, points);
    std::vector<Facet> chosen;
    for (const int facet : facets) chosen.push_back(cavity.facets[facet]);
    const auto triangles = corners_of(chosen);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    CGAL::Polygon_mesh_processing::triangle_soup_self_intersections(points, triangles, std::back_inserter(pairs));
    std::vector<int> crossing;
    for (const auto& [a, b] : pairs) crossing.push_back(facets[a]), crossing.push_back(facets[b]);
    sort_once(crossing);
    return crossing;
}

}  // namespace

ConstrainedTriangulation constrained_delaunay(const Cavity& cavity, std::span<const Vec3> seeds, std::size_t missing,
                                              const RunContext& context) {
    // walls of a fiftieth of the edge length took 20 to 40 vertices, made and gone again, for a missing facet
    constexpr std::size_t spare_vertices = 1'000, vertices_per_missing = 100;
    // no vertex was seen to take a tenth of this
    constexpr std::size_t least_seconds = 60, vertices_per_second = 200;
    std::vector<Point> points;
    append_converted(cavity.points, points);
    append_converted(seeds, points);
    const std::vector<int> facet_of = facets_with_normal(cavity);
    // where facets all but touch, the library may follow a handle to nowhere
    const std::size_t most_vertices = points.size() + spare_vertices + vertices_per_missing * missing;
    auto found = run_isolated(
        [&](const RunContext& watched) {
            const VertexBudget budget(most_vertices, watched);
            return Bytes::of(triangulate(cavity, points, facet_of));
        },
        {static_cast<unsigned>(least_seconds + most_vertices / vertices_per_second)}, context);
    return found ? Bytes(std::move(*found)).read() : given_up();
}

std::vector<int> crossing_facets(const Cavity& cavity) {
    std::vector<int> all(cavity.facets.size());
    std::iota(all.begin(), all.end(), 0);
    return crossing_among(cavity, all);
}

std::vector<int> crossing_facets(const Cavity& cavity, std::span<const int> missing) {
    const auto box_of = [&](int facet) {
        Box box;
        for (const int c : cavity.facets[facet].corners) box.add(cavity.points[c]);
        return box;
    };
    std::vector<Box> boxes;
    for (const int facet : missing) boxes.push_back(box_of(facet));
    const BoxTree around_missing(boxes);
    std::vector<int> near;
    for (int facet = 0; facet < static_cast<int>(cavity.facets.size()); ++facet) {
        const Box box = box_of(facet);
        bool is_near = false;
        around_missing.visit_where([&](const Box& other) { return !is_near && box.overlaps(other); },
                                   [&](int) { is_near = true; });
        if (is_near) near.push_back(facet);
    }
    return crossing_among(cavity, near);
}

}  // namespace featuremesh
