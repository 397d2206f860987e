// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/entity_names.h"

#include <array>
#include <charconv>

namespace featuremesh {

namespace {
constexpr std::array<std::string_view, 4> kinds{"Vertex", "Edge", "Face", "Solid"};
}

std::string name_of(Entity entity) {
    return std::string(kinds[static_cast<std::size_t>(entity.dim)]) + std::to_string(entity.index + 1);
}

std::optional<Entity> entity_named(std::string_view name) {
    for (std::int32_t dim = 0; dim < 4; ++dim) {
        const std::string_view kind = kinds[static_cast<std::size_t>(dim)];
        if (!name.starts_with(kind)) continue;
        const char *begin = name.data() + kind.size(), *end = name.data() + name.size();
        std::int32_t number = 0;
        const auto [stop, error] = std::from_chars(begin, end, number);
        if (error == std::errc() && stop == end && number > 0) return Entity{dim, number - 1};
    }
    return {};
}

}  // namespace featuremesh
