// SPDX-License-Identifier: GPL-3.0-or-later
// A verdict "unchanged" that is wrong must not exist: random edits of random parts, judged by a point oracle that knows
// nothing of how the difference is found. A few edits in every run, 2000 in the long one ("[.long]"); there
// FEATUREMESH_RANDOM_EDITS and FEATUREMESH_RANDOM_SEED ask for another number of edits and another first seed.
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cstdlib>
#include <gp_Lin.hxx>
#include <memory>
#include <random>

#include "brep/occt_geometry.h"
#include "catch.h"
#include "core/errors.h"
#include "difference/sample_parts.h"

using namespace featuremesh;
using namespace featuremesh::test;

namespace {
constexpr int few = 24;         // edits in every run
constexpr double coarsest = 2;  // mm, of the changed boundary
constexpr double off = 2e-4;    // mm from the boundary, where the two sides are asked

class RandomParts {
  public:
    explicit RandomParts(unsigned seed) : random_(seed) {}

    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    bool chance(double p) { return real(0, 1) < p; }

    /// Half of all lengths are whole numbers: faces coincide and touch as they do in real parts.
    double length(double low, double high) { return chance(0.6) ? whole(int(low), int(high)) : real(low, high); }
    Vec3 place() { return {length(0, 40), length(0, 30), length(0, 14)}; }
    Vec3 axis() {
        const Vec3 axes[] = {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.2, 1}};
        return axes[whole(0, 4)];
    }

    /// Each number is drawn in a statement of its own: compilers differ in the order in which they evaluate arguments.
    TopoDS_Shape volume() {
        switch (whole(0, 15)) {
            case 0:
            case 1:
            case 2:
            case 10:
            case 11: {
                const Vec3 sizes{length(3, 15), length(3, 15), length(3, 15)};
                return box(place(), sizes);
            }
            case 3:
            case 4:
            case 12:
            case 13: {
                const double height = length(4, 20), radius = length(2, 6);
                const Vec3 along = axis();
                return cylinder(place(), along, radius, height);
            }
            case 5: {
                const double radius = length(3, 8);
                return sphere(place(), radius);
            }
            case 6: {
                const double tube = length(1, 3), radius = length(4, 8);
                const Vec3 along = axis();
                return torus(place(), along, radius, tube);
            }
            case 7:
            case 14:
                return freeform();
            default: {
                const double height = length(4, 12), top = chance(0.3) ? 0 : length(1, 3), bottom = length(4, 7);
                const Vec3 along = axis();
                return cone(place(), along, bottom, top, height);
            }
        }
    }

    TopoDS_Shape freeform() {
        switch (whole(0, 2)) {
            case 0: {
                const double height = length(3, 15), size = length(4, 8);
                return blob(place(), size, height);
            }
            case 1: {
                const double height = length(5, 14), radius = length(3, 7);
                const Vec3 along = axis();
                return vase(place(), along, radius, height);
            }
            default: {
                const Vec3 radii{length(3, 8), length(3, 8), length(3, 8)};
                return ellipsoid(place(), radii);
            }
        }
    }

    /// One in five is a pattern.
    Primitive feature() {
        Primitive f{"Feature" + std::to_string(next_++), chance(0.5) ? Effect::adds : Effect::removes, {volume()}, {}};
        if (chance(0.2)) f.instances = pattern(f.instances[0], whole(2, 4));
        return f;
    }

    /// In a row or about an axis; instances may touch and overlap.
    std::vector<TopoDS_Shape> pattern(const TopoDS_Shape& first, int count) {
        const bool polar = chance(0.3);
        const double distance = length(3, 12);
        const Vec3 step = axis() * distance;
        std::vector<TopoDS_Shape> instances;
        for (int i = 0; i < count; ++i)
            instances.push_back(test::moved(
                first, polar ? turn({20, 15, 6}, {0, 0, 1}, 2 * M_PI * i / count) : shift(step * double(i))));
        return instances;
    }

    std::vector<Primitive> tree() {
        std::vector<Primitive> features{{"Base", Effect::adds, {box({0, 0, 0}, {40, 30, 12})}, {}}};
        for (int n = whole(1, 4); n > 0; --n) features.push_back(feature());
        return features;
    }

    RigidMotion motion() {
        if (chance(0.7)) return shift({length(-8, 8), length(-8, 8), chance(0.5) ? 0 : length(-3, 3)});
        return turn({20, 15, 6}, {0, 0, 1}, chance(0.5) ? M_PI / 2 : real(-0.5, 0.5));
    }

