// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/coarse_level.h"

#include <utility>

#include "core/ids.h"
#include "mesh/mesh.h"
#include "mesh/second_order.h"

namespace featuremesh {

namespace {

SameRows of_corners(const SameRows& same, std::size_t corner_count) {
    return {{same.row.begin(), same.row.begin() + std::ptrdiff_t(corner_count)}, same.node_now};
}

}  // namespace

CoarseLevel coarse_level(const StaticsModel& model, const TetsOfNodes& around, RunContext& context, BlockMatrix earlier,
                         const SameRows* same) {
    const Mesh& mesh = model.mesh;
    const auto corner_end = std::ptrdiff_t(mesh.corner_count);
    Mesh straight;
    straight.corner_count = mesh.corner_count;
    straight.points.assign(mesh.points.begin(), mesh.points.begin() + corner_end);
    straight.tets = mesh.tets;
    const StaticsModel linear{straight,
                              model.materials,
                              model.tet_materials,
                              {},
                              {model.is_held.begin(), model.is_held.begin() + 3 * corner_end},
                              {}};

    CoarseLevel level;
    level.matrix =
        same ? changed_stiffness(std::move(earlier), of_corners(*same, mesh.corner_count), linear, around, context)
             : assemble_stiffness(linear, around, context);
    level.is_held = model.is_held;
    level.parents.resize(mesh.node_count());
    for (std::size_t node = 0; node < mesh.corner_count; ++node)
        level.parents[node] = {std::int32_t(node), std::int32_t(node)};
    const std::vector<std::array<NodeId, 2>> ends = ends_of_mids(mesh);
    for (std::size_t mid = 0; mid < ends.size(); ++mid)
        level.parents[mesh.corner_count + mid] = {ends[mid][0].value, ends[mid][1].value};
    return level;
}

}  // namespace featuremesh
