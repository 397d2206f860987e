// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/girth.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "brep/face_trim.h"
#include "brep/occt_geometry.h"
#include "core/messages.h"
#include "core/numbers_in_words.h"
#include "sizing/curvature.h"

namespace featuremesh {
namespace {

using Range = std::array<double, 2>;

constexpr double at_tip = 0.25;  ///< of the girth where it is widest

double at_share(const Range& range, double share) { return range[0] + share * (range[1] - range[0]); }

bool has_seam(const Brep& brep, FaceId face) {
    const auto edges = brep.edges_of(face);
    return std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return brep.is_seam(e, face); });
}

/// Whether some ring in that direction is on the face all the way: a bead along an edge has a seam, too.
bool goes_round(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, const Range& u, const Range& v,
                bool in_u) {
    constexpr int rings = 7, places = 12;
    const double mu = at_share(u, 0.5), mv = at_share(v, 0.5);
    const auto begin = in_u ? surface.Value(u[0], mv) : surface.Value(mu, v[0]),
               end = in_u ? surface.Value(u[1], mv) : surface.Value(mu, v[1]);
    if (begin.Distance(end) > 2 * BRep_Tool::Tolerance(face)) return false;
    const FaceTrim trim(face);
    const Range &around = in_u ? u : v, &along = in_u ? v : u;
    const auto is_on_face = [&](int ring, int place) {
        const double a = at_share(around, (place + 0.5) / places), b = at_share(along, (ring + 0.5) / rings);
        return in_u ? trim.has(a, b) : trim.has(b, a);
    };
    for (int ring = 0; ring < rings; ++ring) {
        int place = 0;
        while (place < places && is_on_face(ring, place)) ++place;
        if (place == places) return true;
    }
    return false;
}

/// Whether the material that the face bounds is where `center` is.
bool is_round_material(const Brep& brep, FaceId face, const BRepAdaptor_Surface& surface, double u, double v,
                       const Vec3& center) {
    const double outward = dot(outward_normal(surface, brep.face(face), u, v), to_vec3(surface.Value(u, v)) - center);
    const auto solids = brep.solids_beside(face);
    return (outward > 0 && solids[0].is_valid()) || (outward < 0 && solids[1].is_valid());
}

bool is_same_cylinder(const gp_Cylinder& a, const gp_Cylinder& b, double tolerance) {
    return std::abs(a.Radius() - b.Radius()) <= tolerance && a.Axis().IsCoaxial(b.Axis(), 1e-9, tolerance);
}

double turn_of(const TopoDS_Face& face) {
    Range u, v;
    BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
    return u[1] - u[0];
}

/// Whether a second face takes the cylinder on all the way round.
bool is_half_of_rod(const Brep& brep, FaceId face, const BRepAdaptor_Surface& surface) {
    const double tolerance = brep.tolerances().same_geometry(), turn = turn_of(brep.face(face));
    for (const EdgeId edge : brep.edges_of(face))
        for (const FaceId other : brep.faces_of(edge)) {
            if (other == face) continue;
            const BRepAdaptor_Surface rest(brep.face(other), false);
            if (rest.GetType() == GeomAbs_Cylinder &&
                is_same_cylinder(surface.Cylinder(), rest.Cylinder(), tolerance) &&
                turn + turn_of(brep.face(other)) > 2 * std::numbers::pi - 1e-6)
                return true;
        }
    return false;
}

bool has_end(const Brep& brep, EdgeId edge, VertexId vertex) {
    const auto [first, last] = brep.ends_of(edge);
    return first == vertex || last == vertex;
}

VertexId other_end(const Brep& brep, EdgeId edge, VertexId vertex) {
    const auto [first, last] = brep.ends_of(edge);
    return first == vertex ? last : first;
}

double length_of(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    return GCPnts_AbscissaPoint::Length(curve);
}

/// A face on the way round, between the side by which it is entered and the opposite one.
struct Strip {
    FaceId face;
    EdgeId left, right, opposite;
    VertexId at_left, next_left;  ///< ends of the left edge
};

