// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/made_faces.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "brep/occt_geometry.h"
#include "brep/solid_probe.h"
#include "difference/feature_pieces.h"
#include "difference/volume_faces.h"

namespace featuremesh {

namespace {
constexpr double on_surface = 1e-4;  // mm: how closely a sketch element lies on the surface that was swept from it

SketchElement moved(SketchElement element, const RigidMotion& motion) {
    for (Vec3& p : element.points) p = motion.apply(p);
    if (element.centre) element.centre = motion.apply(*element.centre);
    return element;
}

bool is_swept_from(const SketchElement& element, const FaceProbe& face) {
    return std::all_of(element.points.begin(), element.points.end(),
                       [&](const Vec3& p) { return face.distance_to_surface(p) < on_surface; });
}

/// A plane along which the sketch lies: all its elements are on it, but none made it.
bool is_cap(const UnderlyingSurface& underlying, const Vec3& normal) {
    return underlying.kind == SurfaceKind::plane &&
           std::abs(dot(to_vec3(gp_Vec(underlying.position.Direction())), normal)) > same_normal;
}

bool is_axis_through(const UnderlyingSurface& underlying, const Vec3& centre) {
    if (underlying.kind != SurfaceKind::cylinder && underlying.kind != SurfaceKind::cone) return false;
    const Vec3 to = centre - to_vec3(underlying.position.Location());
    return length(cross(to, to_vec3(gp_Vec(underlying.position.Direction())))) < on_surface;
}

double distance_to(const Box& box, const Vec3& p) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double off = std::max({box.low[i] - p[i], p[i] - box.high[i], 0.0});
        sum += off * off;
    }
    return std::sqrt(sum);
}

void add_once(std::vector<ElementName>& sorted, const ElementName& value) {
    const auto at = std::lower_bound(sorted.begin(), sorted.end(), value);
    if (at == sorted.end() || *at != value) sorted.insert(at, value);
}
}  // namespace

Box box_after(const TopoDS_Face& face, const RigidMotion& motion) {
    return box_of(face.Moved(TopLoc_Location(to_trsf(motion))));
}

std::vector<Vec3> points_over(const TopoDS_Face& face) {
    std::vector<Vec3> points;
    for (const SurfacePoint& p : points_in_trim(face)) points.push_back(p.point);
    if (const auto sound = point_on(face); points.empty() && sound) points.push_back(sound->point);
    return points;
}

MadeFaces::MadeFaces(const PartState& state, const SketchElements& elements)
    : state_(state), elements_(elements), pieces_of_(state.tree.features.size()), made_(state.brep.face_count()) {
    for (std::size_t f = 0; f < state.tree.features.size(); ++f) {
        const Feature& feature = state.tree.features[f];
        int number = 0;
        std::int64_t instance = feature.volumes.empty() ? 0 : feature.volumes.front().instance;
        for (const FeatureVolume& volume : feature.volumes) {
            if (volume.instance != instance) number = 0, instance = volume.instance;
            take_volume(FeatureId(f), volume, number);
        }
        find_elements(FeatureId(f));
    }
}

void MadeFaces::take_volume(FeatureId feature, const FeatureVolume& volume, int& number) {
    for (const TopoDS_Shape& shape : featuremesh::pieces_of(volume.shape)) {
        const int piece = int(pieces_.size());
        pieces_.push_back(
            {feature, volume.instance, volume.copied_from, number++, volume.motion, volume.effect, shape, {}, {}});
        pieces_of_[feature.index()].push_back(piece);
        for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
            const TopoDS_Face& face = TopoDS::Face(it.Current());
            pieces_.back().faces.push_back(int(faces_.size()));
            faces_.push_back({piece, face, underlying_of(face), FaceProbe(face), {}, 0});
        }
    }
}

/// Of the sketches that a feature is made from, for a pattern of those of what it repeats, for a copy of what it
/// copies.
std::vector<MadeFaces::PlacedElement> MadeFaces::elements_of(const MadePiece& piece) const {
    const auto id =
        piece.copied_from.empty() ? std::optional(piece.feature) : state_.tree.find(piece.copied_from.back().feature);
    if (!id) return {};
    std::vector<PlacedElement> placed;
    const auto add = [&](const Feature& feature) {
        for (const FeatureId d : feature.depends_on) {
            const Feature& sketch = state_.tree[d];
            const auto found = elements_.find(sketch.name);
            if (found == elements_.end()) continue;
            const RigidMotion place = compose(piece.motion, sketch.frame);
            for (const SketchElement& element : found->second)
                placed.push_back(
                    {{sketch.name, element.id}, moved(element, place), place.rotate({0, 0, 1}), feature.at_centres});
        }
    };
    if (state_.tree[*id].role != Role::pattern)
        add(state_.tree[*id]);
    else  // its own sketch only tells a direction
        for (const FeatureId original : state_.tree[*id].depends_on) add(state_.tree[original]);
    return placed;
}

