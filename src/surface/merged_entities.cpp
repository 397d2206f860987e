// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/merged_entities.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "surface/projection.h"

namespace featuremesh {

namespace {

std::vector<std::vector<SolidId>> solids_of_vertices(const Brep& brep) {
    std::vector<std::vector<SolidId>> solids(brep.vertex_count());
    for (std::size_t v = 0; v < solids.size(); ++v) {
        for (const EdgeId e : brep.edges_of(VertexId(v)))
            for (const FaceId f : brep.faces_of(e))
                for (const SolidId s : brep.sides_of(f))
                    if (s.is_valid()) solids[v].push_back(s);
        std::sort(solids[v].begin(), solids[v].end());
        solids[v].erase(std::unique(solids[v].begin(), solids[v].end()), solids[v].end());
    }
    return solids;
}

bool share(const std::vector<SolidId>& a, const std::vector<SolidId>& b) {
    return std::any_of(a.begin(), a.end(), [&](SolidId s) { return std::binary_search(b.begin(), b.end(), s); });
}

/// Each vertex takes the lowest one near it that stands for itself.
std::vector<VertexId> merge_vertices(const Brep& brep, double tolerance) {
    const std::vector<std::vector<SolidId>> solids = solids_of_vertices(brep);
    std::vector<std::size_t> by_x(brep.vertex_count());
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    const auto point = [&](std::size_t v) { return brep.point_of(VertexId(v)); };
    std::sort(by_x.begin(), by_x.end(),
              [&](std::size_t a, std::size_t b) { return std::pair(point(a).x, a) < std::pair(point(b).x, b); });
    std::vector<std::vector<std::size_t>> lower(by_x.size());
    for (std::size_t i = 0; i < by_x.size(); ++i)
        for (std::size_t j = i + 1; j < by_x.size() && point(by_x[j]).x - point(by_x[i]).x <= tolerance; ++j) {
            const auto [a, b] = std::minmax(by_x[i], by_x[j]);
            if (distance(point(a), point(b)) <= tolerance && share(solids[a], solids[b])) lower[b].push_back(a);
        }
    std::vector<VertexId> merged;
    for (std::size_t v = 0; v < lower.size(); ++v) {
        merged.emplace_back(v);
        std::sort(lower[v].begin(), lower[v].end());
        for (const std::size_t a : lower[v])
            if (merged[a] == VertexId(a)) {
                merged[v] = VertexId(a);
                break;
            }
    }
    return merged;
}

std::array<double, 2> range_of(const BRepAdaptor_Curve& curve) {
    return {curve.FirstParameter(), curve.LastParameter()};
}

Vec3 point_at(const BRepAdaptor_Curve& curve, double share) {
    const auto [first, last] = range_of(curve);
    const gp_Pnt p = curve.Value(first + share * (last - first));
    return {p.X(), p.Y(), p.Z()};
}

constexpr std::array<double, 5> probes{0.5, 0.25, 0.75, 0.1, 0.9};

/// Both of whose ends are this vertex.
bool is_point(const Brep& brep, EdgeId edge, VertexId vertex, double tolerance) {
    const BRepAdaptor_Curve curve(brep.edge(edge));
    return std::all_of(probes.begin(), probes.end(), [&](double share) {
        return distance(point_at(curve, share), brep.point_of(vertex)) <= 2 * tolerance;
    });
}

/// With ends in common: whether the first runs along the second.
bool runs_along(const Brep& brep, const Projector& projector, EdgeId edge, EdgeId other, double tolerance) {
    const BRepAdaptor_Curve curve(brep.edge(edge));
    if (curve.GetType() == GeomAbs_Line && BRepAdaptor_Curve(brep.edge(other)).GetType() == GeomAbs_Line) return true;
    return std::all_of(probes.begin(), probes.end(), [&](double share) {
        return projector.nearest(other, point_at(curve, share)).distance <= tolerance;
    });
}

std::string listed(const std::vector<Entity>& entities) {
    constexpr std::size_t most = 6;
    std::string names;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (i == most) return names + " and " + std::to_string(entities.size() - most) + " more";
        names += (names.empty() ? "" : ", ") + name_of(entities[i]);
    }
    return names;
}

}  // namespace

MergedEntities::MergedEntities(const Brep& brep)
    : vertex_of(merge_vertices(brep, brep.tolerances().negligible())),
      is_point(brep.edge_count(), 0),
      is_flat(brep.face_count(), 0) {
    const double tolerance = brep.tolerances().negligible();
    const Projector projector(brep);
    std::map<std::array<VertexId, 2>, std::vector<EdgeId>> between;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        const EdgeId edge(e);
        edge_of.push_back(edge);
        auto ends = brep.ends_of(edge);
        if (brep.is_degenerated(edge) || !ends[0].is_valid() || !ends[1].is_valid()) continue;
        const bool was_closed = ends[0] == ends[1];
        for (VertexId& v : ends) v = vertex_of[v.index()];
        if (ends[0] == ends[1] && !was_closed) is_point[e] = featuremesh::is_point(brep, edge, ends[0], tolerance);
        if (ends[0] == ends[1]) continue;
        std::sort(ends.begin(), ends.end());
        for (const EdgeId other : between[ends])
            if (runs_along(brep, projector, edge, other, tolerance)) {
                edge_of[e] = other;
                break;
            }
        if (edge_of[e] == edge) between[ends].push_back(edge);
    }
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        std::map<EdgeId, int> sides;
        for (const EdgeId e : brep.edges_of(FaceId(f)))
            if (!brep.is_degenerated(e) && !is_point[e.index()]) ++sides[edge_of[e.index()]];
        is_flat[f] = !brep.edges_of(FaceId(f)).empty() &&
                     std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 2; });
    }
}

std::vector<std::string> MergedEntities::warnings() const {
    std::vector<Entity> vertices, edges, faces;
    for (std::size_t v = 0; v < vertex_of.size(); ++v)
        if (vertex_of[v] != VertexId(v)) vertices.push_back(entity_of(VertexId(v)));
    for (std::size_t e = 0; e < edge_of.size(); ++e)
        if (is_point[e]) edges.push_back(entity_of(EdgeId(e)));
    for (std::size_t f = 0; f < is_flat.size(); ++f)
        if (is_flat[f]) faces.push_back(entity_of(FaceId(f)));
    std::vector<std::string> lines;
    if (!vertices.empty())
        lines.push_back(
            "In the place of another vertex within a millionth of the part, with which they share a node: " +
            listed(vertices) + ".");
    if (!edges.empty()) lines.push_back("Too short for an element of their own: " + listed(edges) + ".");
    if (!faces.empty()) lines.push_back("Too narrow for elements of their own: " + listed(faces) + ".");
    return lines;
}

}  // namespace featuremesh
