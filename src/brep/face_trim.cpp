// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/face_trim.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box2d.hxx>
#include <ElSLib.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "brep/occt_geometry.h"
#include "core/geometry.h"

namespace featuremesh {

namespace {

using Uv = std::array<double, 2>;

constexpr double on_border = 1e-9;  ///< in parameters, as the kernel's own classifier has it

Containment of_state(TopAbs_State state) {
    return state == TopAbs_IN ? Containment::inside : state == TopAbs_OUT ? Containment::outside : Containment::on;
}

struct Range2 {
    Uv low{1e300, 1e300}, high{-1e300, -1e300};
    void add(const Uv& p) {
        for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    double size(std::size_t k) const { return high[k] - low[k]; }
};

}  // namespace

class FaceTrim::Way {
  public:
    virtual ~Way() = default;
    virtual Containment of(const Uv& p) = 0;
};

class FaceTrim::Polygon : public Way {
  public:
    /// None where an edge is not straight, or does not end at its vertices.
    static std::unique_ptr<Polygon> of_plane(const TopoDS_Face& face, const gp_Pln& plane) {
        auto polygon = std::make_unique<Polygon>();
        for (const TopoDS_Edge& edge : border_of(face)) {
            TopLoc_Location place;
            double first = 0, last = 0;
            const Handle(Geom_Curve)& curve = BRep_Tool::Curve(edge, place, first, last);
            if (curve.IsNull() || curve->DynamicType() != STANDARD_TYPE(Geom_Line)) return nullptr;
            TopoDS_Vertex from, to;
            TopExp::Vertices(edge, from, to);
            if (from.IsNull() || to.IsNull()) return nullptr;
            const std::array<gp_Pnt, 2> ends{BRep_Tool::Pnt(from), BRep_Tool::Pnt(to)};
            const std::array<double, 2> t{first, last};
            std::array<Uv, 2> side;
            for (std::size_t k = 0; k < 2; ++k) {
                if (curve->Value(t[k]).Transformed(place).Distance(ends[k]) > Precision::Confusion()) return nullptr;
                ElSLib::Parameters(plane, ends[k], side[k][0], side[k][1]);
            }
            polygon->sides_.push_back(side);
        }
        return polygon->sides_.size() < 3 ? nullptr : std::move(polygon);
    }

    Containment of(const Uv& p) override {
        bool is_inside = false;
        for (const auto& [a, b] : sides_) {
            const Uv along{b[0] - a[0], b[1] - a[1]}, to{p[0] - a[0], p[1] - a[1]};
            const double squared = along[0] * along[0] + along[1] * along[1],
                         share =
                             squared > 0 ? std::clamp((to[0] * along[0] + to[1] * along[1]) / squared, 0.0, 1.0) : 0;
            if (std::hypot(to[0] - share * along[0], to[1] - share * along[1]) <= on_border) return Containment::on;
            if ((a[1] > p[1]) != (b[1] > p[1]) && to[0] < along[0] * to[1] / along[1]) is_inside = !is_inside;
        }
        return is_inside ? Containment::inside : Containment::outside;
    }

  private:
    std::vector<std::array<Uv, 2>> sides_;
};

class FaceTrim::Rectangle : public Way {
  public:
    /// None where an edge is no part of the border of the rectangle that holds all, or where these leave some of it
    /// out.
    static std::unique_ptr<Rectangle> of_curved(const TopoDS_Face& face, const BRepAdaptor_Surface& surface) {
        std::vector<std::array<Uv, 2>> traces;
        Range2 range;
        for (const TopoDS_Edge& edge : border_of(face)) {
            double first = 0, last = 0;
            const Handle(Geom2d_Curve) trace = BRep_Tool::CurveOnSurface(edge, face, first, last);
            if (trace.IsNull() || trace->DynamicType() != STANDARD_TYPE(Geom2d_Line)) return nullptr;
            const gp_Pnt2d from = trace->Value(first), to = trace->Value(last);
            traces.push_back({{{from.X(), from.Y()}, {to.X(), to.Y()}}});
            for (const Uv& end : traces.back()) range.add(end);
        }
        std::array<Uv, 2> covered{};  // of the lower and the upper side, by the parameter that is the same all along
        for (const auto& [a, b] : traces) {
            const std::size_t same = std::abs(b[0] - a[0]) <= on_border ? 0 : 1;
            const bool is_low = is_at(a, b, same, range.low[same]);
            if (!is_low && !is_at(a, b, same, range.high[same])) return nullptr;
            covered[same][is_low ? 0 : 1] += std::abs(b[1 - same] - a[1 - same]);
        }
        for (std::size_t same = 0; same < 2; ++same)
            for (const double length : covered[same])
                if (!(std::abs(length - range.size(1 - same)) <= 1e-7 * range.size(1 - same))) return nullptr;
        auto rectangle = std::make_unique<Rectangle>();
        rectangle->range_ = range;
        rectangle->period_ = {surface.IsUPeriodic() ? surface.UPeriod() : 0,
                              surface.IsVPeriodic() ? surface.VPeriod() : 0};
        return rectangle;
    }

