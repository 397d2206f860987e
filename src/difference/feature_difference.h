// SPDX-License-Identifier: GPL-3.0-or-later
// What changed between two states of a part, feature by feature, and what may therefore be kept
// (Sypkens Smit and Bronsvoort 2007).
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brep/brep.h"
#include "cells/cell_model.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/message.h"
#include "core/run_context.h"
#include "features/feature_tree.h"

namespace featuremesh {

/// One state of a part as the difference needs it.
struct PartState {
    FeatureTree tree;
    Brep brep;
    CellModel cells;
};

enum class Verdict { same, moved, reshaped, added, removed, suppressed, interaction_changed };
std::string to_string(Verdict verdict);

struct FeatureChange {
    std::string name, label;
    Verdict verdict = Verdict::same;
    RigidMotion motion;                        ///< for `moved`
    double old_volume = 0, new_volume = 0;     ///< mm^3, of the feature's own volumes
    std::vector<FaceId> old_faces, new_faces;  ///< faces of the final shapes concerned
    Message detail;                            ///< in words: "moved by (5, 0, 0) mm", "radius 4 -> 5"
};

/// What became of one face or edge of the old or the new boundary.
enum class BoundaryVerdict { kept, vanished, appeared, trimmed_differently };
struct FaceChange {
    BoundaryVerdict verdict = BoundaryVerdict::kept;
    FaceId old_face, new_face;                 ///< none where there is no partner
    std::optional<double> old_area, new_area;  ///< mm^2, of faces that changed; see tell_areas
    bool inner = false;             ///< vanished into the material, or appeared out of it; see tell_inner_faces
    std::vector<FaceId> new_faces;  ///< all that overlap the old one, which may have been split
};

struct EdgeChange {
    BoundaryVerdict verdict = BoundaryVerdict::kept;
    EdgeId old_edge, new_edge;              ///< none where there is no partner
    double old_length = 0, new_length = 0;  ///< mm
    bool inner = false;                     ///< vanished into the material, or appeared out of it; see tell_inner_edges
};

/// How closely the changed boundary is looked at: the edge length of its triangles where a face is trimmed differently,
/// mm.
struct Resolution {
    Resolution(double everywhere) : finest(everywhere) {}
    /// `wanted` is asked for points in the new state's place and changes by at most `slope`, below a half, times a way
    /// over that way.
    Resolution(double finest_wanted, std::function<double(const Vec3&)> wanted, double most_slope = 0.5)
        : finest(finest_wanted), coarser(std::move(wanted)), slope(most_slope) {}
    double at(const Vec3& in_new_place) const { return coarser ? std::max(finest, coarser(in_new_place)) : finest; }

    double finest;
    std::function<double(const Vec3&)> coarser;  ///< none: the finest everywhere
    double slope = 0;
};

/// The part of either boundary that the other does not have, as triangles, conservative: every point of the symmetric
/// difference of the two boundaries, and of the edges that only one of them has, is on a triangle or no further from
/// one than a quarter of the resolution that was asked for. It reaches at most about one resolution beyond that
/// difference.
class ChangedBoundary {
  public:
    ChangedBoundary();
    explicit ChangedBoundary(std::vector<std::array<Vec3, 3>> triangles);
    /// Of underlying surfaces one after the other: `ends` has the number of triangles up to each surface's last.
    ChangedBoundary(std::vector<std::array<Vec3, 3>> triangles, std::span<const std::size_t> ends);
    /// Nothing was looked at outside the domain: all of that counts as changed.
    ChangedBoundary(std::vector<std::array<Vec3, 3>> triangles, const Box& domain);
    bool is_empty() const;
    std::span<const std::array<Vec3, 3>> triangles() const;
    /// Distance from p, mm; `limit` when it is not closer than that. Safe to call from several threads.
    double distance(const Vec3& p, double limit) const;
    /// Whether it is closer to p than `reach`, mm: the same question without the number, which costs less.
    bool is_within(double reach, const Vec3& p) const;
    /// The same of what changed on one of the underlying surfaces alone.
    bool is_within(double reach, const Vec3& p, std::size_t surface) const;
    /// Holds everything that is changed: all of space when there is a domain.
    Box box() const;

  private:
    struct Tree;
    std::shared_ptr<const Tree> tree_;
};

/// Everything that may be carried by one rigid motion from the old to the new state.
struct CarriedRegion {
    RigidMotion motion;                 ///< the first region's is the identity
    std::vector<std::string> features;  ///< that moved with it; all that stayed for the identity
    /// Old volumes (additive, moved rigidly by `motion`) whose material prefers this motion; empty for the identity.
    std::vector<TopoDS_Shape> volumes;
    /// In the new state's place: old boundary under the motion against the new one. All of space for another motion
    /// than the identity that carries no volume.
    ChangedBoundary changed;
    std::vector<int> surface_of_old_face;  ///< by FaceId, among those of `changed`; for the identity only
    std::vector<FaceId>
        new_face_of;  ///< by old FaceId: the new face on the same underlying surface under the motion; none
    std::vector<EdgeId> new_edge_of;      ///< by old EdgeId, same curve under the motion (trims may differ); none
    std::vector<VertexId> new_vertex_of;  ///< by old VertexId; none
    /// All new faces (edges) that overlap the old one, the likeliest first, so that [0] is the one above: a face may
    /// have been split.
    std::vector<std::vector<FaceId>> new_faces_of;
    std::vector<std::vector<EdgeId>> new_edges_of;
};

struct FeatureDifference {
    std::vector<FeatureChange> features;
    std::vector<FaceChange> faces;
    std::vector<CarriedRegion> regions;  ///< identity first
    std::vector<Message> notes;          ///< e.g. "the two parts look unrelated"
    bool is_empty() const;               ///< nothing changed at all
};

/// For reports: which of the vanished faces now lie inside the material (the boundary became inner), and which of the
/// appeared ones did before (inner became boundary), by a point of each.
void tell_inner_faces(std::vector<FaceChange>& faces, const Brep& old_shape, const Brep& new_shape);

/// For reports: the areas of faces that changed.
void tell_areas(std::vector<FaceChange>& faces, const Brep& old_shape, const Brep& new_shape);

/// What became of every edge, from the partners in the difference's first region. Poles are left out.
std::vector<EdgeChange> edge_changes(const FeatureDifference& difference, const Brep& old_shape, const Brep& new_shape);

/// For reports: which of the vanished edges now lie inside the material, and which of the appeared ones did before.
void tell_inner_edges(std::vector<EdgeChange>& edges, const Brep& old_shape, const Brep& new_shape);

FeatureDifference compare(const PartState& old_state, const PartState& new_state, const Resolution& resolution,
                          RunContext& context);

}  // namespace featuremesh
