// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/pattern_placements.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <numbers>
#include <optional>
#include <string>

#include "brep/occt_geometry.h"
#include "core/geometry.h"

namespace featuremesh {

namespace {

constexpr std::size_t most_candidates = 16;
/// Numbers of occurrences have room for so many of each of three transformations.
constexpr std::int64_t most_occurrences = 1 << 20, largest_stride = most_occurrences * most_occurrences;
constexpr std::int64_t most_in_a_row = 1 << 10;  ///< of a linear pattern's first direction, so that numbers stay
constexpr double as_elsewhere = -1;              ///< a spacing that is not given by itself
constexpr double degree = std::numbers::pi / 180;

double number(const RawRecord& record, const std::string& name, double otherwise) {
    const auto found = record.numbers.find(name);
    return found == record.numbers.end() ? otherwise : found->second;
}

gp_Ax1 local_axis(const RawRecord& record, const Vec3& direction) {
    return {to_pnt(record.global_placement.apply({0, 0, 0})),
            gp_Dir(to_vec(record.global_placement.rotate(direction)))};
}

std::optional<TopoDS_Shape> sub_shape(const TopoDS_Shape& shape, const std::string& name, const char* prefix,
                                      TopAbs_ShapeEnum kind) {
    const std::string start = prefix;
    if (shape.IsNull() || !name.starts_with(start) || name.size() > start.size() + 6) return std::nullopt;
    const int index = std::atoi(name.c_str() + start.size());
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, kind, map);
    if (index < 1 || index > map.Extent()) return std::nullopt;
    return map(index);
}

std::optional<gp_Ax1> axis_of_edge(const TopoDS_Shape& edge) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edge));
    if (curve.GetType() == GeomAbs_Line) return curve.Line().Position();
    if (curve.GetType() == GeomAbs_Circle) return curve.Circle().Axis();
    return std::nullopt;
}

std::optional<gp_Ax1> axis_of_face(const TopoDS_Shape& face) {
    const BRepAdaptor_Surface surface(TopoDS::Face(face));
    if (surface.GetType() == GeomAbs_Plane) return surface.Plane().Axis();
    if (surface.GetType() == GeomAbs_Cylinder) return surface.Cylinder().Axis();
    if (surface.GetType() == GeomAbs_Cone) return surface.Cone().Axis();
    return std::nullopt;
}

/// What a link to a line, an edge, a face, a plane or a sketch's axis can mean as an axis, the likeliest first.
std::vector<gp_Ax1> axes_of(const RawLink& link, const DocumentView& document) {
    const int index = document.find(link.object);
    if (index < 0) return {};
    const RawRecord& record = document.records()[index];
    const TopoDS_Shape& shape = document.shape_of(record);
    if (const auto edge = sub_shape(shape, link.sub_element, "Edge", TopAbs_EDGE))
        if (const auto axis = axis_of_edge(*edge)) return {*axis};
    if (const auto face = sub_shape(shape, link.sub_element, "Face", TopAbs_FACE))
        if (const auto axis = axis_of_face(*face)) return {*axis};
    if (link.sub_element == "H_Axis") return {local_axis(record, {1, 0, 0})};
    if (link.sub_element == "V_Axis") return {local_axis(record, {0, 1, 0})};
    if (record.type == "App::Line") return {local_axis(record, {1, 0, 0}), local_axis(record, {0, 0, 1})};
    return {local_axis(record, {0, 0, 1})};
}

std::vector<gp_Ax1> axes_of(const RawRecord& pattern, const char* property, const DocumentView& document) {
    const auto links = DocumentView::links_of(pattern, property);
    return links.empty() ? std::vector<gp_Ax1>() : axes_of(links.front(), document);
}

// A mirror "at the sketch's horizontal axis" reflects vertically.
RawLink as_normal(RawLink link) {
    if (link.sub_element == "H_Axis")
        link.sub_element = "V_Axis";
    else if (link.sub_element == "V_Axis")
        link.sub_element = "H_Axis";
    return link;
}

/// Every occurrence of `outer` of every occurrence of `inner`. The numbers of `outer` count in steps of `stride`.
Occurrences product(const Occurrences& outer, const Occurrences& inner, std::int64_t stride) {
    Occurrences all;
    for (const Occurrence& further : outer)
        for (const Occurrence& first : inner)
            all.push_back({further.placement * first.placement, further.number * stride + first.number});
    return all;
}

/// Readings of how far each of `count` occurrences is along, or round, the likeliest first. `suffix`: "2" for the
/// second direction; `even`: from one to the next by the whole length or angle.
std::vector<std::vector<double>> distances_of(const RawRecord& pattern, const std::string& suffix, int count,
                                              double even) {
    const double offset = number(pattern, "Offset" + suffix, 0);
    const auto all = [&](auto gap_before) {
        std::vector<double> distances(std::size_t(count), 0);
        for (int i = 1; i < count; ++i) distances[std::size_t(i)] = distances[std::size_t(i) - 1] + gap_before(i - 1);
        return distances;
    };
    const auto mode = pattern.texts.find("Mode" + suffix);
    if (mode != pattern.texts.end() && mode->second == "Spacing") {
        const auto entry = [&](const std::string& list, int i) {
            return number(pattern, list + suffix + "[" + std::to_string(i) + "]", as_elsewhere);
        };
        int repeated = 0;
        while (entry("SpacingPattern", repeated) != as_elsewhere) ++repeated;
        return {all([&](int gap) {
            if (const double own = entry("Spacings", gap); own != as_elsewhere) return own;
            return repeated > 1 ? entry("SpacingPattern", gap % repeated) : offset;
        })};
    }
    std::vector<std::vector<double>> readings{all([&](int) { return even; })};
    const bool is_sure = mode != pattern.texts.end() && mode->second == "Extent";  // FreeCAD 1.1
    if (offset > 0 && !is_sure) readings.push_back(all([&](int) { return offset; }));
    return readings;
}

