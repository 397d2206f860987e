// SPDX-License-Identifier: GPL-3.0-or-later
// The tets that are worked on, with what may be done to each vertex and where on the CAD shape it may go.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "surface/projection.h"
#include "volume/improvement/objective.h"
#include "volume/improvement/operation.h"
#include "volume/tets/cavity_editor.h"
#include "volume/tets/tet_complex.h"

namespace featuremesh {

/// A vertex inside a CAD face, or inside an edge between two faces, whose tets are all in the complex.
struct SurfaceVertex {
    int vertex;
    Entity on;
    std::array<double, 2> parameters;  ///< (t, 0) on an edge, (u, v) on a face
    bool is_kept = false;              ///< a node that stays, unless it moves
};

/// The surface on which some vertices may move. Without a projector none may.
struct MovableSurface {
    std::vector<SurfaceVertex> vertices{};
    const Projector* projector = nullptr;
    /// The tets will follow the surface. Where it bends much no vertex moves: other sides may fold such tets.
    bool is_for_curved_tets = false;
};

class LocalMesh {
  public:
    /// Vertices of the surface are `on_edge` or `on_face` from now on; `release_surface` fixes them again.
    explicit LocalMesh(TetComplex& complex, MovableSurface surface = {});

    const TetComplex& complex() const { return complex_; }
    const MovableSurface& surface() const { return surface_; }
    /// The vertices of the surface where they are now. They are fixed from now on.
    std::vector<SurfaceVertex> release_surface();

    /// A triangle of the surface at a vertex, whose other corners are `a` and `b`.
    struct RimTriangle {
        Vec3 a, b, normal;  ///< the unit normal, where the vertex is now
    };
    /// All tets of a vertex that may move, and the triangles at it.
    struct Star {
        std::vector<int> tets;
        std::vector<RimTriangle> rim;
        double most_cosine = 1;  ///< of the angles of these triangles: as sharp as now, or as is good enough
    };
    bool gather(int vertex, Star& star) const;

    Price price_of_moving(int vertex) const;
    bool is_on_surface(int vertex) const { return place_of(vertex) >= 0; }
    const SurfaceVertex* surface_vertex(int vertex) const {
        return is_on_surface(vertex) ? &surface_.vertices[static_cast<std::size_t>(place_of(vertex))] : nullptr;
    }
    // Each thread has a projector of its own; none is needed where no vertex of the surface moves.
    /// Unit vectors along which a vertex may go: in space, in the tangent plane or along the edge.
    std::vector<Vec3> ways_from(int vertex, const Star& star, const Projector* projector) const;
    /// The part of a way that the vertex may go.
    Vec3 along(int vertex, const Vec3& way, const Projector* projector) const;
    /// Nearest to `aim` on what the vertex lies on, whose borders are not looked at. None where a short step does not
    /// get there.
    std::optional<Change::Move> place_near(int vertex, const Vec3& aim, const Projector* projector) const;
    /// The vertex does not leave its face by its borders.
    bool stays_within(const Change::Move& move, const Projector* projector) const;
    /// The triangles of the surface do not turn over, and their angles stay as good, or good enough.
    static bool keeps_triangles(const Star& star, const Vec3& to);
    /// The star's volume stays within half a percent: on a curved face other triangles cut off more of it, or less.
    bool keeps_volume(int vertex, const Star& star, const Vec3& to) const;
    /// The vertex stays where it is, for the sake of tets that will follow a face: triangles of the star on one face
    /// lie at more than 60 degrees to one another.
    bool is_held(int vertex, const Star& star) const;

    /// Makes the change. Gives the tets that are new or bent, until the next call.
    std::span<const int> apply(const Change& change);

    /// Counts changes. A vertex has changed when its star has.
    std::uint32_t now() const { return now_; }
    std::uint32_t changed_at(int vertex) const { return changed_at_[static_cast<std::size_t>(vertex)]; }
    /// A tet has changed when it has been replaced or bent.
    std::uint32_t tet_changed_at(int tet) const { return tet_changed_at_[static_cast<std::size_t>(tet)]; }
    /// Whether one of these tets has been replaced or bent since then.
    bool has_changed(std::span<const int> tets, std::uint32_t since) const;
    bool has_moved(int vertex) const { return has_moved_[static_cast<std::size_t>(vertex)] != 0; }

  private:
    int place_of(int vertex) const {
        return vertex < static_cast<int>(place_of_.size()) ? place_of_[static_cast<std::size_t>(vertex)] : -1;
    }
    void measure_rim(int vertex, Star& star) const;

    TetComplex& complex_;
    MovableSurface surface_;
    CavityEditor editor_;
    std::vector<int> place_of_;                  // by vertex: in the surface's vertices; -1 for none
    std::vector<std::uint32_t> changed_at_;      // by vertex
    std::vector<std::uint32_t> tet_changed_at_;  // by tet
    std::vector<std::uint8_t> has_moved_;
    std::uint32_t now_ = 1;
    std::vector<int> changed_;
};

}  // namespace featuremesh
