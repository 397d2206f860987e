// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the solids that are not meshed yet: seeds, Delaunay, recovery, labels of regions, ODT, slivers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/message.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"
#include "volume/obstacle.h"

namespace featuremesh {

struct VolumeOptions {
    double target_dihedral_deg = 30;  ///< sliver removal works on tets below it (and above 180 minus it)
    int odt_sweeps = 3;               ///< over the nodes that gain
    bool splits_wall_tets = false;    ///< no tet is left whose corners all lie on two opposite walls
    bool is_for_curved_tets = false;  ///< the tets will follow curved faces, so nodes stay where the surface bends much
    bool moves_surface_nodes = true;  ///< new ones, for tets that nodes inside cannot help (boundary_moves.h)
    /// Smallest length that is asked for, mm, where the sizing has shorter ones for the mesher's own sake: these are no
    /// reason for smaller tets than are allowed otherwise.
    double smallest_asked = 0;
    /// Those inside, at an interface, where poor shapes gain much by that (relax_interfaces), and those of a surface
    /// that stay without a tet, for the worst angles there.
    bool moves_kept_nodes = false;
    bool looks_ahead_beside_kept = false;  ///< as everywhere in a full mesh
    /// Tets with next to no volume are no reason to refuse a part, where none is flat: a warning names them.
    bool takes_thin_tets = false;
    bool operator==(const VolumeOptions&) const = default;
};

struct VolumeReport {
    std::size_t new_nodes = 0, new_tets = 0;
    std::size_t recovered_triangles = 0,
                recovery_points =
                    0;  ///< boundary triangles missing at first; points added to get them back, most of them inside
    std::size_t released_tets = 0;  ///< kept tets that had to go so that the interface holds, or for the quality there
    std::size_t released_for_quality = 0;  ///< of these: those without which tets at the interface would be bad
    std::size_t released_for_shape = 0;    ///< likewise: those of kept nodes that were moved for better shapes
    std::size_t split_wall_tets = 0;
    double odt_energy_before = 0,
           odt_energy_after = 0;                       ///< sum of V S / 20 over the new tets (Alliez et al. 2005), mm^5
    std::size_t slivers_before = 0, slivers_left = 0;  ///< new tets below the target
    std::size_t large_cavities = 0;                    ///< optimised one after the other, each on all threads
    std::vector<Message> warnings;
};

/// Where something is missing in a mesh that is to be filled.
struct KeptRim {
    std::span<const char> nodes;  ///< by node: an element around it is not there; empty where that is not known
    std::span<const TetId> tets;  ///< all with such a node, ascending
    std::size_t kept_nodes = 0;   ///< the first so many nodes of the mesh are kept
};

struct VolumeResult {
    Mesh mesh;
    VolumeReport report = {};
    std::vector<TetId> released = {};                        ///< kept tets (as counted in the input) that were given up
    std::vector<std::array<NodeId, 4>> released_nodes = {};  ///< their nodes
    std::vector<NodeId> moved = {};      ///< inner kept nodes that are elsewhere now, with new numbers
    std::vector<Vec3> used_active = {};  ///< the start positions that were of use
};

/// Takes a 4-node mesh whose surface is complete and whose tets (if any) are kept; gives it back with every solid full.
/// Kept nodes keep their places in the arrays, and their bits but for the moved ones; kept tets stay in front in their
/// order but for the released ones. New nodes inside a CAD face may be moved along it. `active` are start positions for
/// inner nodes that survived without being kept. `rim` tells where something is not kept, which spares the search for
/// it (no nodes: searched). The same bytes for any number of threads. An obstacle where the boundary could not be
/// recovered; throws MeshError where the surface is none that can be filled.
std::variant<VolumeResult, Obstacle> try_fill_solids(const Brep& brep, const SizingField& sizing, Mesh surface,
                                                     std::span<const Vec3> active, const VolumeOptions& options,
                                                     RunContext& context, const KeptRim& rim = {});
/// The same; throws MeshError with what stands in the way.
VolumeResult fill_solids(const Brep& brep, const SizingField& sizing, Mesh surface, std::span<const Vec3> active,
                         const VolumeOptions& options, RunContext& context, const KeptRim& rim = {});

}  // namespace featuremesh