/// Readings of one of a linear pattern's directions; just the first occurrence where it has none.
std::vector<Occurrences> along(const RawRecord& pattern, const std::string& suffix, const DocumentView& document) {
    const int count = static_cast<int>(number(pattern, "Occurrences" + suffix, 1));
    if (count < 2) return {Occurrences(1)};
    const double sign = number(pattern, "Reversed" + suffix, 0) != 0 ? -1 : 1;
    std::vector<Occurrences> candidates;
    for (const gp_Ax1& axis : axes_of(pattern, ("Direction" + suffix).c_str(), document))
        for (const auto& distances :
             distances_of(pattern, suffix, count, number(pattern, "Length" + suffix, 0) / (count - 1)))
            for (const double direction : {sign, -sign}) {
                Occurrences occurrences(static_cast<std::size_t>(count));
                for (int i = 1; i < count; ++i) {
                    Occurrence& one = occurrences[std::size_t(i)];
                    one.placement.SetTranslation(gp_Vec(axis.Direction()) * (direction * distances[std::size_t(i)]));
                    one.number = i;
                }
                candidates.push_back(std::move(occurrences));
            }
    return candidates;
}

std::vector<Occurrences> linear(const RawRecord& pattern, const DocumentView& document) {
    std::vector<Occurrences> candidates;
    for (const Occurrences& first : along(pattern, "", document))
        for (const Occurrences& second : along(pattern, "2", document))
            if (candidates.size() < most_candidates) candidates.push_back(product(second, first, most_in_a_row));
    return candidates;
}

std::vector<Occurrences> polar(const RawRecord& pattern, const DocumentView& document) {
    const int count = static_cast<int>(number(pattern, "Occurrences", 1));
    if (count < 2) return {Occurrences(1)};
    const double angle = number(pattern, "Angle", 360);
    const double even = std::abs(angle - 360) < 1e-6 ? angle / count : angle / (count - 1);
    const double sign = number(pattern, "Reversed", 0) != 0 ? -1 : 1;
    std::vector<Occurrences> candidates;
    for (const gp_Ax1& axis : axes_of(pattern, "Axis", document))
        for (const auto& distances : distances_of(pattern, "", count, even))
            for (const double direction : {sign, -sign}) {
                Occurrences occurrences(static_cast<std::size_t>(count));
                for (int i = 1; i < count; ++i) {
                    Occurrence& one = occurrences[std::size_t(i)];
                    one.placement.SetRotation(axis, direction * distances[std::size_t(i)] * degree);
                    one.number = i;
                }
                candidates.push_back(std::move(occurrences));
            }
    return candidates;
}

std::vector<Occurrences> mirrored(const RawRecord& pattern, const DocumentView& document) {
    std::vector<Occurrences> candidates;
    const auto links = DocumentView::links_of(pattern, "MirrorPlane");
    if (links.empty()) return candidates;
    for (const gp_Ax1& axis : axes_of(as_normal(links.front()), document)) {
        Occurrences occurrences(2);
        occurrences[1].placement.SetMirror(gp_Ax2(axis.Location(), axis.Direction()));
        occurrences[1].number = 1;
        candidates.push_back(std::move(occurrences));
    }
    return candidates;
}

/// Of a pattern that is one transformation.
std::vector<Occurrences> of_one_transformation(const RawRecord& pattern, const DocumentView& document) {
    if (pattern.type == "PartDesign::LinearPattern") return linear(pattern, document);
    if (pattern.type == "PartDesign::PolarPattern") return polar(pattern, document);
    if (pattern.type == "PartDesign::Mirrored") return mirrored(pattern, document);
    return {};
}

std::vector<Occurrences> combined(const RawRecord& pattern, const DocumentView& document) {
    std::vector<Occurrences> candidates{Occurrences(1)};
    std::int64_t stride = 1;
    for (const RawLink& link : DocumentView::links_of(pattern, "Transformations")) {
        const int index = document.find(link.object);
        if (index < 0) return {};
        std::vector<Occurrences> next;
        for (const Occurrences& so_far : candidates)
            for (const Occurrences& further : of_one_transformation(document.records()[index], document))
                if (next.size() < most_candidates) next.push_back(product(further, so_far, stride));
        candidates = std::move(next);
        stride = stride < largest_stride ? stride * most_occurrences : 1;
    }
    return candidates;
}

}  // namespace

TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Trsf& placement) {
    if (placement.IsNegative() || std::abs(placement.ScaleFactor() - 1) > 1e-12)
        return BRepBuilderAPI_Transform(shape, placement, true).Shape();
    return shape.Moved(TopLoc_Location(placement));
}

std::vector<Occurrences> candidate_occurrences(const RawRecord& pattern, const DocumentView& document) {
    if (pattern.type == "PartDesign::MultiTransform") return combined(pattern, document);
    return of_one_transformation(pattern, document);
}

}  // namespace featuremesh