    void edit(std::vector<Primitive>& features) {
        const int i = whole(1, int(features.size()) - 1);
        Primitive& f = features[std::size_t(i)];
        switch (whole(0, 12)) {
            case 0:
            case 1:
            case 2:
            case 3:
                move(f.instances, motion());
                break;
            case 4:
            case 5:
                f.instances[0] = volume();
                break;
            case 6:
                features.erase(features.begin() + i);
                break;
            case 7:
                features.insert(features.begin() + i, feature());
                break;
            case 8:
                features[0].instances[0] = box({0, 0, 0}, {length(36, 46), 30, length(10, 14)});
                break;
            case 9: {
                const RigidMotion all = motion();
                for (Primitive& p : features) move(p.instances, all);
                break;
            }
            case 10:  // an instance comes, in the middle of a pattern that has any
                f.instances.insert(f.instances.begin() + 1, test::moved(f.instances[0], motion()));
                break;
            case 11:
                if (f.instances.size() > 1) f.instances.erase(f.instances.begin() + whole(0, 1));
                f.instances[0] = test::moved(f.instances[0], motion());
                break;
            default:  // another feature of the same shape, and another order of instances
                f.name = "Feature" + std::to_string(next_++);
                std::reverse(f.instances.begin(), f.instances.end());
        }
    }

    std::mt19937& engine() { return random_; }

  private:
    static void move(std::vector<TopoDS_Shape>& instances, const RigidMotion& motion) {
        for (TopoDS_Shape& instance : instances) instance = test::moved(instance, motion);
    }

    std::mt19937 random_;
    int next_ = 0;
};

struct Sample {
    Vec3 point, normal;  ///< the normal points out of the material
    FaceId face;
};

std::vector<Sample> samples_on_faces(const Brep& brep, int per_face, RandomParts& random) {
    std::vector<Sample> samples;
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        const TopoDS_Face& face = brep.face(FaceId(f));
        const BRepAdaptor_Surface surface(face);
        BRepTopAdaptor_FClass2d trim(face, 1e-7);
        double u0, u1, v0, v1;
        BRepTools::UVBounds(face, u0, u1, v0, v1);
        for (int k = 0; k < per_face; ++k) {
            const double u = random.real(u0, u1), v = random.real(v0, v1);
            if (trim.Perform(gp_Pnt2d(u, v)) != TopAbs_IN) continue;
            const Vec3 normal = outward_normal(surface, face, u, v);
            if (length(normal) > 0.5) samples.push_back({to_vec3(surface.Value(u, v)), normal, FaceId(f)});
        }
    }
    return samples;
}

/// What is inside of a solid.
class SolidOracle {
  public:
    explicit SolidOracle(const TopoDS_Shape& solid) : shape_(solid), classifier_(shape_) {}
    /// Material just behind, none just before.
    bool has_boundary(const Vec3& p, const Vec3& normal) {
        return is(p - normal * off, TopAbs_IN) && is(p + normal * off, TopAbs_OUT);
    }

  private:
    /// The kernel's classifier errs now and then on free-form faces (seed 472), so rays are asked when it objects.
    bool is(const Vec3& p, TopAbs_State state) {
        classifier_.Perform(to_pnt(p), 1e-6);
        return classifier_.State() == state || most_rays_say(p) == state;
    }

    TopAbs_State most_rays_say(const Vec3& p) const {
        IntCurvesFace_ShapeIntersector crossings;
        crossings.Load(shape_, 1e-7);
        int odd = 0;
        for (const gp_Dir& direction :
             {gp_Dir(0.31, 0.47, 0.83), gp_Dir(-0.71, 0.59, 0.23), gp_Dir(0.13, -0.37, -0.92)}) {
            crossings.Perform(gp_Lin(to_pnt(p), direction), 0, 1e6);
            odd += crossings.NbPnt() % 2;
        }
        return odd > 1 ? TopAbs_IN : TopAbs_OUT;
    }

    const TopoDS_Shape shape_;
    BRepClass3d_SolidClassifier classifier_;
};

/// Solids that share no face have boundaries of their own where they touch, so each is asked by itself.
class PointOracle {
  public:
    explicit PointOracle(const Brep& brep) {
        for (std::size_t s = 0; s < brep.solid_count(); ++s)
            solids_.push_back(std::make_unique<SolidOracle>(brep.solid(SolidId(s))));
    }
    bool has_boundary(const Vec3& p, const Vec3& normal) {
        return std::any_of(solids_.begin(), solids_.end(), [&](auto& solid) { return solid->has_boundary(p, normal); });
    }

  private:
    std::vector<std::unique_ptr<SolidOracle>> solids_;
};

double distance_to(const TopoDS_Shape& shape, const Vec3& p) {
    return BRepExtrema_DistShapeShape(BRepBuilderAPI_MakeVertex(to_pnt(p)).Vertex(), shape).Value();
}