/// From a side of a face to the opposite one and on, through curved faces of four edges, until the first face is there
/// again; none where it is not.
std::vector<Strip> strips_from(const Brep& brep, FaceId first, EdgeId start) {
    constexpr std::size_t most = 16;
    std::vector<Strip> strips;
    EdgeId side = start;
    VertexId at_left = brep.ends_of(start)[0];
    for (FaceId face = first; strips.empty() || face != first;) {
        const auto edges = brep.edges_of(face);
        const VertexId at_right = other_end(brep, side, at_left);
        if (strips.size() == most || edges.size() != 4 || at_left == at_right ||
            BRepAdaptor_Surface(brep.face(face), false).GetType() == GeomAbs_Plane)
            return {};
        Strip strip{face, {}, {}, {}, at_left, {}};
        for (const EdgeId edge : edges) {
            if (edge == side) continue;
            const bool is_left = has_end(brep, edge, at_left), is_right = has_end(brep, edge, at_right);
            (is_left ? strip.left : is_right ? strip.right : strip.opposite) = edge;
        }
        if (!strip.opposite.is_valid() || !strip.left.is_valid() || !strip.right.is_valid()) return {};
        at_left = strip.next_left = other_end(brep, strip.left, at_left);
        side = strip.opposite;
        strips.push_back(strip);
        const auto faces = brep.faces_of(side);
        if (faces.size() != 2) return {};
        face = faces[faces[0] == face ? 1 : 0];
    }
    return side == start ? strips : std::vector<Strip>();
}

struct Lap {
    double shorter, longer;  ///< once round, along the one or the other ends of the faces
};

/// Once round such faces; none where they are no long round rod: rims that are rounded are rings, too, and what is
/// straight round it needs no more elements.
std::optional<Lap> lap_of(const Brep& brep, const std::vector<Strip>& strips) {
    constexpr double least_height = 2;      // girths
    constexpr double most_straight = 0.99;  // chords over arcs
    if (strips.empty()) return {};
    double left = 0, right = 0, chords = 0, height = std::numeric_limits<double>::infinity();
    Vec3 middles;
    for (const Strip& strip : strips) {
        left += length_of(brep.edge(strip.left)), right += length_of(brep.edge(strip.right));
        chords += distance(brep.point_of(strip.at_left), brep.point_of(strip.next_left));
        height = std::min(height, length_of(brep.edge(strip.opposite)));
        const BRepAdaptor_Curve curve(brep.edge(strip.opposite));
        middles = middles + to_vec3(curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter())));
    }
    if (chords > most_straight * left || height < least_height * std::max(left, right)) return {};
    const Vec3 center = middles / double(strips.size());
    for (const Strip& strip : strips) {
        const BRepAdaptor_Surface surface(brep.face(strip.face));
        const double u = 0.5 * (surface.FirstUParameter() + surface.LastUParameter()),
                     v = 0.5 * (surface.FirstVParameter() + surface.LastVParameter());
        if (!is_round_material(brep, strip.face, surface, u, v, center)) return {};
    }
    return Lap{std::min(left, right), std::max(left, right)};
}

double asked_on(FaceId face, const SizingOptions& options) {
    double size = options.size;
    for (const LocalSize& local : options.local)
        if (local.entity == entity_of(face)) size = std::min(size, local.size);
    return size;
}

/// Once round the surface; exact for a circle.
template <class Place>
std::pair<double, Vec3> ring_at(const BRepAdaptor_Surface& surface, Place place) {
    constexpr int count = 12;
    constexpr double arc_over_chord = (std::numbers::pi / count) / 0.25881904510252074;  // sin(pi / 12)
    double length = 0;
    Vec3 center;
    std::array<Vec3, count> points;
    for (int i = 0; i < count; ++i) {
        const auto [u, v] = place(double(i) / count);
        points[std::size_t(i)] = to_vec3(surface.Value(u, v));
        center = center + points[std::size_t(i)] / count;
    }
    for (int i = 0; i < count; ++i)
        length += arc_over_chord * distance(points[std::size_t(i)], points[std::size_t((i + 1) % count)]);
    return {length, center};
}

}  // namespace

Girth::Girth(std::vector<Ring> rings) : rings_(std::move(rings)) {
    for (const Ring& ring : rings_) widest_ = std::max(widest_, ring.length);
}

