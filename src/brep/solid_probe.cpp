// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/solid_probe.h"

#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <IntTools_Context.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "brep/occt_geometry.h"
#include "core/box_tree.h"

namespace featuremesh {

namespace {

constexpr double touching = 1e-7;  // mm: the kernel's own confusion
constexpr double grazing = 1e-3;   // cosine below which a crossing proves nothing
constexpr double tie = 1e-6;       // mm: two crossings this close are one edge

// Directions without a special place in a model made along the axes.
constexpr std::array<Vec3, 8> ray_directions{{{0.5361, 0.7233, 0.4353},
                                              {-0.3127, 0.4419, 0.8408},
                                              {0.8112, -0.2713, 0.5181},
                                              {-0.6121, -0.5537, -0.5646},
                                              {0.1931, 0.9134, -0.3583},
                                              {0.4447, -0.7712, -0.4555},
                                              {-0.9011, 0.2217, -0.3727},
                                              {0.2311, -0.1129, -0.9664}}};

/// Where the ray enters the box, if it does. Slabs.
std::optional<double> entry(const Box& box, const Vec3& from, const Vec3& direction) {
    double near = 0, far = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double low = box.low[i] - from[i], high = box.high[i] - from[i];
        if (std::abs(direction[i]) < 1e-300) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        const double a = low / direction[i], b = high / direction[i];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far ? std::optional<double>(near) : std::nullopt;
}

struct Hit {
    double distance = 0;
    bool sound = false;    ///< not on an edge, not grazing
    bool leaving = false;  ///< along the outward normal
};

}  // namespace

struct SolidProbe::Data {
    struct ProbedFace {
        TopoDS_Face face;
        Box box;
        mutable std::unique_ptr<IntCurvesFace_Intersector> intersector;
        mutable std::unique_ptr<BRepAdaptor_Surface> surface;
    };
    std::vector<TopoDS_Shape> solids;
    std::vector<ProbedFace> faces;
    mutable std::optional<BoxTree> tree;  // of the faces' boxes, made for the first ray
    Box box;

    template <class BoxOf>
    void add(const TopoDS_Shape& solid, BoxOf box_of_face) {
        solids.push_back(solid);
        for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
            const TopoDS_Face& face = TopoDS::Face(it.Current());
            if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) continue;
            faces.push_back({face, box_of_face(face), nullptr, nullptr});
            box.add(faces.back().box);
        }
    }

    std::vector<Box> boxes() const {
        std::vector<Box> list;
        for (const ProbedFace& face : faces) list.push_back(face.box);
        return list;
    }

    void add_hits(const ProbedFace& face, const Vec3& from, const Vec3& direction, std::vector<Hit>& hits) const {
        if (!face.intersector) {
            face.intersector = std::make_unique<IntCurvesFace_Intersector>(face.face, touching);
            face.surface = std::make_unique<BRepAdaptor_Surface>(face.face, false);
        }
        IntCurvesFace_Intersector& intersector = *face.intersector;
        try {
            intersector.Perform(gp_Lin(to_pnt(from), gp_Dir(to_vec(direction))), -touching,
                                2 * box.diagonal() + distance(from, box.center()));
        } catch (const Standard_Failure&) {  // beside an edge without a curve in space: another direction has to tell
            hits.push_back({entry(face.box, from, direction).value_or(0) + 2 * touching, false, false});
            return;
        }
        if (!intersector.IsDone()) return;
        for (int i = 1; i <= intersector.NbPnt(); ++i) {
            const double cosine =
                dot(outward_normal(*face.surface, face.face, intersector.UParameter(i), intersector.VParameter(i)),
                    direction);
            hits.push_back({intersector.WParameter(i), intersector.State(i) == TopAbs_IN && std::abs(cosine) > grazing,
                            cosine > 0});
        }
    }

    /// The nearest hits further than `skip`, complete up to a tie behind the first. Faces are asked in the order in
    /// which the ray enters their boxes, and no more of them than it takes: to prepare a face for its first question
    /// costs more than all else.
    std::vector<Hit> nearest_hits(const Vec3& from, const Vec3& direction, double skip) const {
        std::vector<std::pair<double, std::size_t>> candidates;
        if (!tree) tree.emplace(boxes());
        const auto meets = [&](const Box& at) { return entry(at, from, direction).has_value(); };
        tree->visit_where(meets, [&](std::int32_t f) {
            candidates.emplace_back(*entry(faces[std::size_t(f)].box, from, direction), std::size_t(f));
        });
        std::sort(candidates.begin(), candidates.end());
        std::vector<Hit> hits;
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& [near, f] : candidates) {
            if (near > nearest + tie) break;
            std::vector<Hit> more;
            add_hits(faces[f], from, direction, more);
            for (const Hit& hit : more) {
                if (hit.distance <= skip) continue;
                hits.push_back(hit);
                nearest = std::min(nearest, hit.distance);
            }
        }
        std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
        return hits;
    }

    std::optional<Containment> containment_along(const Vec3& p, const Vec3& direction) const {
        const std::vector<Hit> all = nearest_hits(p, direction, -2 * touching);
        if (all.empty()) return Containment::outside;
        if (all[0].distance <= touching) return Containment::on;
        if (!all[0].sound || (all.size() > 1 && all[1].distance - all[0].distance < tie)) return std::nullopt;
        return all[0].leaving ? Containment::inside : Containment::outside;
    }

    Containment containment_by_kernel(const Vec3& p) const {
        for (const TopoDS_Shape& solid : solids) {
            BRepClass3d_SolidClassifier classifier(solid, to_pnt(p), touching);
            if (classifier.State() == TopAbs_IN) return Containment::inside;
            if (classifier.State() == TopAbs_ON) return Containment::on;
        }
        return Containment::outside;
    }
};

