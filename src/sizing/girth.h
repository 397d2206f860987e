// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that go all the way round the material, as that of a rod does.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/message.h"
#include "sizing/size_provider.h"
#include "sizing/sizing_field.h"

class BRepAdaptor_Surface;

namespace featuremesh {

/// How far it is once round the material along a face.
class Girth {
  public:
    /// None where the face does not close round material, alone, with one that goes on from it on the same cylinder, or
    /// with others in a ring, all curved, of four edges and at least twice as long as it is round them.
    static std::optional<Girth> of(const Brep& brep, FaceId face, const BRepAdaptor_Surface& surface);

    /// At a place of the face, mm; at a tip a quarter of what it is where the face is widest.
    double at(const Vec3& p) const;
    double widest() const { return widest_; }

  private:
    explicit Girth(double everywhere) : widest_(everywhere) {}
    struct Ring {
        double length;
        Vec3 center;
    };
    explicit Girth(std::vector<Ring> rings);

    double widest_ = 0;
    std::vector<Ring> rings_;  ///< at even steps along the face; none where it is the same everywhere
};

/// Pieces round rods, whatever the smallest size is.
std::unique_ptr<SizeProvider> rod_provider(const Brep& brep, const SizingOptions& options);

/// What the user should know: where rods are thinner than the sizes asked for, so that elements are smaller.
std::vector<Message> warnings_of_thin_rods(const Brep& brep, const SizingOptions& options);

}  // namespace featuremesh