std::optional<Girth> Girth::of(const Brep& brep, FaceId face, const BRepAdaptor_Surface& surface) {
    const GeomAbs_SurfaceType type = surface.GetType();
    if (type == GeomAbs_Plane) return {};
    const bool closes = has_seam(brep, face);
    Range u, v;
    BRepTools::UVBounds(brep.face(face), u[0], u[1], v[0], v[1]);
    const double mu = at_share(u, 0.5), mv = at_share(v, 0.5);
    if (!closes && (type != GeomAbs_Cylinder || !is_half_of_rod(brep, face, surface))) {
        for (const EdgeId edge : brep.edges_of(face))  // across a long rod there is no other one
            if (const auto lap = lap_of(brep, strips_from(brep, face, edge)))
                return Girth(std::max(at_tip * lap->longer, lap->shorter));
        return {};
    }
    if (type == GeomAbs_Cylinder) {
        const gp_Ax1 axis = surface.Cylinder().Axis();
        const Vec3 p = to_vec3(surface.Value(mu, mv)), base = to_vec3(axis.Location()),
                   along = to_vec3(gp_Vec(axis.Direction()));
        if (!is_round_material(brep, face, surface, mu, mv, base + dot(p - base, along) * along)) return {};
        if (closes && !goes_round(brep.face(face), surface, u, v, true)) return {};
        return Girth(2 * std::numbers::pi * surface.Cylinder().Radius());
    }
    if (type == GeomAbs_Sphere) {
        if (!is_round_material(brep, face, surface, mu, mv, to_vec3(surface.Sphere().Location())) ||
            !goes_round(brep.face(face), surface, u, v, true))
            return {};
        return Girth(2 * std::numbers::pi * surface.Sphere().Radius());
    }
    constexpr int count = 32;
    std::optional<Girth> least;
    for (const bool closes_in_u : {true, false}) {
        if (!(closes_in_u ? surface.IsUClosed() : surface.IsVClosed())) continue;
        if (!goes_round(brep.face(face), surface, u, v, closes_in_u)) continue;
        const Range &around = closes_in_u ? u : v, &along = closes_in_u ? v : u;
        std::vector<Ring> rings;
        int round = 0;
        for (int i = 0; i <= count; ++i) {
            const auto place = [&](double share) {
                const double a = at_share(around, share), b = at_share(along, double(i) / count);
                return closes_in_u ? std::pair(a, b) : std::pair(b, a);
            };
            const auto [length, center] = ring_at(surface, place);
            rings.push_back({length, center});
            const auto [at_u, at_v] = place(0.3);
            round += is_round_material(brep, face, surface, at_u, at_v, center);
        }
        Girth girth(std::move(rings));
        if (2 * round > count && (!least || girth.widest() < least->widest())) least = std::move(girth);
    }
    return least;
}

double Girth::at(const Vec3& p) const {
    if (rings_.empty()) return widest_;
    const auto nearest = std::min_element(rings_.begin(), rings_.end(), [&](const Ring& a, const Ring& b) {
        return squared_length(a.center - p) < squared_length(b.center - p);
    });
    return std::max(at_tip * widest_, nearest->length);
}

namespace {

class RodProvider : public SizeProvider {
  public:
    RodProvider(const Brep& brep, const SizingOptions& options) : brep_(brep), options_(options) {}

    FaceWish on(FaceId face) const override {
        const std::optional<Girth> girth = Girth::of(brep_, face, BRepAdaptor_Surface(brep_.face(face), false));
        if (!girth || girth->widest() >= options_.pieces_round_rod * options_.size) return {};
        return {[girth = *girth, pieces = options_.pieces_round_rod](const SurfacePoint& p) {
            return girth.at(p.point) / pieces;
        }};
    }

  private:
    const Brep& brep_;
    const SizingOptions& options_;
};

}  // namespace

std::unique_ptr<SizeProvider> rod_provider(const Brep& brep, const SizingOptions& options) {
    return std::make_unique<RodProvider>(brep, options);
}

std::vector<Message> warnings_of_thin_rods(const Brep& brep, const SizingOptions& options) {
    std::vector<FaceId> faces;
    double thinnest = 0;
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        const BRepAdaptor_Surface surface(brep.face(FaceId(f)), false);
        const std::optional<Girth> girth = Girth::of(brep, FaceId(f), surface);
        if (!girth) continue;
        const double floor = curvature_floor(brep, FaceId(f), options);
        const double by_circle = options.elements_per_circle > 0
                                     ? std::max(floor, girth->widest() / options.elements_per_circle)
                                     : options.size;
        if (girth->widest() / options.pieces_round_rod >= std::min(asked_on(FaceId(f), options), by_circle)) continue;
        const double thickness = girth->widest() / std::numbers::pi;
        thinnest = faces.empty() ? thickness : std::min(thinnest, thickness);
        faces.push_back(FaceId(f));
    }
    if (faces.empty()) return {};
    return {say<Code::thin_rod>(Length{rounded(thinnest, 3)}, faces, options.pieces_round_rod)};
}

}  // namespace featuremesh
