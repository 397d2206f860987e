// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/turned_triangles.h"

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <optional>

#include "brep/occt_geometry.h"
#include "core/geometry.h"
#include "surface/face_parameters.h"
#include "surface/projection.h"

namespace featuremesh {

namespace {

constexpr std::size_t grain = 1 << 12;
/// Needles along a curved edge stand almost upright on their face; they are no folds.
constexpr double least_against = -0.2;
constexpr double at_apex = 1e-6;  // mm

using Uv = std::array<double, 2>;

class NormalCheck {
  public:
    NormalCheck(const Brep& brep, const Mesh& mesh) : brep_(brep), mesh_(mesh), projector_(brep) {}

    bool is_turned(TriangleId id) {
        const auto& corners = mesh_.triangles[id.index()];
        const FaceId face = mesh_.triangle_faces[id.index()];
        enter(face);
        const Vec3 &a = mesh_.point(corners[0]), &b = mesh_.point(corners[1]), &c = mesh_.point(corners[2]);
        const Vec3 across = cross(b - a, c - a);
        const double most = least_against * length(across);
        if (plane_normal_) return dot(across, *plane_normal_) < most;
        int seen = 0;
        for (const NodeId n : corners) {
            if (apex_ && distance(mesh_.point(n), *apex_) < at_apex) continue;
            const std::optional<Uv> uv = parameters_on(brep_, face, mesh_, n);
            if (!uv) continue;
            ++seen;
            if (!(dot(across, projector_.normal(face, *uv)) < most)) return false;
        }
        return seen > 0;
    }

  private:
    void enter(FaceId face) {
        if (face == face_) return;
        face_ = face;
        plane_normal_.reset(), apex_.reset();
        const BRepAdaptor_Surface surface(brep_.face(face), false);
        if (surface.GetType() == GeomAbs_Plane) plane_normal_ = projector_.normal(face, {0, 0});
        if (surface.GetType() == GeomAbs_Cone) apex_ = to_vec3(surface.Cone().Apex());
    }

    const Brep& brep_;
    const Mesh& mesh_;
    const Projector projector_;
    FaceId face_;
    std::optional<Vec3> plane_normal_;
    std::optional<Vec3> apex_;  ///< of a cone, which has no normal there
};

}  // namespace

std::vector<TriangleId> turned_triangles(const Brep& brep, const Mesh& mesh, const std::vector<char>& is_wanted,
                                         RunContext& context) {
    const auto is_looked_at = [&](const std::array<NodeId, 3>& corners) {
        return is_wanted.empty() ||
               std::all_of(corners.begin(), corners.end(), [&](NodeId n) { return is_wanted[n.index()] != 0; });
    };
    std::vector<std::vector<TriangleId>> parts((mesh.triangles.size() + grain - 1) / grain);
    parallel_for(context, mesh.triangles.size(), grain, [&](std::size_t begin, std::size_t end) {
        std::optional<NormalCheck> check;  // kept chunks need none
        for (std::size_t t = begin; t < end; ++t) {
            if (!is_looked_at(mesh.triangles[t])) continue;
            if (!check) check.emplace(brep, mesh);
            if (check->is_turned(TriangleId(t))) parts[begin / grain].push_back(TriangleId(t));
        }
    });
    std::vector<TriangleId> turned;
    for (const auto& part : parts) turned.insert(turned.end(), part.begin(), part.end());
    return turned;
}

}  // namespace featuremesh
