// SPDX-License-Identifier: GPL-3.0-or-later
// A plane for a CAD face in which its surface is as little distorted as can be had in closed form.
#pragma once

#include <array>
#include <memory>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

/// A point of a chart, mm.
struct Vec2 {
    double x = 0, y = 0;
    constexpr bool operator==(const Vec2&) const = default;
};
constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Twice the signed area of the triangle (0, a, b).
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double distance(Vec2 a, Vec2 b) { return std::sqrt(dot(b - a, b - a)); }
/// Twice the signed area of the triangle.
constexpr double doubled_area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

/// Maps a face's parameters (u, v) one to one to a plane and to space, turning nothing over: planes as they are,
/// cylinders and cones developed, other surfaces with u and v each stretched to arc length (averaged over the face).
/// One object per thread: the kernel's adaptors cache.
class Chart {
  public:
    Chart(const Brep& brep, FaceId face);
    ~Chart();
    Chart(Chart&&) noexcept;

    Vec2 to_plane(std::array<double, 2> uv) const;
    std::array<double, 2> to_uv(Vec2 p) const;
    Vec3 point(Vec2 p) const;

    /// The surface at a point of the plane; derivatives by the plane's coordinates.
    struct Frame {
        Vec3 point, dx, dy;
    };
    Frame frame(Vec2 p) const;

    /// Whether lengths in the plane are those on the surface, within 3 %.
    /// A cone with its apex is not.
    bool is_isometric() const;
    bool is_plane() const;
    /// Sine of a cone's half angle, its apex being the chart's origin; 0 for other surfaces.
    double cone_sine() const;
    /// Whether the face as oriented in the shape has the opposite normal of its surface.
    bool is_reversed() const;
    /// The parameters moved by whole periods into the part of the surface that the face uses.
    std::array<double, 2> in_trim_period(std::array<double, 2> uv) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace featuremesh
