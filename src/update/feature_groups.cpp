// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/feature_groups.h"

#include "update/enclosure.h"

namespace featuremesh {

namespace {

std::vector<Vec3> centroids(const Mesh& mesh) {
    std::vector<Vec3> centres;
    centres.reserve(mesh.tets.size());
    for (const auto& tet : mesh.tets)
        centres.push_back((mesh.point(tet[0]) + mesh.point(tet[1]) + mesh.point(tet[2]) + mesh.point(tet[3])) / 4);
    return centres;
}

/// Cell of every tet, by index; -1 for those in no material cell (a chord beside a curved face).
std::vector<std::int32_t> cells_of_tets(const PartMesh& part, const std::vector<Cell>& cells, RunContext& context) {
    const std::vector<Vec3> centres = centroids(part.mesh);
    std::vector<std::int32_t> cell_of(centres.size(), -1);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (!cells[c].material) continue;
        const Enclosure inside({cells[c].solid});
        parallel_for(context, centres.size(), 8192, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t)
                if (cell_of[t] < 0 && inside.contains(centres[t])) cell_of[t] = std::int32_t(c);
        });
    }
    return cell_of;
}

}  // namespace

std::vector<std::pair<std::string, std::vector<TetId>>> tets_of_features(const PartMesh& part, RunContext& context) {
    const FeatureTree& tree = part.part.tree;
    // After an update the cells are a summary.
    const CellModel whole = part.part.cells.is_summary ? build_cells(tree, part.part.brep, context) : CellModel{};
    const std::vector<Cell>& cells = part.part.cells.is_summary ? whole.cells : part.part.cells.cells;
    const std::vector<std::int32_t> cell_of = cells_of_tets(part, cells, context);
    std::vector<std::vector<TetId>> tets(tree.features.size());
    for (std::size_t t = 0; t < cell_of.size(); ++t) {
        if (cell_of[t] < 0) continue;
        FeatureId last;
        for (const Owner& owner : cells[std::size_t(cell_of[t])].owners)
            if (owner.feature != last) tets[(last = owner.feature).index()].push_back(TetId(t));
    }
    std::vector<std::pair<std::string, std::vector<TetId>>> groups;
    for (std::size_t f = 0; f < tets.size(); ++f)
        if (!tets[f].empty()) groups.emplace_back(tree.features[f].name, std::move(tets[f]));
    return groups;
}

}  // namespace featuremesh
