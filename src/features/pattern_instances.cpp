// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/pattern_instances.h"

#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "brep/face_probe.h"
#include "brep/occt_geometry.h"
#include "brep/same_faces.h"
#include "brep/solid_probe.h"
#include "core/geometry.h"
#include "features/pattern_placements.h"

namespace featuremesh {

namespace {

std::vector<FeatureVolume> instances(const std::vector<FeatureVolume>& originals, const Occurrences& occurrences) {
    std::vector<FeatureVolume> volumes;
    for (std::size_t i = 1; i < occurrences.size(); ++i)
        for (const FeatureVolume& original : originals) {
            FeatureVolume volume = original;
            volume.shape = placed(original.shape, occurrences[i].placement);
            volume.instance = occurrences[i].number;
            if (!occurrences[i].placement.IsNegative()) volume.motion = to_motion(occurrences[i].placement);
            volumes.push_back(std::move(volume));
        }
    return volumes;
}

/// Judges readings of a pattern's parameters against the shapes before and after it.
class PatternWitness {
  public:
    PatternWitness(const std::vector<FeatureVolume>& originals, const TopoDS_Shape& before, const TopoDS_Shape& after)
        : after_(after) {
        // Later originals may undo earlier ones, so only the last can be told from the outcome.
        if (!originals.empty()) inner_ = point_inside(originals.back().shape);
        if (!originals.empty())
            wanted_ = originals.back().step == Effect::adds ? Containment::inside : Containment::outside;
        for (const TopoDS_Shape& face : unshared_faces(before, after)) old_faces_.emplace_back(TopoDS::Face(face));
        for (const TopoDS_Shape& face : unshared_faces(after, before)) new_faces_.emplace_back(TopoDS::Face(face));
    }

    bool confirms(const Occurrences& occurrences, const std::vector<FeatureVolume>& volumes) const {
        if (!inner_) return false;
        for (const Occurrence& occurrence : occurrences)
            if (after_.containment_of(to_vec3(to_pnt(*inner_).Transformed(occurrence.placement))) != wanted_)
                return false;
        return explains_faces(volumes);
    }

  private:
    static bool any_carries(const std::vector<FaceProbe>& faces, const Vec3& p) {
        for (const FaceProbe& face : faces)
            if (face.box().grown(boolean_tolerance).contains(p) && face.distance_to_surface(p) < boolean_tolerance)
                return true;
        return false;
    }

    bool explains_faces(const std::vector<FeatureVolume>& volumes) const {
        std::vector<FaceProbe> sources;
        for (const FeatureVolume& volume : volumes)
            for (TopExp_Explorer it(volume.shape, TopAbs_FACE); it.More(); it.Next())
                sources.emplace_back(TopoDS::Face(it.Current()));
        for (const FaceProbe& face : new_faces_)
            if (face.inner_point() && !any_carries(old_faces_, *face.inner_point()) &&
                !any_carries(sources, *face.inner_point()))
                return false;
        return true;
    }

    SolidProbe after_;
    std::optional<Vec3> inner_;
    Containment wanted_ = Containment::inside;
    std::vector<FaceProbe> old_faces_, new_faces_;
};

}  // namespace

std::optional<std::vector<FeatureVolume>> pattern_instances(const RawRecord& pattern,
                                                            const std::vector<FeatureVolume>& originals,
                                                            const TopoDS_Shape& before, const TopoDS_Shape& after,
                                                            const DocumentView& document) {
    if (originals.empty() || before.IsNull() || after.IsNull()) return std::nullopt;
    try {
        const PatternWitness witness(originals, before, after);
        for (const Occurrences& occurrences : candidate_occurrences(pattern, document)) {
            std::vector<FeatureVolume> volumes = instances(originals, occurrences);
            if (witness.confirms(occurrences, volumes)) return volumes;
        }
    } catch (const Standard_Failure&) {  // what it did is told by its shapes alone, then
    }
    return std::nullopt;
}

}  // namespace featuremesh
