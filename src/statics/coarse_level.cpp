// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/coarse_level.h"

#include <utility>

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
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
        for (std::size_t side = 0; side < tet_sides.size(); ++side)
            level.parents[mesh.tet_mids[tet][side].index()] = {mesh.tets[tet][std::size_t(tet_sides[side][0])].value,
                                                               mesh.tets[tet][std::size_t(tet_sides[side][1])].value};
    return level;
}

}  // namespace featuremesh
