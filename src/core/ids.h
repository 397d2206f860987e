// SPDX-License-Identifier: GPL-3.0-or-later
// Strong ids: a node is never mistaken for a tet, nor a CAD face for a CAD edge.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

namespace featuremesh {

/// Index of one thing of one kind, counted from 0; -1 is "none".
template <class Kind>
struct Id {
    std::int32_t value = -1;

    constexpr Id() = default;
    constexpr explicit Id(std::int32_t v) : value(v) {}
    constexpr explicit Id(std::size_t v) : value(static_cast<std::int32_t>(v)) {}
    constexpr bool is_valid() const { return value >= 0; }
    constexpr std::size_t index() const { return static_cast<std::size_t>(value); }
    constexpr auto operator<=>(const Id&) const = default;
};

using NodeId = Id<struct NodeKind>;
using TetId = Id<struct TetKind>;
using TriangleId = Id<struct TriangleKind>;

/// Entities of the final shape, in the order in which FreeCAD numbers them (FaceId 0 is "Face1").
using VertexId = Id<struct VertexKind>;
using EdgeId = Id<struct EdgeKind>;
using FaceId = Id<struct FaceKind>;
using SolidId = Id<struct SolidKind>;
/// What hangs together: a solid, or the faces that are joined by edges where a part of faces is meshed.
using BodyId = Id<struct BodyKind>;

using FeatureId = Id<struct FeatureKind>;
using CellId = Id<struct CellKind>;

/// The CAD entity a node lies on: dim 0 vertex, 1 edge, 2 face, 3 inside a solid; index counts within the dimension.
struct Entity {
    std::int32_t dim = 3;
    std::int32_t index = -1;
    constexpr auto operator<=>(const Entity&) const = default;
};

constexpr Entity entity_of(VertexId v) { return {0, v.value}; }
constexpr Entity entity_of(EdgeId e) { return {1, e.value}; }
constexpr Entity entity_of(FaceId f) { return {2, f.value}; }
constexpr Entity entity_of(SolidId s) { return {3, s.value}; }

}  // namespace featuremesh

template <class Kind>
struct std::hash<featuremesh::Id<Kind>> {
    std::size_t operator()(featuremesh::Id<Kind> id) const noexcept { return std::hash<std::int32_t>()(id.value); }
};
