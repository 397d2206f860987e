// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/booleans/counted_filler.h"

#include <BOPDS_DS.hxx>
#include <BOPDS_Iterator.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <TopoDS.hxx>
#include <array>
#include <unordered_map>

namespace featuremesh {

namespace {

/// What counts for the price of an intersection. Splines of many poles are fine ones.
enum Form { straight, round, other, spline, fine_spline };

Form form_of(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    if (!curve.Is3DCurve()) return other;
    switch (curve.GetType()) {
        case GeomAbs_Line:
            return straight;
        case GeomAbs_Circle:
            return round;
        case GeomAbs_BSplineCurve:
        case GeomAbs_BezierCurve:
            return curve.NbPoles() > 30 ? fine_spline : spline;
        default:
            return other;
    }
}

Form form_of(const TopoDS_Face& face) {
    const BRepAdaptor_Surface surface(face, false);
    switch (surface.GetType()) {
        case GeomAbs_Plane:
            return straight;
        case GeomAbs_Cylinder:
        case GeomAbs_Cone:
        case GeomAbs_Sphere:
            return round;
        case GeomAbs_BSplineSurface:
        case GeomAbs_BezierSurface:
            return surface.NbUPoles() * surface.NbVPoles() > 60 ? fine_spline : spline;
        default:
            return other;
    }
}

Form form_of(const TopoDS_Shape& shape) {
    return shape.ShapeType() == TopAbs_EDGE ? form_of(TopoDS::Edge(shape)) : form_of(TopoDS::Face(shape));
}

/// By the forms of the two (see docs/measurements/work.md).
using Prices = std::array<std::array<Work, 5>, 5>;
constexpr Prices edge_and_edge{{{25, 60, 60, 50, 100},
                                {60, 150, 100, 100, 300},
                                {60, 100, 100, 200, 300},
                                {50, 100, 200, 240, 1500},
                                {100, 300, 300, 1500, 10000}}};
constexpr Prices edge_and_face{{{25, 80, 2500, 1500, 11500},
                                {100, 100, 2000, 5000, 2800},
                                {100, 100, 500, 3000, 9000},
                                {100, 150, 500, 3000, 3000},
                                {3000, 300, 3000, 3000, 10000}}};
constexpr Prices face_and_face{{{35, 430, 1000, 1300, 12000},
                                {430, 440, 4500, 6000, 4200},
                                {1000, 4500, 10000, 4000, 3000},
                                {1300, 6000, 4000, 7000, 36000},
                                {12000, 4200, 3000, 36000, 5000}}};

}  // namespace

/// Once for all pairs, before they are intersected.
void CountedFiller::pay_for(TopAbs_ShapeEnum one, TopAbs_ShapeEnum another) {
    if (limit_.IsNull() || !myIterator) return;
    const Prices& prices = one == TopAbs_FACE ? face_and_face : another == TopAbs_FACE ? edge_and_face : edge_and_edge;
    std::unordered_map<int, Form> known;
    const auto form = [&](int index) {
        const auto [entry, is_new] = known.try_emplace(index, straight);
        if (is_new) entry->second = form_of(myDS->Shape(index));
        return entry->second;
    };
    Work sum = 0;
    for (myIterator->Initialize(one, another); myIterator->More(); myIterator->Next()) {
        int first = 0, second = 0;
        myIterator->Value(first, second);
        if (myDS->ShapeInfo(first).ShapeType() != one) std::swap(first, second);
        sum += prices[form(first)][form(second)];
    }
    limit_->spend(sum);
}

void CountedFiller::PerformEE(const Message_ProgressRange& range) {
    pay_for(TopAbs_EDGE, TopAbs_EDGE);
    BOPAlgo_PaveFiller::PerformEE(range);
}

void CountedFiller::PerformEF(const Message_ProgressRange& range) {
    pay_for(TopAbs_EDGE, TopAbs_FACE);
    BOPAlgo_PaveFiller::PerformEF(range);
}

void CountedFiller::PerformFF(const Message_ProgressRange& range) {
    if (myGlue == BOPAlgo_GlueOff) pay_for(TopAbs_FACE, TopAbs_FACE);
    BOPAlgo_PaveFiller::PerformFF(range);
}

}  // namespace featuremesh
