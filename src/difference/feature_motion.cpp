// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/feature_motion.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <numbers>

#include "core/messages.h"
#include "core/numbers_in_words.h"

namespace featuremesh {

Box VolumeOutline::box() const {
    Box box;
    for (const Vec3& p : points) box.add(p);
    return box;
}

namespace {
void add_points_of_edges(const TopoDS_Shape& shape, TopAbs_ShapeEnum not_within, std::vector<Vec3>& points) {
    for (TopExp_Explorer e(shape, TopAbs_EDGE, not_within); e.More(); e.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        const UnderlyingCurve curve = underlying_of(edge);
        for (const double share : {0.0, 0.5, 1.0})
            points.push_back(point_at(curve, curve.first + share * (curve.last - curve.first)));
    }
}
}  // namespace

VolumeOutline outline_of(const TopoDS_Shape& volume) {
    VolumeOutline outline;
    for (TopExp_Explorer f(volume, TopAbs_FACE); f.More(); f.Next()) {
        outline.faces.push_back(underlying_of(TopoDS::Face(f.Current())));
        add_points_of_edges(f.Current(), TopAbs_SHAPE, outline.points);
    }
    add_points_of_edges(volume, TopAbs_FACE, outline.points);
    return outline;
}

namespace {
bool same_in_order(const VolumeOutline& from, const VolumeOutline& to, const RigidMotion& motion, const Sameness& s) {
    for (std::size_t i = 0; i < from.points.size(); ++i)
        if (distance(motion.apply(from.points[i]), to.points[i]) > s.length) return false;
    const gp_Trsf trsf = to_trsf(motion);
    for (std::size_t i = 0; i < from.faces.size(); ++i)
        if (!same_underlying(moved(from.faces[i], trsf), to.faces[i], s)) return false;
    return true;
}

/// Each of `from`, moved, has a partner; sought by one coordinate first.
bool points_have_images(const std::vector<Vec3>& from, const std::vector<Vec3>& to, const RigidMotion& motion,
                        double tolerance) {
    std::vector<Vec3> sorted = to;
    std::sort(sorted.begin(), sorted.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
    return std::all_of(from.begin(), from.end(), [&](const Vec3& point) {
        const Vec3 p = motion.apply(point);
        auto q = std::lower_bound(sorted.begin(), sorted.end(), p.x - tolerance,
                                  [](const Vec3& a, double x) { return a.x < x; });
        for (; q != sorted.end() && q->x <= p.x + tolerance; ++q)
            if (distance(*q, p) <= tolerance) return true;
        return false;
    });
}

bool faces_have_images(const VolumeOutline& from, const VolumeOutline& to, const RigidMotion& motion,
                       const Sameness& s) {
    const gp_Trsf trsf = to_trsf(motion);
    return std::all_of(from.faces.begin(), from.faces.end(), [&](const UnderlyingSurface& face) {
        const UnderlyingSurface image = moved(face, trsf);
        return std::any_of(to.faces.begin(), to.faces.end(),
                           [&](const UnderlyingSurface& f) { return same_underlying(image, f, s); });
    });
}

Vec3 centroid(const std::vector<Vec3>& points) {
    Vec3 sum;
    for (const Vec3& p : points) sum += p;
    return sum / double(std::max<std::size_t>(points.size(), 1));
}

/// No rigid motion changes it.
double farthest_from(const Vec3& middle, const std::vector<Vec3>& points) {
    double farthest = 0;
    for (const Vec3& p : points) farthest = std::max(farthest, distance(p, middle));
    return farthest;
}

/// Right-handed axes at three points; the columns are the axes.
std::array<Vec3, 3> axes_at(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 x = normalized(b - a);
    const Vec3 z = normalized(cross(x, c - a));
    return {x, cross(z, x), z};
}

double snapped(double cosine) {
    for (const double exact : {-1.0, 0.0, 1.0})
        if (std::abs(cosine - exact) < 1e-12) return exact;
    return cosine;
}

RigidMotion shift(const Vec3& from, const Vec3& to) {
    RigidMotion m;
    const auto rounded = [](double x) { return std::round(x * 1e10) * 1e-10; };
    const Vec3 t = to - from;
    m.translation = {rounded(t.x), rounded(t.y), rounded(t.z)};
    return m;
}

/// From three points far apart and their partners in the same order.
std::optional<RigidMotion> from_three_points(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                                             double tolerance) {
    if (from.empty()) return std::nullopt;
    std::size_t b = 0, c = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        if (distance(from[i], from[0]) > distance(from[b], from[0])) b = i;
    const auto off_line = [&](std::size_t i) { return length(cross(from[i] - from[0], from[b] - from[0])); };
    for (std::size_t i = 0; i < from.size(); ++i)
        if (off_line(i) > off_line(c)) c = i;
    if (off_line(c) <= tolerance * distance(from[b], from[0])) return std::nullopt;
    const auto was = axes_at(from[0], from[b], from[c]), is = axes_at(to[0], to[b], to[c]);
    RigidMotion m;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double sum = 0;
            for (int k = 0; k < 3; ++k) sum += is[std::size_t(k)][i] * was[std::size_t(k)][j];
            m.rotation[std::size_t(3 * i + j)] = snapped(sum);
        }
    m.translation = shift(m.rotate(centroid(from)), centroid(to)).translation;
    return m;
}
}  // namespace

bool is_image(const VolumeOutline& from, const VolumeOutline& to, const RigidMotion& motion, const Sameness& s) {
    if (from.points.size() != to.points.size() || from.faces.size() != to.faces.size()) return false;
    if (same_in_order(from, to, motion, s)) return true;
    return points_have_images(from.points, to.points, motion, s.length) &&
           points_have_images(to.points, from.points, motion.inverse(), s.length) &&
           faces_have_images(from, to, motion, s) && faces_have_images(to, from, motion.inverse(), s);
}

std::optional<RigidMotion> motion_between(const VolumeOutline& from, const VolumeOutline& to, const RigidMotion& hint,
                                          const Sameness& s) {
    if (from.points.size() != to.points.size() || from.faces.size() != to.faces.size()) return std::nullopt;
    const Vec3 was = centroid(from.points), is = centroid(to.points);
    if (std::abs(farthest_from(was, from.points) - farthest_from(is, to.points)) > 2 * s.length) return std::nullopt;
    std::vector<RigidMotion> candidates{RigidMotion{}, shift(was, is), hint};
    if (const auto m = from_three_points(from.points, to.points, s.length)) candidates.push_back(*m);
    for (const RigidMotion& m : candidates)
        if (is_image(from, to, m, s)) return m;
    return std::nullopt;
}

bool same_motion(const RigidMotion& a, const RigidMotion& b, const Sameness& s) {
    if (distance(a.apply(s.centre), b.apply(s.centre)) > s.length) return false;
    for (std::size_t i = 0; i < 9; ++i)
        if (std::abs(a.rotation[i] - b.rotation[i]) * s.reach > s.length) return false;
    return true;
}

Message describe(const RigidMotion& motion) {
    const auto& r = motion.rotation;
    if (r == RigidMotion{}.rotation) return say<Code::moved_by>(motion.translation);
    Vec3 axis{r[7] - r[5], r[2] - r[6], r[3] - r[1]};
    const double angle = std::atan2(length(axis), r[0] + r[4] + r[8] - 1);
    if (length(axis) < 1e-9) {
        // Half a turn: (R + 1) / 2 is the square of the axis.
        const int k = r[0] >= r[4] && r[0] >= r[8] ? 0 : r[4] >= r[8] ? 1 : 2;
        axis = {r[std::size_t(k)] + (k == 0), r[std::size_t(3 + k)] + (k == 1), r[std::size_t(6 + k)] + (k == 2)};
    }
    const double degrees = angle * 180 / std::numbers::pi;
    if (length(motion.translation) == 0) return say<Code::turned_by>(degrees, in_words(normalized(axis)));
    return say<Code::turned_and_moved>(degrees, in_words(normalized(axis)), motion.translation);
}

}  // namespace featuremesh
