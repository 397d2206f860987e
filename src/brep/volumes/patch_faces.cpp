// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/patch_faces.h"

#include <TopoDS.hxx>
#include <algorithm>

#include "brep/occt_geometry.h"
#include "core/geometry.h"

namespace featuremesh {

namespace {

constexpr double close = 1e-7;     // mm
constexpr double parallel = 1e-9;  // sine of the angle between planes

struct Surface {
    TopoDS_Face face;
    BRepAdaptor_Surface surface;

    explicit Surface(const TopoDS_Face& f) : face(f), surface(f, false) {}
    bool is_plane() const { return surface.GetType() == GeomAbs_Plane; }
};

bool same_plane(const Surface& a, const Surface& b) {
    const Vec3 n = outward_normal(a.surface, a.face, 0, 0), m = outward_normal(b.surface, b.face, 0, 0);
    return dot(n, m) > 0 && length(cross(n, m)) < parallel &&
           std::abs(dot(n, to_vec3(b.surface.Value(0, 0)) - to_vec3(a.surface.Value(0, 0)))) < close;
}

/// Ranges over which surfaces are compared: all of a bounded one.
struct Range {
    double first = 0, last = 0;
    Range(double a, double b) : first(std::max(a, -1.0)), last(std::min(b, 1.0)) {
        if (std::isfinite(a) && std::isfinite(b) && std::abs(a) < 1e50 && std::abs(b) < 1e50) first = a, last = b;
    }
    double at(double share) const { return first + share * (last - first); }
    bool operator==(const Range&) const = default;
};

/// The same point for the same parameters.
bool same_parametrisation(const Surface& a, const Surface& b) {
    if (a.surface.GetType() != b.surface.GetType() || a.face.Orientation() != b.face.Orientation()) return false;
    const Range u(a.surface.FirstUParameter(), a.surface.LastUParameter());
    const Range v(a.surface.FirstVParameter(), a.surface.LastVParameter());
    if (u != Range(b.surface.FirstUParameter(), b.surface.LastUParameter()) ||
        v != Range(b.surface.FirstVParameter(), b.surface.LastVParameter()))
        return false;
    for (const double i : {0.31, 0.0, 0.83, 1.0, 0.57, 0.13})
        for (const double j : {0.71, 0.0, 0.29, 1.0, 0.47, 0.11})
            if (a.surface.Value(u.at(i), v.at(j)).Distance(b.surface.Value(u.at(i), v.at(j))) > close) return false;
    return true;
}

bool same_surface(const Surface& a, const Surface& b) {
    if (a.is_plane() || b.is_plane()) return a.is_plane() && b.is_plane() && same_plane(a, b);
    return same_parametrisation(a, b);
}

}  // namespace

std::vector<PatchFace> patch_faces(const std::vector<TopoDS_Shape>& vanished,
                                   const std::vector<TopoDS_Shape>& appeared) {
    std::vector<PatchFace> faces;
    std::vector<Surface> surfaces;
    std::vector<char> is_shared;
    for (const TopoDS_Shape& shape : vanished) {
        const Surface surface(TopoDS::Face(shape));
        const auto known = std::find_if(surfaces.begin(), surfaces.end(),
                                        [&](const Surface& other) { return same_surface(other, surface); });
        faces.push_back({surface.face, true, int(known - surfaces.begin()), faces.size()});
        if (known == surfaces.end()) surfaces.push_back(surface);
    }
    is_shared.assign(surfaces.size(), 0);
    for (const TopoDS_Shape& shape : appeared) {
        const Surface surface(TopoDS::Face(shape));
        const auto known = std::find_if(surfaces.begin(), surfaces.end(),
                                        [&](const Surface& other) { return same_surface(other, surface); });
        const bool is_alone = known == surfaces.end();
        faces.push_back(
            {surface.face, false, is_alone ? -1 : int(known - surfaces.begin()), faces.size() - vanished.size()});
        if (!is_alone) is_shared[std::size_t(known - surfaces.begin())] = 1;
    }
    for (PatchFace& face : faces)
        if (face.underlying >= 0 && !is_shared[std::size_t(face.underlying)]) face.underlying = -1;
    const auto rank = [](const PatchFace& f) { return (f.underlying < 0 ? 0 : 2) + (f.vanished ? 1 : 0); };
    std::stable_sort(faces.begin(), faces.end(),
                     [&](const PatchFace& a, const PatchFace& b) { return rank(a) < rank(b); });
    return faces;
}

}  // namespace featuremesh
