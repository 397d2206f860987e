// SPDX-License-Identifier: GPL-3.0-or-later
// Carries nodal values (displacement, temperature) from one mesh to another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

enum class ValueSource : std::uint8_t {
    same_node,  ///< the old mesh has this node: its value, bit for bit
    inside,     ///< interpolated in an old element
    outside     ///< the value at the nearest point of the old boundary
};

struct TransferredField {
    std::vector<double> values;        ///< (new nodes, components), row by row
    std::vector<double> errors;        ///< likewise, an estimate in the field's unit; 0 where the node is the same
    std::vector<ValueSource> sources;  ///< by new node
};

/// `values` are (old nodes, components), row by row, in the old mesh's order of nodes.
///
/// A new node is the same as the old one of its number when no further from it than `same_place` (mm, 0 for the same
/// bits), or when an element of the same number has them both, with the same nodes, and is congruent: it was carried
/// along by a rigid motion (components of vectors are not turned). Where `same_place` is above 0, the old mesh may be
/// numbered anew: then the nearest old node no further than that is the same, too. In an element the value is u_h(x) =
/// sum N_i(x) u_i with the linear or quadratic shape functions; the error is |u_h(x) - u*(x)| with u*(x) = sum l_i (u_i
/// + g_i (x - x_i) / 2), l_i the barycentric coordinates, g_i the gradient at corner i recovered as the mean of those
/// of the elements around it, weighted by volume (Zienkiewicz and Zhu 1987). u* is exact for quadratic fields where the
/// g_i are. Outside, the error is |g (x - foot)|. Throws InputError when the sizes do not fit.
TransferredField transfer_field(const Mesh& old_mesh, const Mesh& new_mesh, std::span<const double> values,
                                double same_place, RunContext& context);

}  // namespace featuremesh