/// The kernel's distance to a piece of a torus may pass over the foot inside it, and give that to an edge.
double distance_to_face(const TopoDS_Face& face, const Vec3& p) {
    const double distance = distance_to(face, p);
    const GeomAPI_ProjectPointOnSurf foot(to_pnt(p), BRep_Tool::Surface(face));
    if (foot.NbPoints() == 0 || foot.LowerDistance() >= distance) return distance;
    double u, v;
    foot.LowerDistanceParameters(u, v);
    const bool is_inside = BRepClass_FaceClassifier(face, gp_Pnt2d(u, v), 1e-9).State() == TopAbs_IN;
    return is_inside ? foot.LowerDistance() : distance;
}

double area_of(const ChangedBoundary& changed) {
    double area = 0;
    for (const auto& [a, b, c] : changed.triangles()) area += 0.5 * length(cross(b - a, c - a));
    return area;
}

struct Totals {
    int edits = 0, skipped = 0, points = 0, edge_points = 0, regions = 0;
    int wrong = 0;
    double called_changed = 0, truly_changed = 0;  // mm^2
};

/// The oracle's own doubt: where the very shape that was sampled does not answer as it must, nothing is concluded.
bool is_sound(PointOracle& own, const Sample& s) { return own.has_boundary(s.point, s.normal); }

bool is_called_changed(const CarriedRegion& region, const Vec3& p, const Resolution& resolution) {
    return region.changed.distance(p, coarsest) <= resolution.at(p) / 4;
}

void judge_region(const CarriedRegion& region, const PartState& before, const PartState& after,
                  const Resolution& resolution, RandomParts& random, Totals& totals) {
    PointOracle old_oracle(before.brep), new_oracle(after.brep);
    const RigidMotion back = region.motion.inverse();
    for (const Sample& s : samples_on_faces(after.brep, 2, random)) {
        if (is_called_changed(region, s.point, resolution)) continue;
        ++totals.points;
        const Vec3 p = back.apply(s.point), n = back.rotate(s.normal);
        if (!old_oracle.has_boundary(p, n) && is_sound(new_oracle, s)) {
            ++totals.wrong;
            UNSCOPED_INFO("new boundary at " << s.point.x << " " << s.point.y << " " << s.point.z << " was not there");
        }
    }
    for (const Sample& s : samples_on_faces(before.brep, 2, random)) {
        const Vec3 p = region.motion.apply(s.point), n = region.motion.rotate(s.normal);
        if (is_called_changed(region, p, resolution)) continue;
        ++totals.points;
        bool on_partner = random.chance(0.6);  // the costly question
        for (const FaceId f : region.new_faces_of[s.face.index()])
            on_partner = on_partner || distance_to_face(after.brep.face(f), p) < 1e-5;
        if ((!on_partner || !new_oracle.has_boundary(p, n)) && is_sound(old_oracle, s)) {
            ++totals.wrong;
            UNSCOPED_INFO("old boundary carried to " << p.x << " " << p.y << " " << p.z << " is not there, partner "
                                                     << on_partner);
        }
    }
}

void judge_edges(const CarriedRegion& region, const PartState& before, const PartState& after,
                 const Resolution& resolution, RandomParts& random, Totals& totals) {
    for (std::size_t e = 0; e < before.brep.edge_count(); ++e) {
        if (before.brep.is_degenerated(EdgeId(e)) || !random.chance(0.3)) continue;
        double first, last;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(before.brep.edge(EdgeId(e)), first, last);
        const Vec3 p = region.motion.apply(to_vec3(curve->Value(random.real(first, last))));
        if (is_called_changed(region, p, resolution)) continue;
        ++totals.edge_points;
        bool on_partner = false;
        for (const EdgeId partner : region.new_edges_of[e])
            on_partner = on_partner || distance_to(after.brep.edge(partner), p) < 1e-5;
        if (!on_partner) {
            ++totals.wrong;
            UNSCOPED_INFO("a point of old edge " << e + 1 << " is on no new edge");
        }
    }
}

void measure_conservativeness(const FeatureDifference& d, const PartState& before, const PartState& after,
                              RandomParts& random, Totals& totals) {
    std::vector<FaceChange> faces = d.faces;
    tell_areas(faces, before.brep, after.brep);
    const auto changed_area = [&](const Brep& of, const Brep& other, bool is_old) {
        PointOracle oracle(other);
        const auto samples = samples_on_faces(of, 6, random);
        std::vector<int> count(of.face_count(), 0), gone(of.face_count(), 0);
        for (const Sample& s : samples) {
            ++count[s.face.index()];
            gone[s.face.index()] += !oracle.has_boundary(s.point, s.normal);
        }
        double area = 0;
        for (const FaceChange& f : faces) {
            const FaceId id = is_old ? f.old_face : f.new_face;
            if (id.is_valid() && count[id.index()] > 0)
                area += (is_old ? f.old_area : f.new_area).value_or(0) * gone[id.index()] / count[id.index()];
        }
        return area;
    };
    totals.truly_changed += changed_area(before.brep, after.brep, true) + changed_area(after.brep, before.brep, false);
    totals.called_changed += area_of(d.regions[0].changed);
}