    Containment of(const Uv& p) override {
        Containment where = Containment::inside;
        for (std::size_t k = 0; k < 2; ++k) {
            const double middle = 0.5 * (range_.low[k] + range_.high[k]), off = p[k] - middle,
                         near = period_[k] > 0 ? off - period_[k] * std::round(off / period_[k]) : off,
                         beyond = std::abs(near) - 0.5 * range_.size(k);
            if (beyond > on_border) return Containment::outside;
            if (beyond >= -on_border) where = Containment::on;
        }
        return where;
    }

  private:
    static bool is_at(const Uv& a, const Uv& b, std::size_t k, double value) {
        return std::abs(a[k] - value) <= on_border && std::abs(b[k] - value) <= on_border;
    }
    Range2 range_;
    Uv period_{};  ///< 0: none
};

/// A point that is far from the box of a wire need not be looked for within it. Of a plate with a thousand holes that
/// saves most of the time.
class FaceTrim::Wires : public Way {
  public:
    static bool pays_for(const TopoDS_Face& face) { return face.NbChildren() >= 16; }

    explicit Wires(const TopoDS_Face& face) {
        TopLoc_Location place;
        const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
        for (TopoDS_Iterator it(face.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
            const TopAbs_Orientation orientation = it.Value().Orientation();
            if (it.Value().ShapeType() != TopAbs_WIRE ||
                (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED))
                continue;
            Wire& wire = wires_.emplace_back();
            BRep_Builder builder;
            builder.MakeFace(wire.face, surface, place, BRep_Tool::Tolerance(face));
            builder.Add(wire.face, it.Value());
            Bnd_Box2d box;
            BRepTools::AddUVBounds(face, TopoDS::Wire(it.Value()), box);
            box.Get(wire.box.low[0], wire.box.low[1], wire.box.high[0], wire.box.high[1]);
        }
        const auto area = [](const Wire& w) { return w.box.size(0) * w.box.size(1); };
        const auto outer = std::max_element(wires_.begin(), wires_.end(),
                                            [&](const Wire& a, const Wire& b) { return area(a) < area(b); });
        std::iter_swap(wires_.begin(), outer);
    }

    Containment of(const Uv& p) override {
        if (!is_near(wires_.front(), p)) return Containment::outside;
        Containment where = Containment::inside;
        for (Wire& wire : wires_) {
            if (!is_near(wire, p)) continue;
            if (!wire.trim) wire.trim.emplace(wire.face, on_border);
            const TopAbs_State state = wire.trim->Perform(gp_Pnt2d(p[0], p[1]));
            if (state == TopAbs_OUT) return Containment::outside;
            if (state != TopAbs_IN) where = Containment::on;
        }
        return where;
    }

  private:
    struct Wire {
        TopoDS_Face face;  ///< with this wire alone
        Range2 box;
        std::optional<BRepTopAdaptor_FClass2d> trim;
    };
    static bool is_near(const Wire& wire, const Uv& p) {
        const double margin = 1e-6 * (1 + wire.box.size(0) + wire.box.size(1));
        return p[0] > wire.box.low[0] - margin && p[0] < wire.box.high[0] + margin && p[1] > wire.box.low[1] - margin &&
               p[1] < wire.box.high[1] + margin;
    }
    std::vector<Wire> wires_;  // the outer one first
};

class FaceTrim::Whole : public Way {
  public:
    explicit Whole(const TopoDS_Face& face) : trim_(face, on_border) {}
    Containment of(const Uv& p) override { return of_state(trim_.Perform(gp_Pnt2d(p[0], p[1]))); }

  private:
    BRepTopAdaptor_FClass2d trim_;
};

FaceTrim::FaceTrim(const TopoDS_Face& face) : face_(std::make_unique<const TopoDS_Face>(face)) {}
FaceTrim::~FaceTrim() = default;
FaceTrim::FaceTrim(FaceTrim&&) noexcept = default;
FaceTrim& FaceTrim::operator=(FaceTrim&&) noexcept = default;

Containment FaceTrim::containment_of(double u, double v) const {
    if (!way_) {
        const BRepAdaptor_Surface surface(*face_, false);
        if (surface.GetType() == GeomAbs_Plane)
            way_ = Polygon::of_plane(*face_, surface.Plane());
        else
            way_ = Rectangle::of_curved(*face_, surface);
        if (!way_ && Wires::pays_for(*face_) && !surface.IsUPeriodic() && !surface.IsVPeriodic())
            way_ = std::make_unique<Wires>(*face_);
        if (!way_) way_ = std::make_unique<Whole>(*face_);
    }
    return way_->of({u, v});
}

}  // namespace featuremesh
