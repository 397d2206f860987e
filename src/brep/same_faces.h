// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces two shapes have in common.
#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <vector>

namespace featuremesh {

/// Faces of the solids of `shape` that those of `other` do not have, oriented as in their solid. The same face is the
/// same TShape in the same place, or, since sharing is lost when a document is saved, a face of the same kind with the
/// same border, inner point and direction of the material to 1e-9 of the size.
std::vector<TopoDS_Shape> unshared_faces(const TopoDS_Shape& shape, const TopoDS_Shape& other);

/// The faces, those in planes without their holes between lines and conics that edges of `others` border as well: such
/// a hole says nothing of what lies between faces of which some are in `faces` and some in `others`.
std::vector<TopoDS_Shape> without_common_holes(const std::vector<TopoDS_Shape>& faces,
                                               const std::vector<TopoDS_Shape>& others);

/// What tells a change of a shape by its vanished and its appeared faces: of each the surface's kind, its edges that no
/// face of the other kind has, and the direction of the material along them. On its underlying surface the difference
/// of the trims is bounded by those edges, so equal outlines bound the same volumes, whatever else became of the faces
/// elsewhere (a hole moved in a face from which a fillet takes a corner). Of a plane without such edges (a hole was
/// made in it) its place.
class ChangeOutline {
  public:
    ChangeOutline() = default;
    ChangeOutline(const std::vector<TopoDS_Shape>& vanished, const std::vector<TopoDS_Shape>& appeared);
    /// To 1e-9 of the size.
    bool matches(const ChangeOutline& other) const;

  private:
    struct Face {
        int kind = 0, points = 0;
        std::array<double, 12> moments{};  ///< first and second of the points of edges, first of the normals at them
    };
    static std::vector<Face> faces_of(const std::vector<TopoDS_Shape>& faces, const std::vector<TopoDS_Shape>& others,
                                      double& size);
    static bool match(const std::vector<Face>& a, const std::vector<Face>& b, double size);
    std::vector<Face> vanished_, appeared_;
    double size_ = 0;  ///< mm
};

}  // namespace featuremesh
