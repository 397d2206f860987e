// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/shape_coverage.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>

#include "brep/enclosure.h"
#include "brep/occt_geometry.h"
#include "mesh/second_order.h"

namespace featuremesh {

namespace {

constexpr double nearest_corner =
    0.6;  // of a triangle's longest side: no point of it is further from its corners (1 / sqrt 3)

/// Halves the longest side until none is longer than `spacing`; the centres.
void cover(const std::array<Vec3, 3>& triangle, double spacing, std::vector<Vec3>& points) {
    std::vector<std::array<Vec3, 3>> open{triangle};
    while (!open.empty()) {
        const auto [a, b, c] = open.back();
        open.pop_back();
        const double ab = distance(a, b), bc = distance(b, c), ca = distance(c, a);
        const double longest = std::max({ab, bc, ca});
        if (longest <= spacing) {
            points.push_back((a + b + c) / 3);
            continue;
        }
        const auto [p, q, r] = longest == ab   ? std::array{a, b, c}
                               : longest == bc ? std::array{b, c, a}
                                               : std::array{c, a, b};
        const Vec3 middle = (p + q) * 0.5;
        open.push_back({p, middle, r});
        open.push_back({middle, q, r});
    }
}

}  // namespace

EdgeRange range_of(const Brep& brep, EdgeId edge) {
    const BRepAdaptor_Curve curve(brep.edge(edge));
    return {curve.FirstParameter(), curve.LastParameter()};
}

void sample_edge(const Brep& brep, EdgeId edge, EdgeRange piece, double spacing, std::vector<Vec3>& points) {
    constexpr int coarse = 16;
    const BRepAdaptor_Curve curve(brep.edge(edge));
    const auto at = [&](double share) {
        return to_vec3(curve.Value(piece.first + share * (piece.last - piece.first)));
    };
    for (int i = 0; i < coarse; ++i) {
        const Vec3 start = at(double(i) / coarse);
        const int fine = int(2 * distance(start, at(double(i + 1) / coarse)) / spacing) + 1;
        for (int k = 0; k < fine; ++k) points.push_back(at((i + double(k) / fine) / coarse));
    }
    points.push_back(at(1));
}

void sample_open_faces(const Brep& brep, const Mesh& mesh, const std::vector<MatchedTriangle>& triangles,
                       double spacing, std::vector<FaceId>& open, std::vector<Vec3>& points,
                       const RunContext& context) {
    std::vector<std::vector<Vec3>> corners(brep.face_count());
    std::vector<double> longest(brep.face_count(), 0);
    for (const MatchedTriangle& t : triangles)
        for (int k = 0; k < 3; ++k) {
            corners[t.face.index()].push_back(mesh.point(t.nodes[k]));
            longest[t.face.index()] =
                std::max(longest[t.face.index()], distance(mesh.point(t.nodes[k]), mesh.point(t.nodes[(k + 1) % 3])));
        }
    const Projector projector(brep);
    RoundWatch watch(context);
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        if (!brep.is_meshed(FaceId(f))) continue;
        const double reach = nearest_corner * longest[f] + spacing;
        const PointGrid grid(std::move(corners[f]), reach);
        const std::size_t before = points.size();
        std::vector<Vec3> samples;
        for (const auto& triangle : triangulate(brep.face(FaceId(f)).Oriented(TopAbs_FORWARD)))
            cover(triangle, spacing, samples);
        for (const Vec3& p : samples) {
            watch();
            if (grid.has_within(p, reach)) continue;
            const Vec3 foot =
                projector.nearest(FaceId(f), p).point;  // the triangulation is coarse where the face is large
            if (!grid.has_within(foot, reach)) points.push_back(foot);
        }
        if (points.size() > before) open.push_back(FaceId(f));
    }
}

std::vector<double> longest_sides(const Mesh& mesh) {
    std::vector<double> longest(mesh.node_count(), 0);
    for (const auto& tet : mesh.tets) {
        double side = 0;
        for (const auto& [i, j] : tet_sides) side = std::max(side, distance(mesh.point(tet[i]), mesh.point(tet[j])));
        for (const NodeId n : tet) longest[n.index()] = std::max(longest[n.index()], side);
    }
    return longest;
}

double mean_side(const Mesh& mesh) {
    double sum = 0;
    for (const auto& tet : mesh.tets)
        for (const auto& [i, j] : tet_sides) sum += distance(mesh.point(tet[i]), mesh.point(tet[j]));
    return mesh.tets.empty() ? 0 : sum / (6 * double(mesh.tets.size()));
}

}  // namespace featuremesh
