// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/delaunay/triangulation.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "core/errors.h"
#include "core/messages.h"
#include "mesh/second_order.h"

namespace featuremesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

/// Points by number, for CGAL; sorting by them ends when the work is cancelled.
struct WatchedPoints {
    using key_type = std::size_t;
    using value_type = Kernel::Point_3;
    using reference = const value_type&;
    using category = boost::readable_property_map_tag;

    const value_type* points;
    RoundWatch* watch;
    friend reference get(const WatchedPoints& map, key_type i) {
        (*map.watch)();
        return map.points[i];
    }
};

/// Along the longest axis in stretches about as long as they are wide: a Hilbert curve takes a slender box as a cube,
/// so that one point is as far from the next as many elements.
std::vector<std::span<std::size_t>> stretches_of(std::vector<std::size_t>& order, std::span<const Vec3> points) {
    constexpr double slender = 4;  ///< times as long as wide
    Box box;
    for (const Vec3& p : points) box.add(p);
    const Vec3 size = box.size();
    std::array<double, 3> sides{size.x, size.y, size.z};
    const auto axis = std::size_t(std::max_element(sides.begin(), sides.end()) - sides.begin());
    const double length = sides[axis];
    sides[axis] = 0;
    const double width = *std::max_element(sides.begin(), sides.end());
    if (points.empty() || length < slender * width) return {order};
    const auto along = [&](std::size_t i) {
        const Vec3 from_low = points[i] - box.low;
        return axis == 0 ? from_low.x : axis == 1 ? from_low.y : from_low.z;
    };
    const double most = double(points.size());
    const double count = width > length / most ? std::ceil(length / width) : most;
    const auto stretch = [&](std::size_t i) { return std::size_t(count * along(i) / length); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return stretch(a) < stretch(b); });
    std::vector<std::span<std::size_t>> stretches;
    for (std::size_t first = 0, i = 0; i < order.size(); ++i)
        if (i + 1 == order.size() || stretch(order[i + 1]) != stretch(order[first])) {
            stretches.push_back(std::span(order).subspan(first, i + 1 - first));
            first = i + 1;
        }
    return stretches;
}

/// Along a Hilbert curve, so that each point is found near the one before.
std::vector<std::size_t> insertion_order(std::span<const Vec3> points, const std::vector<Kernel::Point_3>& converted,
                                         const RunContext& context) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    RoundWatch watch(context);
    const CGAL::Spatial_sort_traits_adapter_3<Kernel, WatchedPoints> traits(WatchedPoints{converted.data(), &watch});
    for (const std::span<std::size_t> stretch : stretches_of(order, points))
        CGAL::spatial_sort<CGAL::Sequential_tag>(stretch.begin(), stretch.end(), traits);
    return order;
}

/// Numbers the points from `first` on.
void insert_all(Delaunay& delaunay, std::span<const Vec3> points, std::size_t first, RunContext& context) {
    std::vector<Kernel::Point_3> converted;
    converted.reserve(points.size());
    for (const Vec3& p : points) converted.emplace_back(p.x, p.y, p.z);
    const std::vector<std::size_t> order = insertion_order(points, converted, context);
    Delaunay::Vertex_handle last;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i % 1000 == 0) context.progress(0.7 * static_cast<double>(i) / order.size());
        last = last == Delaunay::Vertex_handle() ? delaunay.insert(converted[order[i]])
                                                 : delaunay.insert(converted[order[i]], last->cell());
        last->info() = static_cast<int>(first + order[i]);
        if (delaunay.number_of_vertices() != first + i + 1)
            throw MeshError(say<Code::nodes_in_one_place>(points[order[i]]));
    }
}

Triangulation extract(const Delaunay& delaunay, std::span<const int> number_of, const RunContext& context) {
    RoundWatch watch(context);
    Triangulation result;
    const std::size_t count = delaunay.number_of_finite_cells();
    result.tets.reserve(count);
    result.neighbours.resize(count);
    for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell) {
        watch();
        const std::array<int, 4> tet{cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
                                     cell->vertex(3)->info()};
        const bool is_infinite = *std::min_element(tet.begin(), tet.end()) < 0;
        cell->info() = is_infinite ? -1 : static_cast<int>(result.tets.size());
        if (is_infinite) continue;
        result.tets.push_back(tet);
        if (!number_of.empty())
            for (int& corner : result.tets.back()) corner = number_of[static_cast<std::size_t>(corner)];
    }
    for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell) {
        watch();
        if (cell->info() >= 0)
            for (int k = 0; k < 4; ++k) result.neighbours[cell->info()][k] = cell->neighbor(k)->info();
    }
    return result;
}

}  // namespace

struct GrowingDelaunay::Data {
    Delaunay delaunay;
};

GrowingDelaunay::GrowingDelaunay() : data_(std::make_unique<Data>()) { data_->delaunay.infinite_vertex()->info() = -1; }
GrowingDelaunay::~GrowingDelaunay() = default;

void GrowingDelaunay::insert(std::span<const Vec3> points, RunContext& context) {
    insert_all(data_->delaunay, points, data_->delaunay.number_of_vertices(), context);
}

Triangulation GrowingDelaunay::tets(const RunContext& context, std::span<const int> number_of) const {
    return extract(data_->delaunay, number_of, context);
}

}  // namespace featuremesh