void MadeFaces::find_elements(FeatureId feature) {
    const std::vector<int>& all = pieces_of_[feature.index()];
    for (auto first = all.begin(); first != all.end();) {
        const MadePiece& piece = pieces_[std::size_t(*first)];
        const auto end = std::find_if(first, all.end(), [&](int p) {
            return pieces_[std::size_t(p)].instance != piece.instance || pieces_[std::size_t(p)].motion != piece.motion;
        });
        for (const PlacedElement& placed : elements_of(piece)) give(placed, std::span<const int>(first, end));
        first = end;
    }
}

/// To the faces that were swept from it, and to the pieces about its centre. Of faces on one surface, which elements in
/// a line make, those next to it.
void MadeFaces::give(const PlacedElement& placed, std::span<const int> pieces) {
    double nearest = std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, int>> swept;
    const Vec3 middle = placed.element.points[1];
    for (const int p : pieces)
        for (const int f : pieces_[std::size_t(p)].faces) {
            MadeFace& face = faces_[std::size_t(f)];
            face.height = dot(face.probe.box().center(), placed.normal);
            if (placed.element.centre && is_axis_through(face.underlying, *placed.element.centre))
                add_once(pieces_[std::size_t(p)].elements, placed.name);
            if (placed.only_centre || is_cap(face.underlying, placed.normal) ||
                !is_swept_from(placed.element, face.probe))
                continue;
            swept.emplace_back(face.probe.contains(middle, on_surface) ? 0 : distance_to(face.probe.box(), middle), f);
            nearest = std::min(nearest, swept.back().first);
        }
    for (const auto& [off, f] : swept) {
        if (off > nearest + on_surface) continue;
        add_once(faces_[std::size_t(f)].elements, placed.name);
        add_once(pieces_[std::size_t(faces_[std::size_t(f)].piece)].elements, placed.name);
    }
}

const std::vector<int>& MadeFaces::made(FaceId final_face) const {
    std::unique_ptr<std::vector<int>>& known = made_[final_face.index()];
    if (known) return *known;
    known = std::make_unique<std::vector<int>>();
    const TopoDS_Face& face = state_.brep.face(final_face);
    const Box box = box_of(face);
    const UnderlyingSurface underlying = underlying_of(face);
    const Sameness sameness{boolean_tolerance, box.center(), 0.5 * box.diagonal()};
    const std::vector<Vec3> points = points_over(face);
    for (const int f : faces_near(box)) {
        const MadeFace& made = faces_[std::size_t(f)];
        if (!same_underlying(made.underlying, underlying, sameness)) continue;
        const auto on_it = std::find_if(points.begin(), points.end(),
                                        [&](const Vec3& p) { return made.probe.contains(p, boolean_tolerance); });
        if (on_it != points.end() && bounds_the_same_way(made, final_face, *on_it)) known->push_back(f);
    }
    if (state_.brep.solid_count() > 1) keep_those_with_bounds(box, *known);
    return *known;
}

/// Those whose boxes overlap it, in order.
std::vector<int> MadeFaces::faces_near(const Box& box) const {
    if (!by_place_) {
        std::vector<Box> boxes;
        for (const MadeFace& face : faces_) boxes.push_back(face.probe.box().grown(boolean_tolerance));
        by_place_.emplace(boxes);
    }
    std::vector<int> near;
    by_place_->visit_where([&](const Box& of_face) { return of_face.overlaps(box); },
                           [&](std::int32_t f) { near.push_back(f); });
    std::sort(near.begin(), near.end());
    return near;
}

// Of solids that overlap with faces in one plane each has its own there, which the other one has nothing to do with.
void MadeFaces::keep_those_with_bounds(const Box& box, std::vector<int>& made) const {
    const auto has_other_bounds = [&](int m) {
        return !faces_[std::size_t(m)].probe.box().is_close_to(box, boolean_tolerance);
    };
    if (!std::all_of(made.begin(), made.end(), has_other_bounds)) std::erase_if(made, has_other_bounds);
}

// Of solids that lie on one another each has a face there. They look in opposite directions, as do the volumes that
// they come from.
bool MadeFaces::bounds_the_same_way(const MadeFace& made, FaceId final_face, const Vec3& p) const {
    const auto solids = state_.brep.solids_beside(final_face);
    const MadePiece& piece = pieces_[std::size_t(made.piece)];
    if (state_.brep.solid_count() < 2 || solids[0].is_valid() == solids[1].is_valid()) return true;
    if (piece.solid.ShapeType() != TopAbs_SOLID) return true;
    const double cosine = dot(made.probe.normal_at(p), FaceProbe(state_.brep.face(final_face)).normal_at(p));
    return cosine == 0 || (cosine > 0) == (solids[0].is_valid() != (piece.effect == Effect::removes));
}

}  // namespace featuremesh
