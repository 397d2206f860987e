// SPDX-License-Identifier: GPL-3.0-or-later
// Which parameters of its surface a face has.
#pragma once

#include <memory>

#include "brep/solid_probe.h"

class TopoDS_Face;

namespace featuremesh {

/// Classifies parameters against the trim of a face, to 1e-9. What that takes is made when it is first asked for and
/// kept, so one trim serves many points but only one thread: for a plane between straight edges a polygon, for a
/// curved face whose edges are the borders of a rectangle of parameters (a bore, a fillet) that, else the kernel's
/// classifier, of each wire alone where there are many.
class FaceTrim {
  public:
    explicit FaceTrim(const TopoDS_Face& face);
    ~FaceTrim();
    FaceTrim(FaceTrim&&) noexcept;
    FaceTrim& operator=(FaceTrim&&) noexcept;

    Containment containment_of(double u, double v) const;
    /// Its border counts.
    bool has(double u, double v) const { return containment_of(u, v) != Containment::outside; }

  private:
    class Way;
    class Polygon;
    class Rectangle;
    class Wires;
    class Whole;
    std::unique_ptr<const TopoDS_Face> face_;
    mutable std::unique_ptr<Way> way_;
};

}  // namespace featuremesh
