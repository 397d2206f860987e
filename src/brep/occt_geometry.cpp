// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/occt_geometry.h"

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

namespace featuremesh {

namespace {

/// Does the kernel's box hold all of a surface of this type? For the other types it holds a grid of 33 by 33 points of
/// the surface, but not what bulges between these.
bool has_sure_box(GeomAbs_SurfaceType type) { return type <= GeomAbs_Torus || type == GeomAbs_BSplineSurface; }

/// A grid of points on a surface, and for each coordinate how far the surface may bulge beyond them: half of the
/// largest second difference along the rows and along the columns. A curve through the points stays within that, smooth
/// or with corners.
class SampledSurface {
  public:
    explicit SampledSurface(const BRepAdaptor_Surface& surface) {
        const bool is_swept = surface.GetType() == GeomAbs_SurfaceOfExtrusion,
                   is_turned = surface.GetType() == GeomAbs_SurfaceOfRevolution;
        const auto along_curve = [](int intervals) { return std::clamp(8 * intervals, 64, 1000); };
        const auto along_others = [](int intervals) { return std::clamp(8 * intervals, 32, 128); };
        const int in_u = surface.NbUIntervals(GeomAbs_C2), in_v = surface.NbVIntervals(GeomAbs_C2);
        const int columns = is_swept ? along_curve(in_u) : along_others(in_u);
        rows_ = is_swept ? 1 : is_turned ? along_curve(in_v) : along_others(in_v);
        const double u = surface.FirstUParameter(), v = surface.FirstVParameter();
        const double du = (surface.LastUParameter() - u) / columns, dv = (surface.LastVParameter() - v) / rows_;
        for (int i = 0; i <= columns; ++i)
            for (int j = 0; j <= rows_; ++j) points_.push_back(surface.Value(u + i * du, v + j * dv));
    }

    Bnd_Box box() const {
        Bnd_Box box;
        for (const gp_Pnt& p : points_) box.Add(p);
        const gp_Vec reach = bulge(rows_ + 1, 0) + bulge(1, rows_ + 1);
        Bnd_Box grown;
        grown.Add(box.CornerMin().Translated(-reach));
        grown.Add(box.CornerMax().Translated(reach));
        return grown;
    }

  private:
    /// Of points a step apart, in lines of so many points; in one line if `line` is 0.
    gp_Vec bulge(int step, int line) const {
        gp_XYZ most;
        const int count = static_cast<int>(points_.size());
        for (int i = step; i + step < count; ++i) {
            if (line > 0 && (i % line == 0 || i % line == line - 1)) continue;
            const gp_XYZ second = points_[i - step].XYZ() - 2 * points_[i].XYZ() + points_[i + step].XYZ();
            for (int k = 1; k <= 3; ++k) most.SetCoord(k, std::max(most.Coord(k), 0.5 * std::abs(second.Coord(k))));
        }
        return most;
    }

    int rows_ = 1;
    std::vector<gp_Pnt> points_;
};

void add_face_bounds(const TopoDS_Face& face, Bnd_Box& bounds) {
    if (has_sure_box(BRepAdaptor_Surface(face, false).GetType())) return BRepBndLib::Add(face, bounds, false);
    Bnd_Box box = SampledSurface(BRepAdaptor_Surface(face)).box();
    box.Enlarge(BRep_Tool::Tolerance(face));
    bounds.Add(box);
}

}  // namespace

void add_bounds(const TopoDS_Shape& shape, Bnd_Box& bounds) {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
        add_face_bounds(TopoDS::Face(it.Current()), bounds);
    for (TopExp_Explorer it(shape, TopAbs_EDGE, TopAbs_FACE); it.More(); it.Next())
        BRepBndLib::Add(it.Current(), bounds, false);
    for (TopExp_Explorer it(shape, TopAbs_VERTEX, TopAbs_EDGE); it.More(); it.Next())
        BRepBndLib::Add(it.Current(), bounds, false);
}

std::vector<TopoDS_Edge> border_of(const TopoDS_Face& face) {
    std::vector<TopoDS_Edge> border;
    for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next())
        if (it.Current().Orientation() == TopAbs_FORWARD || it.Current().Orientation() == TopAbs_REVERSED)
            border.push_back(TopoDS::Edge(it.Current()));
    return border;
}

Box box_of(const TopoDS_Shape& shape) {
    Bnd_Box bounds;
    add_bounds(shape, bounds);
    return to_box(bounds);
}

}  // namespace featuremesh
