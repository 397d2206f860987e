// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/node_order.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>

#include <numeric>

#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

struct PointOfNode {
    using key_type = std::int32_t;
    using value_type = Kernel::Point_3;
    using reference = Kernel::Point_3;
    using category = boost::readable_property_map_tag;
    const Vec3* points;

    friend reference get(const PointOfNode& map, key_type node) {
        const Vec3& p = map.points[node];
        return {p.x, p.y, p.z};
    }
};

/// What is by node, some values for each, in another order.
template <class Value>
std::vector<Value> in_order(const std::vector<Value>& values, const std::vector<std::int32_t>& order) {
    std::vector<Value> ordered;
    ordered.reserve(values.size());
    const std::size_t each = values.size() / order.size();
    for (const std::int32_t node : order) {
        const auto first = values.begin() + std::ptrdiff_t(each) * node;
        ordered.insert(ordered.end(), first, first + std::ptrdiff_t(each));
    }
    return ordered;
}

template <std::size_t count>
void renumber(std::vector<std::array<NodeId, count>>& elements, const std::vector<std::int32_t>& number) {
    for (auto& nodes : elements)
        for (NodeId& node : nodes) node = NodeId(std::size_t(number[node.index()]));
}

/// What is needed to solve of a mesh, with other numbers.
Mesh numbered(const Mesh& given, const std::vector<std::int32_t>& order) {
    std::vector<std::int32_t> number(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) number[std::size_t(order[i])] = std::int32_t(i);
    Mesh mesh;
    mesh.order = given.order, mesh.corner_count = given.corner_count;
    mesh.points = in_order(given.points, order);
    mesh.node_numbers = in_order(given.node_numbers, order);
    mesh.tets = given.tets, mesh.tet_mids = given.tet_mids;
    renumber(mesh.tets, number), renumber(mesh.tet_mids, number);
    return mesh;
}

}  // namespace

std::vector<std::int32_t> order_along_curve(const Mesh& mesh) {
    std::vector<std::int32_t> order(mesh.node_count());
    std::iota(order.begin(), order.end(), 0);
    const auto mids = order.begin() + std::ptrdiff_t(mesh.corner_count);
    const CGAL::Spatial_sort_traits_adapter_3<Kernel, PointOfNode> traits(PointOfNode{mesh.points.data()});
    // Halves of boxes, not of what lies in them: then nodes that an edit adds move no others.
    const CGAL::Hilbert_sort_middle_policy by_boxes;
    if (mids != order.begin()) CGAL::hilbert_sort(order.begin(), mids, traits, by_boxes);
    if (mids != order.end()) CGAL::hilbert_sort(mids, order.end(), traits, by_boxes);
    return order;
}

OrderedModel::OrderedModel(const StaticsModel& given)
    : order_(order_along_curve(given.mesh)),
      mesh_(numbered(given.mesh, order_)),
      model_{mesh_,
             given.materials,
             given.tet_materials,
             in_order(given.loads, order_),
             in_order(given.is_held, order_),
             in_order(given.given, order_)},
      around_(tets_of_nodes(mesh_)) {}

}  // namespace featuremesh
