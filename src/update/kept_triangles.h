// SPDX-License-Identifier: GPL-3.0-or-later
// What stays of free faces and edges, where no solid tells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "update/keep.h"

namespace featuremesh {

/// Free faces and edges of the old shape that the new one has just so, with all their edges and vertices: what changes
/// beside them is none of their business. By old face, then by old edge.
std::vector<char> untouched_entities(const KeepInput& input);

/// By old node: an element on such a face or edge has it.
std::vector<char> nodes_on(const KeepInput& input, std::span<const char> is_untouched);

/// By old node the motion that it is offered, where it is on a free face or edge: no volume tells what belongs to a
/// feature that moved. A face (or edge) goes with the motion under which fewest of its nodes are near what changed, the
/// identity first; a node of one that stays, near what changed, goes with the first motion under which it is not.
std::vector<std::int32_t> motions_without_tets(const KeepInput& input, std::span<const char> is_untouched,
                                               RunContext& context);

/// Triangles on free faces stay when all their nodes do, under one motion; on free edges nodes stay, and segments with
/// them.
class KeptShells {
  public:
    /// `motions` by old node: the index of its carried region, or dropped. `near_change` by old node, or empty: it
    /// stays for what is untouched only.
    KeptShells(const KeepInput& input, std::span<const std::int32_t> motions, std::span<const char> near_change,
               std::span<const char> is_untouched);

    bool is_kept(std::size_t triangle) const { return is_kept_[triangle] != 0; }
    /// A triangle on a free face around the old node, corner or mid-side, is kept, or it stays on a free edge.
    bool has_kept(std::size_t node) const { return is_used_[node] != 0; }

  private:
    std::vector<char> is_kept_, is_used_;
};

}  // namespace featuremesh
