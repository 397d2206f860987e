// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/enclosure.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <utility>

#include "brep/occt_geometry.h"
#include "brep/solid_probe.h"
#include "core/errors.h"
#include "core/isolated_run.h"
#include "core/run_context.h"

namespace featuremesh {

namespace {

/// Height at which the vertical through (x, y) meets the triangle; false where it passes by.
bool crossing(const Vec3& a, const Vec3& b, const Vec3& c, double x, double y, double& z) {
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0) return false;
    const double u = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
    const double v = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
    if (u < 0 || v < 0 || u + v > 1) return false;
    z = a.z + u * (b.z - a.z) + v * (c.z - a.z);
    return true;
}

using Triangles = std::vector<std::array<Vec3, 3>>;

/// The shape gets the kernel's triangulation.
Triangles triangulate_itself(const TopoDS_Shape& shape, IMeshTools_MeshAlgoType algorithm) {
    IMeshTools_Parameters parameters;
    parameters.Deflection = 0.01, parameters.Relative = true, parameters.Angle = 0.3;
    parameters.MeshAlgo = algorithm;
    BRepMesh_IncrementalMesh mesher(shape, parameters);
    Triangles triangles;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
        if (it.Current().Orientation() == TopAbs_INTERNAL) continue;
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
        if (mesh.IsNull()) continue;
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            int a, b, c;
            mesh->Triangle(i).Get(a, b, c);
            const auto at = [&](int n) { return to_vec3(mesh->Node(n).Transformed(location)); };
            triangles.push_back({at(a), at(b), at(c)});
        }
    }
    return triangles;
}

bool has_many_holes(const TopoDS_Shape& shape) {
    constexpr int many = 100;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
        if (it.Current().NbChildren() > many) return true;
    return false;
}

/// By Delabella, in a copy of the process, since it crashes at some shapes; none when it did, or did not end.
std::optional<Triangles> triangulate_apart(const TopoDS_Shape& shape) try {
    constexpr Patience patience{60};
    const auto bytes = run_isolated(
        [&](const RunContext&) {
            const Triangles triangles = triangulate_itself(shape, IMeshTools_MeshAlgoType_Delabella);
            const auto* first = reinterpret_cast<const std::byte*>(triangles.data());
            return std::vector(first, first + triangles.size() * sizeof(Triangles::value_type));
        },
        patience, {});
    if (!bytes) return {};
    Triangles triangles(bytes->size() / sizeof(Triangles::value_type));
    if (!triangles.empty()) std::memcpy(triangles.data(), bytes->data(), bytes->size());
    return triangles;
} catch (const MeshError&) {
    return {};
}

}  // namespace

std::vector<std::array<Vec3, 3>> triangulate(const TopoDS_Shape& shape) {
    const TopoDS_Shape copy =
        BRepBuilderAPI_Copy(shape, true, false).Shape();  // the original stays without a triangulation
    if (has_many_holes(copy))                             // for 900 the default takes twenty times as long
        if (auto triangles = triangulate_apart(copy)) return *std::move(triangles);
    return triangulate_itself(copy, IMeshTools_MeshAlgoType_DEFAULT);
}