SolidProbe::SolidProbe(const TopoDS_Shape& shape) : data_(std::make_unique<Data>()) {
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
        data_->add(solid.Current(), [](const TopoDS_Face& face) { return box_of(face); });
}

SolidProbe::SolidProbe(const Brep& brep, SolidId solid) : data_(std::make_unique<Data>()) {
    data_->add(brep.solid(solid), [&](const TopoDS_Face& face) { return brep.box_of(brep.find(face)); });
}

SolidProbe::~SolidProbe() = default;

Containment SolidProbe::containment_of(const Vec3& p) const {
    if (!data_->box.contains(p)) return Containment::outside;
    for (const Vec3& direction : ray_directions)
        if (const auto found = data_->containment_along(p, normalized(direction))) return *found;
    return data_->containment_by_kernel(p);
}

std::optional<double> SolidProbe::first_hit(const Vec3& from, const Vec3& direction, double skip) const {
    const std::vector<Hit> hits = data_->nearest_hits(from, direction, skip);
    return hits.empty() ? std::nullopt : std::optional<double>(hits.front().distance);
}

std::optional<FacePoint> point_on(const TopoDS_Face& face) {
    gp_Pnt point;
    gp_Pnt2d parameters;
    const Handle(IntTools_Context) context = new IntTools_Context;
    bool found = BOPTools_AlgoTools3D::PointInFace(face, point, parameters, context) == 0;
    // In a face too narrow for the kernel's hatching, a point close to an edge.
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More() && !found; it.Next())
        found = BOPTools_AlgoTools3D::PointNearEdge(TopoDS::Edge(it.Current()), face, parameters, point, context) == 0;
    if (!found) return std::nullopt;
    const Vec3 normal = outward_normal(BRepAdaptor_Surface(face, false), face, parameters.X(), parameters.Y());
    if (squared_length(normal) == 0) return std::nullopt;
    return FacePoint{to_vec3(point), normal};
}

namespace {

// A plate with hundreds of holes is best entered from the wall of one of them.
std::vector<TopoDS_Face> simple_faces_first(const TopoDS_Shape& solid) {
    std::vector<std::pair<int, TopoDS_Face>> counted;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
        int edges = 0;
        for (TopExp_Explorer edge(it.Current(), TopAbs_EDGE); edge.More(); edge.Next()) ++edges;
        counted.emplace_back(edges, TopoDS::Face(it.Current()));
    }
    std::stable_sort(counted.begin(), counted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<TopoDS_Face> faces;
    for (const auto& [edges, face] : counted) faces.push_back(face);
    return faces;
}

}  // namespace

std::optional<Vec3> point_inside(const TopoDS_Shape& solid) {
    constexpr int stretches = 3;
    const SolidProbe probe(solid);
    const double good_enough = 0.01 * box_of(solid).diagonal();
    std::optional<Vec3> best;
    double best_length = 0;
    int found = 0;
    for (const TopoDS_Face& face : simple_faces_first(solid)) {
        if (found == stretches || best_length >= good_enough) break;
        const auto start = point_on(face);
        if (!start) continue;
        const auto length = probe.first_hit(start->point, -start->normal, 10 * touching);
        if (!length || *length <= best_length) continue;
        const Vec3 middle = start->point - start->normal * (*length / 2);
        if (probe.containment_of(middle) != Containment::inside) continue;
        best = middle;
        best_length = *length;
        ++found;
    }
    return best;
}

}  // namespace featuremesh
