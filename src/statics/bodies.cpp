// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/bodies.h"

#include <cstddef>
#include <span>

#include "core/joined_sets.h"
#include "mesh/triangle_uses.h"

namespace featuremesh {

std::vector<std::int32_t> bodies_of_tets(const Mesh& mesh) {
    JoinedSets joined(mesh.tets.size());
    TriangleUses uses(mesh);
    for (std::size_t b = 0; b < uses.bucket_count(); ++b)
        uses.visit_bucket(b, [&](std::span<const TriangleUse> meeting) {
            for (std::size_t i = 1; i < meeting.size() && meeting[i].is_tet(); ++i)
                joined.join(std::int32_t(meeting[i - 1].element()), std::int32_t(meeting[i].element()));
        });
    std::vector<std::int32_t> bodies(mesh.tets.size());
    std::int32_t count = 0;
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        const std::int32_t first = joined.root(std::int32_t(tet));
        bodies[tet] = first == std::int32_t(tet) ? count++ : bodies[std::size_t(first)];
    }
    return bodies;
}

}  // namespace featuremesh
