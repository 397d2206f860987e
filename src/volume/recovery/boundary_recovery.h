// SPDX-License-Identifier: GPL-3.0-or-later
// Cavities filled with tets that meet their boundary.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "surface/projection.h"
#include "volume/cavity.h"
#include "volume/delaunay/triangulation.h"
#include "volume/fill_cavity.h"
#include "volume/fill_solids.h"
#include "volume/obstacle.h"
#include "volume/recovery/constrained_delaunay.h"
#include "volume/recovery/facet_split.h"
#include "volume/wanted_size.h"

namespace featuremesh {

/// Fills all cavities of a mesh, round by round. What is missing in one is brought back by the first of a few means
/// that can (docs/design/recovery.md), and filled again.
class BoundaryRecovery {
  public:
    /// References stay in use. The mesh's surface may get other diagonals and points.
    BoundaryRecovery(const Brep& brep, const Projector& projector, const WantedSize& size, std::span<const Vec3> active,
                     const KeptRim& rim, Mesh& mesh, VolumeReport& report, RunContext& context);

    /// Until every cavity is full, or what stands in the way of that. Throws MeshError where the mesh given is none
    /// that can be filled.
    std::optional<Obstacle> run();

    std::vector<Cavity> cavities;
    std::vector<CavityFill> fills;          ///< by cavity
    std::vector<std::uint8_t> is_released;  ///< by kept tet: it is given up
    std::vector<TetId> rim_tets;            ///< all kept tets at nodes where something is not kept
    std::vector<char> may_be_open;          ///< by node: something at it is not kept; empty where that is not known

    /// Kept tets that have to go before the facets are split.
    std::vector<TetId> in_the_way(const FacetSplit& split, const Cavity& cavity) const;
    /// The new nodes; none when kept tets were in the way and have been released instead.
    std::optional<std::vector<NodeId>> apply(const FacetSplit& split, const Cavity& cavity);

  private:
    /// What is missing in one cavity, and what has been found out about it.
    struct Gap {
        const Cavity& cavity;
        CavityFill& fill;
        int round;
        std::vector<Vec3> seeds;
        std::vector<int> stuck;   ///< facets that flips have not brought back; at first all that are missing
        bool are_many;            ///< so that constraints would add points by the thousand
        bool is_asked;            ///< TetGen did not bring them back
        std::vector<int> failed;  ///< facets that constraints have not brought back, if it is known which
        std::optional<Obstacle> obstacle;
    };
    /// Whether it dealt with the gap: the cavity is to be filled again, or cannot be.
    using Means = bool (BoundaryRecovery::*)(Gap& gap);
    static const std::vector<Means>& means_in_order();

    /// A filling from the round before, for a cavity of the same nodes, or for one that may have grown since.
    struct KnownFill {
        std::vector<NodeId> nodes;
        CavityFill fill;
    };
    /// A triangulation from the round before, for a cavity of the same nodes.
    struct KnownTriangulation {
        std::vector<NodeId> nodes;
        std::vector<Vec3> seeds;
        Triangulation triangulation;
        bool is_best;  ///< filling anew would give nothing better
    };

    bool fill_all(int round);
    void fill(std::size_t i);
    bool has_grown_from(const KnownFill& old, std::size_t i) const;
    void drop_seeds(std::size_t i, int round);
    void turn_missing(std::size_t i, int round);
    bool flip_flat_tets();
    std::optional<Obstacle> mend(int round);
    std::optional<Obstacle> recover(std::size_t i, int round);

    bool keep_whole_fill(Gap& gap);
    bool release_kept_tets(Gap& gap);
    bool refuse_flat_cavity(Gap& gap);
    bool change_diagonals(Gap& gap);
    bool refuse_open_surface(Gap& gap);
    bool halve_crossing(Gap& gap);
    bool ask_tetgen_first(Gap& gap);
    bool flip_if_many(Gap& gap);
    bool ask_tetgen_last(Gap& gap);
    bool constrain_locally(Gap& gap);
    bool constrain(Gap& gap);
    bool flip_if_few(Gap& gap);
    bool halve_stuck(Gap& gap);

    bool flip(Gap& gap);
    bool ask_tetgen(Gap& gap);
    bool take(Gap& gap, ConstrainedTriangulation constrained);
    void relocate(Gap& gap, ConstrainedTriangulation constrained);
    bool halve(Gap& gap, std::span<const int> facets, Obstacle obstacle);
    void release(TetId tet);
    int round_limit() const;
    void log(const char* what, std::size_t count) const;

    const Brep& brep_;
    const Projector& projector_;
    const WantedSize& size_;
    std::span<const Vec3> active_;
    Mesh& mesh_;
    VolumeReport& report_;
    RunContext& context_;
    bool is_rim_wider_ = false;                   ///< so that there may be more tets at it
    std::optional<std::span<const TetId>> near_;  ///< all kept tets at the cavities are among them; none: not known
    std::vector<KnownTriangulation> known_;
    std::vector<KnownFill> finished_;  ///< by relocated points; nothing outside
    std::vector<KnownFill> outgrown_;
    int halving_rounds_ = 0, constraining_rounds_ = 0;
    int last_halving_ = -1, last_constraining_ = -1, last_crossing_ = -1;  ///< rounds
    std::size_t crossing_ = 0, crossing_before_ = 0;  ///< triangles, in that round and in the one before it
};

}  // namespace featuremesh