Bnd_Box box_of(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, false, false);
    return box;
}

/// Whether a void reaches out of its solid: the kernel's cut can leave the curves where it does so as internal edges of
/// a whole face, and BRepCheck_Analyzer finds nothing.
bool has_void_outside(const TopoDS_Shape& part) {
    for (TopExp_Explorer solid(part, TopAbs_SOLID); solid.More(); solid.Next()) {
        const TopoDS_Shell outer = BRepClass3d::OuterShell(TopoDS::Solid(solid.Current()));
        Bnd_Box around = box_of(outer);
        around.Enlarge(1e-3);
        for (TopExp_Explorer shell(solid.Current(), TopAbs_SHELL); shell.More(); shell.Next()) {
            const Bnd_Box box = box_of(shell.Current());
            if (around.IsOut(box.CornerMin()) || around.IsOut(box.CornerMax())) return true;
        }
    }
    return false;
}

std::optional<PartState> valid_part(const std::vector<Primitive>& features) {
    try {
        PartState state = part(features);
        const TopoDS_Shape& shape = state.tree.final_shape;
        if (!BRepCheck_Analyzer(shape).IsValid() || has_void_outside(shape)) return std::nullopt;
        return state;
    } catch (const InputError&) {
        return std::nullopt;  // nothing is left of the part
    }
}
}  // namespace

namespace {
int asked_for(const char* variable, int otherwise) {
    const char* value = std::getenv(variable);
    return value ? std::atoi(value) : otherwise;
}

Resolution varying() {
    return {0.3, [](const Vec3& p) { return std::min(coarsest, 0.3 + 0.2 * std::abs(p.x - 10)); }};
}

void check_random_edits(int edits, unsigned first_seed, const Resolution& resolution) {
    Totals totals;
    for (unsigned seed = first_seed; totals.edits < edits; ++seed) {
        RandomParts random(seed);
        std::vector<Primitive> features = random.tree();
        const auto before = valid_part(features);
        random.edit(features);
        const auto after = valid_part(features);
        if (!before || !after) {
            ++totals.skipped;
            continue;
        }
        ++totals.edits;
        RunContext context;
        const FeatureDifference d = compare(*before, *after, resolution, context);
        totals.regions += int(d.regions.size());
        const int wrong = totals.wrong;
        for (const CarriedRegion& region : d.regions) {
            judge_region(region, *before, *after, resolution, random, totals);
            judge_edges(region, *before, *after, resolution, random, totals);
        }
        if (totals.edits % 3 == 0) measure_conservativeness(d, *before, *after, random, totals);
        INFO("seed " << seed);
        CHECK(totals.wrong == wrong);
    }
    INFO(totals.edits << " edits, " << totals.skipped << " skipped, " << totals.regions << " regions, " << totals.points
                      << " points on faces and " << totals.edge_points << " on edges called unchanged, "
                      << totals.called_changed << " mm^2 called changed, " << totals.truly_changed << " truly are");
    CHECK(totals.points > 10 * totals.edits);
    CHECK(totals.edge_points > 2 * totals.edits);
    CHECK(totals.skipped < totals.edits);
    if (totals.truly_changed > 0) CHECK(totals.called_changed < 1.5 * totals.truly_changed);
    if (edits > few)
        WARN(totals.edits << " edits, " << totals.skipped << " skipped, " << totals.regions << " regions, "
                          << totals.points << " face points, " << totals.edge_points << " edge points, " << totals.wrong
                          << " wrong, area called changed " << totals.called_changed / totals.truly_changed
                          << " times what is");
}
}  // namespace

TEST_CASE("a part whose void reaches out of it is no part to judge by") {
    CHECK_FALSE(valid_part(RandomParts(33506).tree()));
    CHECK(valid_part(RandomParts(1).tree()));
}

TEST_CASE("what is called unchanged is unchanged") { check_random_edits(few, 1, coarsest); }
TEST_CASE("what is called unchanged is unchanged where the resolution varies") {
    check_random_edits(few, 501, varying());
}

TEST_CASE("what is called unchanged is unchanged, many times", "[.long]") {
    const int edits = asked_for("FEATUREMESH_RANDOM_EDITS", 2000);
    const auto seed = static_cast<unsigned>(asked_for("FEATUREMESH_RANDOM_SEED", 1));
    check_random_edits(edits / 3, seed, coarsest);
    check_random_edits(edits / 3, seed, varying());
    check_random_edits(edits - 2 * (edits / 3), seed, 0.2);
}
