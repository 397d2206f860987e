// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/faces_on_each_other.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <limits>
#include <memory>
#include <optional>

#include "features/face_probe.h"
#include "features/occt_geometry.h"

namespace featuremesh {

namespace {

constexpr double generous = 10;  // times the tolerances

/// Distances to a free-form surface by Newton's method from the nearest of a few points: to search all of it costs a
/// hundred times as much.
class FreeFormSamples {
  public:
    explicit FreeFormSamples(const TopoDS_Face& face) : face_(face), surface_(face, false) {
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        BRepTools::UVBounds(face, u1, u2, v1, v2);
        constexpr int count = 8;
        for (int i = 0; i <= count; ++i)
            for (int k = 0; k <= count; ++k) {
                const double u = u1 + i * (u2 - u1) / count, v = v1 + k * (v2 - v1) / count;
                samples_.push_back({u, v, to_vec3(surface_.Value(u, v))});
            }
    }

    struct Nearest {
        double distance = 0;
        Vec3 normal;
    };
    Nearest nearest(const Vec3& p) const {
        const Sample* best = &samples_.front();
        for (const Sample& sample : samples_)
            if (squared_length(sample.point - p) < squared_length(best->point - p)) best = &sample;
        double u = best->u, v = best->v, least = std::numeric_limits<double>::infinity();
        for (int step = 0; step < 12; ++step) {
            gp_Pnt point;
            gp_Vec du, dv;
            surface_.D1(u, v, point, du, dv);
            const Vec3 a = to_vec3(du), b = to_vec3(dv), off = p - to_vec3(point);
            if (length(off) > 0.9 * least) break;
            least = length(off);
            const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), determinant = aa * bb - ab * ab;
            if (determinant <= 1e-12 * aa * bb) break;
            u += (dot(off, a) * bb - dot(off, b) * ab) / determinant;
            v += (dot(off, b) * aa - dot(off, a) * ab) / determinant;
            u = std::clamp(u, surface_.FirstUParameter(), surface_.LastUParameter());
            v = std::clamp(v, surface_.FirstVParameter(), surface_.LastVParameter());
        }
        return {least, outward_normal(surface_, face_, u, v)};
    }

  private:
    struct Sample {
        double u = 0, v = 0;
        Vec3 point;
    };
    TopoDS_Face face_;
    BRepAdaptor_Surface surface_;
    std::vector<Sample> samples_;
};

class Carrier {
  public:
    explicit Carrier(const TopoDS_Face& face) : probe_(face), type_(BRepAdaptor_Surface(face, false).GetType()) {}

    const Box& box() const { return probe_.box(); }
    bool is_free_form() const { return type_ > GeomAbs_Torus; }
    bool can_equal(const Carrier& other) const {
        return type_ == other.type_ || is_free_form() || other.is_free_form();
    }
    double distance(const Vec3& p) const {
        return is_free_form() ? samples().nearest(p).distance : probe_.distance_to_surface(p);
    }
    Vec3 normal(const Vec3& p) const { return is_free_form() ? samples().nearest(p).normal : probe_.normal_at(p); }

  private:
    const FreeFormSamples& samples() const {
        if (!samples_) samples_ = std::make_unique<FreeFormSamples>(probe_.face());
        return *samples_;
    }
    FaceProbe probe_;
    GeomAbs_SurfaceType type_;
    mutable std::unique_ptr<FreeFormSamples> samples_;
};

/// A point of the face's border, if all of it lies on the other surface.
std::optional<Vec3> point_where_on(const TopoDS_Face& face, const std::vector<MergedEdges::Wire>& wires,
                                   const MergedEdges& edges, const Carrier& other) {
    std::optional<Vec3> last;
    for (const MergedEdges::Wire& wire : wires)
        for (const MergedEdges::Use& use : wire) {
            const MergedEdges::Piece& own = edges.piece(use.own);
            if (edges.is_degenerated(own)) continue;
            const double close = generous * (BRep_Tool::Tolerance(use.edge) + BRep_Tool::Tolerance(face));
            for (const Vec3& p : *own.inner) {
                if (other.distance(p) > close) return std::nullopt;
                last = p;
            }
        }
    return last;
}

}  // namespace

bool any_on_each_other(const std::vector<PatchFace>& faces, const MergedEdges& edges) {
    std::vector<Carrier> carriers;
    for (const PatchFace& face : faces) carriers.emplace_back(face.face);
    for (std::size_t a = 0; a < faces.size(); ++a)
        for (std::size_t b = 0; b < faces.size(); ++b) {
            const bool are_one_carrier = faces[a].carrier >= 0 && faces[a].carrier == faces[b].carrier;
            if (!faces[a].vanished || faces[b].vanished || are_one_carrier || !carriers[a].can_equal(carriers[b]) ||
                !carriers[a].box().overlaps(carriers[b].box()))
                continue;
            const bool swap = carriers[a].is_free_form() && !carriers[b].is_free_form();
            const std::size_t face = swap ? a : b, other = swap ? b : a;
            const auto p = point_where_on(faces[face].face, edges.wires_of(face), edges, carriers[other]);
            if (p && dot(carriers[face].normal(*p), carriers[other].normal(*p)) > -same_normal) return true;
        }
    return false;
}

}  // namespace featuremesh
