// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/curved/low_tets.h"

#include <algorithm>
#include <iterator>

#include "core/sort_once.h"
#include "mesh/second_order.h"

namespace featuremesh {
namespace {

constexpr std::size_t grain = 1 << 13;

/// Cheap where all coefficients are large enough; the subdivision decides the rest.
bool is_at_most(const Mesh& mesh, TetId tet, double limit) {
    if (!has_curved_side(mesh, tet)) return false;
    const auto nodes = tet_nodes(mesh, tet);
    return quick_bound(nodes) <= limit && min_scaled_jacobian(nodes) <= limit;
}

/// Of so many tets, of which `tet_of` tells the i-th.
template <class TetOf>
std::vector<TetId> low_among(const Mesh& mesh, std::size_t count, TetOf tet_of, double limit, RunContext& context) {
    std::vector<std::vector<TetId>> parts((count + grain - 1) / grain);
    parallel_for(context, count, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (is_at_most(mesh, tet_of(i), limit)) parts[begin / grain].push_back(tet_of(i));
    });
    std::vector<TetId> found;
    for (const auto& part : parts) found.insert(found.end(), part.begin(), part.end());
    return found;
}

template <class Visit>
void for_each_node(const Mesh& mesh, std::size_t tet, Visit visit) {
    for (const NodeId n : mesh.tets[tet]) visit(n);
    for (const NodeId n : mesh.tet_mids[tet]) visit(n);
}

}  // namespace

TetsAtNode::TetsAtNode(const Mesh& mesh, const RunContext& context)
    : first_(mesh.points.size() + 1), tets_(10 * mesh.tets.size()) {
    RoundWatch watch(context);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t, watch())
        for_each_node(mesh, t, [&](NodeId n) { ++first_[n.index()]; });
    for (std::size_t n = 0, sum = 0; n < first_.size(); ++n) sum += first_[n], first_[n] = sum;
    for (std::size_t t = mesh.tets.size(); t-- > 0; watch())
        for_each_node(mesh, t, [&](NodeId n) { tets_[--first_[n.index()]] = TetId(t); });
}

std::span<const TetId> TetsAtNode::of(NodeId node) const {
    return {tets_.data() + first_[node.index()], tets_.data() + first_[node.index() + 1]};
}

std::vector<TetId> TetsAtNode::of(std::span<const NodeId> nodes) const {
    std::vector<TetId> all;
    for (const NodeId n : nodes) all.insert(all.end(), of(n).begin(), of(n).end());
    sort_once(all);
    return all;
}

double quick_bound(const std::array<Vec3, 10>& nodes, double limit) {
    const double straight = 6 * signed_volume(nodes[0], nodes[1], nodes[2], nodes[3]);
    return straight > 0 ? smallest_coefficient(nodes, limit * straight) / straight
                        : -std::numeric_limits<double>::infinity();
}

std::vector<TetId> tets_at_most(const Mesh& mesh, double limit, RunContext& context) {
    return low_among(
        mesh, mesh.tets.size(), [](std::size_t i) { return TetId(i); }, limit, context);
}

LowTets::LowTets(const Mesh& mesh, double limit, RunContext& context)
    : mesh_(mesh), limit_(limit), context_(context), found_(tets_at_most(mesh, limit, context)), points_(mesh.points) {}

void LowTets::look_again(const TetsAtNode& tets_at) {
    const std::vector<TetId> changed = tets_at.of(moved_nodes());
    const auto low = low_among(
        mesh_, changed.size(), [&](std::size_t i) { return changed[i]; }, limit_, context_);
    std::vector<TetId> unchanged, found;
    std::set_difference(found_.begin(), found_.end(), changed.begin(), changed.end(), std::back_inserter(unchanged));
    std::merge(unchanged.begin(), unchanged.end(), low.begin(), low.end(), std::back_inserter(found));
    found_ = std::move(found);
}

std::vector<NodeId> LowTets::moved_nodes() {
    std::vector<NodeId> moved;
    for (std::size_t n = 0; n < points_.size(); ++n)
        if (points_[n] != mesh_.points[n]) moved.emplace_back(n), points_[n] = mesh_.points[n];
    return moved;
}

}  // namespace featuremesh
