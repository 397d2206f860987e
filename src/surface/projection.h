// SPDX-License-Identifier: GPL-3.0-or-later
// Points on CAD edges and faces, and the nearest ones.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

struct OnEdge {
    Vec3 point;
    double t = 0;
    double distance = 0;  ///< from where it was asked, mm
};
struct OnFace {
    Vec3 point;
    std::array<double, 2> uv{};
    double distance = 0;  ///< from where it was asked, mm
};

/// A place on an edge, (t, 0), or on a face, (u, v).
struct OnEntity {
    Vec3 point;
    std::array<double, 2> parameters;
};

/// Evaluates and projects on the entities of one Brep. One object per thread: the kernel's adaptors cache.
class Projector {
  public:
    explicit Projector(const Brep& brep);
    ~Projector();
    Projector(Projector&&) noexcept;
    /// Of the same Brep, for another thread.
    Projector another() const;

    Vec3 on_edge(EdgeId edge, double t) const;
    /// The edge's first and last parameter.
    std::array<double, 2> range(EdgeId edge) const;
    /// The parameter half way between two parameters in arc length.
    double half_way(EdgeId edge, double from, double to) const;
    /// Unit tangent; zero where the edge has none.
    Vec3 tangent(EdgeId edge, double t) const;
    Vec3 on_face(FaceId face, std::array<double, 2> uv) const;
    /// The parameters half way between two, the shorter way round.
    std::array<double, 2> half_way(FaceId face, std::array<double, 2> from, std::array<double, 2> to) const;
    /// Nearest point of the trimmed edge; `guess` starts a Newton iteration that falls back to the global search.
    OnEdge nearest(EdgeId edge, const Vec3& p, std::optional<double> guess = {}) const;
    /// Whether the nearest point of the face's surface takes a search; that of a plane, a cylinder, a cone, a sphere or
    /// a torus is known at once.
    bool needs_search(FaceId face) const;
    /// Whether the face's surface meets itself: points there have two places in its parameters.
    bool closes(FaceId face) const;
    /// Nearest point of the face's surface; with a guess by Newton, else globally. Does not look at the trim.
    OnFace nearest(FaceId face, const Vec3& p, std::optional<std::array<double, 2>> guess = {}) const;
    /// The same, for a short step from `guess`: none where Newton's iteration does not get there.
    std::optional<OnFace> nearest_by_steps(FaceId face, const Vec3& p, std::array<double, 2> guess) const;
    /// The same on an edge or a face; on an edge never none.
    std::optional<OnEntity> nearest_by_steps(Entity entity, const Vec3& p, std::array<double, 2> guess) const;
    /// Whether (u, v) is inside the face's trim or on its boundary within tolerance.
    bool is_inside_trim(FaceId face, std::array<double, 2> uv) const;
    /// Unit normal of the face as oriented in the shape.
    Vec3 normal(FaceId face, std::array<double, 2> uv) const;
    /// The part of a direction that lies along the edge or in the face there.
    Vec3 along(Entity entity, std::array<double, 2> parameters, const Vec3& direction) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace featuremesh
