// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/volume_faces.h"

#include <BRepTools.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <optional>

#include "brep/face_trim.h"
#include "brep/occt_geometry.h"
#include "brep/solid_probe.h"
#include "core/ids.h"

namespace featuremesh {

namespace {

constexpr int points_across = 6;

/// Points spread evenly over the parameters of a face, and one inside it for certain. What costs most, whether one lies
/// in the trim, and the one inside, is found when it is asked for.
class SpreadPoints {
  public:
    explicit SpreadPoints(const TopoDS_Face& face) : face_(face), trim_(face) {
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        BRepTools::UVBounds(face, u1, u2, v1, v2);
        const BRepAdaptor_Surface surface(face, false);
        for (int i = 0; i < points_across; ++i)
            for (int j = 0; j < points_across; ++j) {
                const double u = u1 + (u2 - u1) * (i + 0.5) / points_across,
                             v = v1 + (v2 - v1) * (j + 0.5) / points_across;
                points_.push_back({to_vec3(surface.Value(u, v)), u, v});
            }
        is_in_trim_.resize(points_.size());
    }

    std::span<const SurfacePoint> all() const { return points_; }

    bool is_in_trim(std::size_t i) {
        if (!is_in_trim_[i]) is_in_trim_[i] = trim_.containment_of(points_[i].u, points_[i].v) == Containment::inside;
        return *is_in_trim_[i];
    }

    const std::optional<SurfacePoint>& inner() {
        if (!inner_) {
            inner_.emplace();
            if (const auto sound = point_on(face_)) *inner_ = SurfacePoint{sound->point, 0, 0};
        }
        return *inner_;
    }

  private:
    const TopoDS_Face& face_;
    std::vector<SurfacePoint> points_;
    std::vector<std::optional<bool>> is_in_trim_;
    FaceTrim trim_;
    std::optional<std::optional<SurfacePoint>> inner_;
};

/// Of faces on one underlying surface. Equal free-form surfaces have equal parameters, so that nothing need be
/// projected.
bool holds(const FaceProbe& face, SurfaceKind kind, const SurfacePoint& p) {
    if (!face.box().grown(boolean_tolerance).contains(p.point)) return false;
    return kind == SurfaceKind::free_form ? face.contains(p.u, p.v) : face.contains(p.point, boolean_tolerance);
}

/// Some point of the other face, which lies on the same underlying surface.
bool holds_any(const FaceProbe& face, SurfaceKind kind, SpreadPoints& points) {
    if (kind != SurfaceKind::free_form && points.inner() && holds(face, kind, *points.inner())) return true;
    for (std::size_t i = 0; i < points.all().size(); ++i)
        if (holds(face, kind, points.all()[i]) && points.is_in_trim(i)) return true;
    return false;
}

}  // namespace

std::vector<SurfacePoint> points_in_trim(const TopoDS_Face& face) {
    SpreadPoints points(face);
    std::vector<SurfacePoint> inside;
    for (std::size_t i = 0; i < points.all().size(); ++i)
        if (points.is_in_trim(i)) inside.push_back(points.all()[i]);
    return inside;
}

VolumeFaces::VolumeFaces(const FeatureTree& tree, const Vec3& reference)
    : reference_(reference), of_feature_(tree.features.size()), by_sort_key_(tree.features.size()) {
    for (std::size_t f = 0; f < tree.features.size(); ++f) {
        for (std::size_t v = 0; v < tree.features[f].volumes.size(); ++v)
            for (TopExp_Explorer it(tree.features[f].volumes[v].shape, TopAbs_FACE); it.More(); it.Next()) {
                const TopoDS_Face& face = TopoDS::Face(it.Current());
                of_feature_[f].push_back({{FeatureId(f), int(v)}, underlying_of(face), FaceProbe(face)});
                by_sort_key_[f].emplace_back(sort_key(of_feature_[f].back().underlying, reference),
                                             by_sort_key_[f].size());
            }
        std::sort(by_sort_key_[f].begin(), by_sort_key_[f].end());
    }
}

std::vector<const VolumeFaces::OwnedFace*> VolumeFaces::faces_of(std::size_t feature,
                                                                 const UnderlyingSurface& underlying,
                                                                 const Box& box) const {
    const Sameness sameness{boolean_tolerance, box.center(), 0.5 * box.diagonal()};
    // What is as near at the face as boolean_tolerance, and as parallel, may be further apart at the reference.
    const double window = 4 * boolean_tolerance *
                          (1 + distance(reference_, sameness.centre) / std::max(sameness.reach, boolean_tolerance));
    const double key = sort_key(underlying, reference_);
    const auto& keys = by_sort_key_[feature];
    std::vector<const OwnedFace*> found;
    for (auto it = std::lower_bound(keys.begin(), keys.end(), std::pair(key - window, std::size_t{0}));
         it != keys.end() && it->first <= key + window; ++it) {
        const OwnedFace& face = of_feature_[feature][it->second];
        // underlying surfaces first: only of those on the same one are the boxes made
        if (same_underlying(face.underlying, underlying, sameness) && face.probe.box().overlaps(box))
            found.push_back(&face);
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<Owner> VolumeFaces::owners_on(const TopoDS_Face& final_face, const Box& box,
                                          std::span<const char> is_wanted) const {
    const UnderlyingSurface underlying = underlying_of(final_face);
    bool has_wanted = false;
    for (std::size_t f = 0; f < of_feature_.size() && !has_wanted; ++f)
        has_wanted = is_wanted[f] && !faces_of(f, underlying, box).empty();
    if (!has_wanted) return {};
    std::vector<const OwnedFace*> candidates;
    for (std::size_t f = 0; f < of_feature_.size(); ++f)
        for (const OwnedFace* face : faces_of(f, underlying, box)) candidates.push_back(face);
    if (std::all_of(candidates.begin(), candidates.end(),
                    [&](const OwnedFace* face) { return face->owner == candidates.front()->owner; }))
        return {candidates.front()->owner};  // nobody else can have made the face
    SpreadPoints points(final_face);
    std::vector<Owner> owners;
    for (const OwnedFace* face : candidates)
        if (is_wanted[face->owner.feature.index()] && (owners.empty() || owners.back() != face->owner) &&
            holds_any(face->probe, underlying.kind, points))
            owners.push_back(face->owner);
    return owners;
}

}  // namespace featuremesh