Enclosure::Enclosure(const std::vector<TopoDS_Shape>& volumes) {
    for (std::size_t v = 0; v < volumes.size(); ++v)
        for (const auto& [a, b, c] : triangulate(volumes[v])) {
            triangles_.push_back({a, b, c, std::uint32_t(v)});
            for (const Vec3& p : {a, b, c}) box_.add(p);
        }
    if (triangles_.empty()) return;
    const Vec3 size = box_.size();
    pitch_ = std::max({size.x, size.y, 1e-9}) / 64;
    columns_ = std::size_t(size.x / pitch_) + 1;
    rows_ = std::size_t(size.y / pitch_) + 1;
    columns_triangles_.resize(columns_ * rows_);
    for (std::size_t id = 0; id < triangles_.size(); ++id) {
        Box b;
        for (const Vec3& p : {triangles_[id].a, triangles_[id].b, triangles_[id].c}) b.add(p);
        const std::size_t i1 = std::size_t((b.high.x - box_.low.x) / pitch_),
                          j1 = std::size_t((b.high.y - box_.low.y) / pitch_);
        for (std::size_t i = std::size_t((b.low.x - box_.low.x) / pitch_); i <= std::min(i1, columns_ - 1); ++i)
            for (std::size_t j = std::size_t((b.low.y - box_.low.y) / pitch_); j <= std::min(j1, rows_ - 1); ++j)
                columns_triangles_[i * rows_ + j].push_back(std::uint32_t(id));
    }
}

bool Enclosure::contains(const Vec3& p) const {
    if (!box_.contains(p)) return false;
    // Off the lattice planes on which CAD vertices like to lie, so that no ray passes through a side.
    const double x = p.x + 1.7e-7 * pitch_ * 64, y = p.y + 2.3e-7 * pitch_ * 64;
    const std::size_t i = std::min(std::size_t(std::max(0.0, (x - box_.low.x) / pitch_)), columns_ - 1);
    const std::size_t j = std::min(std::size_t(std::max(0.0, (y - box_.low.y) / pitch_)), rows_ - 1);
    bool inside = false;
    std::uint32_t volume = 0;
    for (const std::uint32_t id : columns_triangles_[i * rows_ + j]) {
        const Triangle& t = triangles_[id];
        if (t.volume != volume && inside) return true;
        volume = t.volume;
        double z;
        if (crossing(t.a, t.b, t.c, x, y, z) && z > p.z) inside = !inside;
    }
    return inside;
}

struct SolidLocator::Data {
    std::vector<std::unique_ptr<SolidProbe>> probes;
};

SolidLocator::SolidLocator(const Brep& brep) : data_(std::make_unique<Data>()) {
    for (std::size_t s = 0; s < brep.solid_count(); ++s)
        data_->probes.push_back(std::make_unique<SolidProbe>(brep, SolidId(s)));
}
SolidLocator::~SolidLocator() = default;

SolidId SolidLocator::solid_at(const Vec3& p, std::span<const char> may_be) const {
    for (std::size_t s = 0; s < data_->probes.size(); ++s)
        if ((may_be.empty() || may_be[s]) && data_->probes[s]->containment_of(p) == Containment::inside)
            return SolidId(s);
    return SolidId();
}

PointGrid::PointGrid(std::vector<Vec3> points, double spacing) : spacing_(spacing) {
    std::vector<std::pair<std::array<std::int64_t, 3>, std::size_t>> order;
    order.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) order.emplace_back(bucket_of(points[i]), i);
    std::sort(order.begin(), order.end());
    for (const auto& [bucket, i] : order) {
        points_.push_back(points[i]);
        buckets_.push_back(bucket);
    }
}

std::array<std::int64_t, 3> PointGrid::bucket_of(const Vec3& p) const {
    const auto at = [&](double c) { return std::int64_t(std::floor(c / spacing_)); };
    return {at(p.x), at(p.y), at(p.z)};
}

bool PointGrid::has_within(const Vec3& p, double radius) const {
    const auto centre = bucket_of(p);
    for (std::int64_t i = -1; i <= 1; ++i)
        for (std::int64_t j = -1; j <= 1; ++j) {
            const std::array<std::int64_t, 3> low{centre[0] + i, centre[1] + j, centre[2] - 1},
                high{low[0], low[1], centre[2] + 2};
            for (auto it = std::lower_bound(buckets_.begin(), buckets_.end(), low); it != buckets_.end() && *it < high;
                 ++it)
                if (squared_length(points_[std::size_t(it - buckets_.begin())] - p) < radius * radius) return true;
        }
    return false;
}

}  // namespace featuremesh
