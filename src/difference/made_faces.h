// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of the features' own volumes, each with what made it, and which of them a face of the final shape is part
// of.
#pragma once

#include <TopoDS_Face.hxx>
#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brep/face_probe.h"
#include "core/box_tree.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "difference/feature_difference.h"
#include "difference/underlying_geometry.h"
#include "features/feature_tree.h"

namespace featuremesh {

/// One line or curve of a sketch.
struct SketchElement {
    int id = 0;  ///< the same as long as the document is open, whatever is deleted before it; one sketch's own
    std::array<Vec3, 3> points;  ///< on it, the second in its middle
    std::optional<Vec3> centre;  ///< of a circle or an arc
};
/// Which element of which sketch: two sketches may use the same ids.
struct ElementName {
    std::string sketch;
    int id = 0;

    auto operator<=>(const ElementName&) const = default;
};
/// By name of the sketch, in its own frame.
using SketchElements = std::map<std::string, std::vector<SketchElement>>;

/// One face of one piece of one own volume.
struct MadeFace {
    int piece = 0;  ///< index into MadeFaces::pieces
    TopoDS_Face face;
    UnderlyingSurface underlying;
    FaceProbe probe;
    std::vector<ElementName>
        elements;       ///< sketch elements that it was swept from, sorted; none for a cap, or without a sketch
    double height = 0;  ///< of its middle along the sketch's normal, mm
};

/// One piece of one own volume: a hole of a sketch with six, an instance of a pattern.
struct MadePiece {
    FeatureId feature;
    std::int64_t instance = 0;  ///< number within a pattern
    std::vector<VolumeName> copied_from;
    int number = 0;      ///< among the pieces of that instance
    RigidMotion motion;  ///< as of its volume
    Effect effect = Effect::adds;
    TopoDS_Shape solid;
    std::vector<int> faces;             ///< indices into MadeFaces::faces, in the order of the solid
    std::vector<ElementName> elements;  ///< of all its faces, and those whose centres lie on their axes; sorted
};

class MadeFaces {
  public:
    MadeFaces(const PartState& state, const SketchElements& elements);

    const std::vector<MadeFace>& faces() const { return faces_; }
    const std::vector<MadePiece>& pieces() const { return pieces_; }
    const std::vector<int>& pieces_of(FeatureId feature) const { return pieces_of_[feature.index()]; }
    const PartState& state() const { return state_; }
    /// Indices of the made faces that hold points of the face of the final shape; asked once, then kept.
    const std::vector<int>& made(FaceId final_face) const;

    /// A sketch element where a volume was swept from it, or made about its centre.
    struct PlacedElement {
        ElementName name;
        SketchElement element;
        Vec3 normal;
        bool only_centre = false;
    };

  private:
    std::vector<PlacedElement> elements_of(const MadePiece& piece) const;
    void take_volume(FeatureId feature, const FeatureVolume& volume, int& number);
    std::vector<int> faces_near(const Box& box) const;
    bool bounds_the_same_way(const MadeFace& made, FaceId final_face, const Vec3& p) const;
    void keep_those_with_bounds(const Box& box, std::vector<int>& made) const;
    void find_elements(FeatureId feature);
    void give(const PlacedElement& placed, std::span<const int> pieces);

    const PartState& state_;
    const SketchElements& elements_;
    std::vector<MadeFace> faces_;
    std::vector<MadePiece> pieces_;
    std::vector<std::vector<int>> pieces_of_;                      // by FeatureId
    mutable std::vector<std::unique_ptr<std::vector<int>>> made_;  // by FaceId
    mutable std::optional<BoxTree> by_place_;                      // of faces_, made when it is asked for
};

/// The box of a face where a motion takes it.
Box box_after(const TopoDS_Face& face, const RigidMotion& motion);

/// Points of a face that are spread over it, at most 36.
std::vector<Vec3> points_over(const TopoDS_Face& face);

}  // namespace featuremesh
