// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/booleans/glued_filler.h"

#include <BOPDS_DS.hxx>
#include <BOPDS_Iterator.hxx>
#include <BOPDS_Tools.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <map>
#include <vector>

#include "brep/face_probe.h"
#include "brep/occt_geometry.h"
#include "core/geometry.h"

namespace featuremesh {

namespace {

constexpr double generous = 10;  // times the kernel's own measure of what lies on a face: no pair is lost to rounding

/// Shapes whose boxes meet, but edges and vertices only with faces on whose surface they lie.
class PairsOnSurfaces : public BOPDS_Iterator {
  public:
    explicit PairsOnSurfaces(const BOPDS_Iterator& pairs) : BOPDS_Iterator(pairs) {
        leave(TopAbs_VERTEX);
        leave(TopAbs_EDGE);
    }

  private:
    void leave(TopAbs_ShapeEnum kind) {
        BOPDS_VectorOfPair& pairs = myLists(BOPDS_Tools::TypeToInteger(kind, TopAbs_FACE));
        BOPDS_VectorOfPair left;
        for (int i = 0; i < pairs.Length(); ++i) {
            int shape = 0, face = 0;
            pairs(i).Indices(shape, face);
            if (myDS->ShapeInfo(shape).ShapeType() == TopAbs_FACE) std::swap(shape, face);
            if (is_on_surface(myDS->Shape(shape), face)) left.Append(pairs(i));
        }
        pairs = left;
    }

    bool is_on_surface(const TopoDS_Shape& shape, int index) {
        const TopoDS_Face& face = TopoDS::Face(myDS->Shape(index));
        const FaceProbe& probe = probes_.try_emplace(index, face).first->second;
        for (const Vec3& p : points_of(shape))
            if (probe.distance_to_surface(p) > generous * (tolerance_of(shape) + BRep_Tool::Tolerance(face)))
                return false;
        return true;
    }

    static double tolerance_of(const TopoDS_Shape& shape) {
        return shape.ShapeType() == TopAbs_VERTEX ? BRep_Tool::Tolerance(TopoDS::Vertex(shape))
                                                  : BRep_Tool::Tolerance(TopoDS::Edge(shape));
    }

    static std::vector<Vec3> points_of(const TopoDS_Shape& shape) {
        if (shape.ShapeType() == TopAbs_VERTEX) return {to_vec3(BRep_Tool::Pnt(TopoDS::Vertex(shape)))};
        const BRepAdaptor_Curve curve(TopoDS::Edge(shape));
        if (!curve.Is3DCurve()) return {};
        std::vector<Vec3> points;
        const double first = curve.FirstParameter(), length = curve.LastParameter() - first;
        for (const double share : {0.5, 0.25, 0.75}) points.push_back(to_vec3(curve.Value(first + share * length)));
        return points;
    }

    std::map<int, FaceProbe> probes_;  // by the face's number
};

}  // namespace

GluedFiller::GluedFiller() { SetGlue(BOPAlgo_GlueShift); }

void GluedFiller::Init(const Message_ProgressRange& range) {
    BOPAlgo_PaveFiller::Init(range);
    if (HasErrors() || !myIterator) return;
    BOPDS_Iterator* all = myIterator;
    myIterator = new PairsOnSurfaces(*all);  // the kernel deletes it
    delete all;
}

}  // namespace featuremesh
