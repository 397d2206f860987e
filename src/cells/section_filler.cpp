// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/section_filler.h"

#include <BOPDS_DS.hxx>
#include <BOPDS_FaceInfo.hxx>
#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace featuremesh {

namespace {

constexpr double turn = 2 * std::numbers::pi;

using Stretch = std::pair<double, double>;  // from, to: parameters of a section

/// A piece of an edge as a stretch of the section that it runs along.
void add_stretch(std::vector<Stretch>& stretches, const gp_Lin& section, const GeomAdaptor_Curve& piece,
                 double tolerance) {
    if (piece.GetType() != GeomAbs_Line) return;
    const gp_Pnt first = piece.Value(piece.FirstParameter()), last = piece.Value(piece.LastParameter());
    if (section.Distance(first) > tolerance || section.Distance(last) > tolerance) return;
    stretches.push_back(std::minmax({ElCLib::Parameter(section, first), ElCLib::Parameter(section, last)}));
}

/// On the first two turns, so that a stretch over the start of the circle is there as well.
void add_stretch(std::vector<Stretch>& stretches, const gp_Circ& section, const GeomAdaptor_Curve& piece,
                 double tolerance) {
    if (piece.GetType() != GeomAbs_Circle) return;
    const gp_Circ circle = piece.Circle();
    const gp_Vec axis(section.Axis().Direction()), other(circle.Axis().Direction());
    const double error = section.Location().Distance(circle.Location()) + std::abs(section.Radius() - circle.Radius()) +
                         axis.Crossed(other).Magnitude() * section.Radius();
    if (error > tolerance) return;
    const double start = axis * other > 0 ? piece.FirstParameter() : piece.LastParameter();
    const double from = ElCLib::Parameter(section, piece.Value(start));  // within [0, turn)
    const double length = piece.LastParameter() - piece.FirstParameter();
    for (const double begin : {from - turn, from, from + turn}) stretches.emplace_back(begin, begin + length);
}

bool do_cover(std::vector<Stretch>& stretches, Stretch whole, double slack) {
    std::sort(stretches.begin(), stretches.end());
    double end = whole.first;
    for (const auto& [first, last] : stretches)
        if (first <= end + slack) end = std::max(end, last);
    return end >= whole.second - slack;
}

/// Sections of two faces, which both have some pieces of edges.
class KnownSections {
  public:
    KnownSections(const BOPDS_DS& shapes, int face, int other) : shapes_(shapes) {
        const BOPDS_FaceInfo *few = &shapes.FaceInfo(face), *many = &shapes.FaceInfo(other);
        if (count(*few) > count(*many)) std::swap(few, many);
        for (const auto* blocks : {&few->PaveBlocksOn(), &few->PaveBlocksIn()})
            for (int i = 1; i <= blocks->Extent(); ++i)
                if (many->PaveBlocksOn().Contains((*blocks)(i)) || many->PaveBlocksIn().Contains((*blocks)(i)))
                    add((*blocks)(i));
    }

    bool cover(const BOPDS_Curve& section) const {
        if (pieces_.empty() || !section.Curve().HasBounds()) return false;
        const GeomAdaptor_Curve curve(section.Curve().Curve());
        const double tolerance = std::max(tolerance_, section.Tolerance());
        std::vector<Stretch> stretches;
        if (curve.GetType() == GeomAbs_Line) {
            for (const auto& piece : pieces_) add_stretch(stretches, curve.Line(), piece, tolerance);
            return do_cover(stretches, {curve.FirstParameter(), curve.LastParameter()}, tolerance);
        }
        if (curve.GetType() == GeomAbs_Circle) {
            for (const auto& piece : pieces_) add_stretch(stretches, curve.Circle(), piece, tolerance);
            return do_cover(stretches, {curve.FirstParameter(), curve.LastParameter()},
                            tolerance / curve.Circle().Radius());
        }
        return false;
    }

  private:
    static int count(const BOPDS_FaceInfo& face) { return face.PaveBlocksOn().Extent() + face.PaveBlocksIn().Extent(); }

    void add(const Handle(BOPDS_PaveBlock) & block) {
        const TopoDS_Edge& edge = TopoDS::Edge(shapes_.Shape(block->OriginalEdge()));
        double first = 0, last = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (curve.IsNull()) return;
        block->Range(first, last);
        pieces_.emplace_back(curve, first, last);
        tolerance_ = std::max(tolerance_, BRep_Tool::Tolerance(edge));
    }

    const BOPDS_DS& shapes_;
    std::vector<GeomAdaptor_Curve> pieces_;
    double tolerance_ = 0;
};

}  // namespace

void SectionFiller::PerformFF(const Message_ProgressRange& range) {
    CountedFiller::PerformFF(range);
    for (int i = 0; i < myDS->InterfFF().Length(); ++i) {
        BOPDS_InterfFF& found = myDS->InterfFF()(i);
        if (found.Curves().IsEmpty()) continue;
        int face = 0, other = 0;
        found.Indices(face, other);
        const KnownSections known(*myDS, face, other);
        bool are_known = true;
        for (int c = 0; c < found.Curves().Length() && are_known; ++c) are_known = known.cover(found.Curves()(c));
        if (are_known) found.ChangeCurves().Clear();
    }
}

}  // namespace featuremesh
