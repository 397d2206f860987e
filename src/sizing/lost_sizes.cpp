// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/lost_sizes.h"

#include "core/messages.h"

#include <algorithm>
#include <array>

namespace featuremesh {

std::vector<Message> lost_sizes(const Brep& brep, const SizingOptions& options) {
    const std::array<std::size_t, 4> counts{brep.vertex_count(), brep.edge_count(), brep.face_count(),
                                            brep.solid_count()};
    std::vector<Message> lines;
    for (const LocalSize& local : options.local) {
        const auto [dim, index] = local.entity;
        const bool is_there = dim >= 0 && dim < 4 && index >= 0 &&
                              static_cast<std::size_t>(index) < counts[static_cast<std::size_t>(dim)];
        if (is_there) continue;
        const Message line = say<Code::local_size_lost>(local.entity);
        if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    }
    return lines;
}

}  // namespace featuremesh
