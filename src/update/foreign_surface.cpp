// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/foreign_surface.h"

#include <TopoDS_Face.hxx>
#include <limits>

#include "brep/enclosure.h"
#include "brep/occt_geometry.h"
#include "mesh/second_order.h"
#include "mesh/side_table.h"
#include "mesh/triangle_uses.h"
#include "surface/projection.h"
#include "update/shape_coverage.h"

namespace featuremesh {

namespace {

/// A side of the surface with the faces of the triangles that meet there.
struct SurfaceSide {
    std::array<NodeId, 2> nodes;
    std::vector<FaceId> faces;
};

class Matcher {
  public:
    Matcher(const Brep& brep, const Mesh& mesh, double tolerance, RunContext& context)
        : brep_(brep),
          mesh_(mesh),
          tolerance_(tolerance),
          context_(context),
          finder_(brep, tolerance),
          mids_(mesh.node_count()),
          sides_of_nodes_(mesh.node_count()) {
        out_.places.resize(mesh.node_count());
        out_.is_misfit.assign(mesh.node_count(), 0);
    }

    ForeignSurface run() {
        collect_sides();
        locate_nodes();
        match_triangles();
        match_sides();
        follow_edges();
        release_uncovered();
        return std::move(out_);
    }

  private:
    const Vec3& point(NodeId n) const { return mesh_.point(n); }
    const PointPlace& place(NodeId n) const { return out_.places[n.index()]; }
    template <std::size_t N>
    void misfit(const std::array<NodeId, N>& nodes) {
        for (const NodeId n : nodes) out_.is_misfit[n.index()] = 1;
    }

    // Outer triangles, and inner ones that may lie on a face between two solids.
    void collect_sides() {
        std::vector<Box> between;
        for (std::size_t f = 0; f < brep_.face_count(); ++f) {
            const auto solids = brep_.solids_beside(FaceId(f));
            if (solids[0].is_valid() && solids[1].is_valid())
                between.push_back(box_of(brep_.face(FaceId(f))).grown(tolerance_));
        }
        TriangleUses uses(mesh_);
        for (std::size_t b = 0; b < uses.bucket_count(); ++b)
            uses.visit_bucket(b, [&](std::span<const TriangleUse> meeting) { collect(b, meeting, between); });
        if (mesh_.order == 2)
            for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
                for (int s = 0; s < 6; ++s)
                    mids_.value(mesh_.tets[t][tet_sides[s][0]], mesh_.tets[t][tet_sides[s][1]]) =
                        mesh_.tet_mids[t][s].value;
    }

    void collect(std::size_t smallest, std::span<const TriangleUse> meeting, const std::vector<Box>& between) {
        const auto count =
            std::count_if(meeting.begin(), meeting.end(), [](const TriangleUse& use) { return use.is_tet(); });
        const auto tets = meeting.subspan(0, std::size_t(count));
        if (tets.empty()) return;
        const NodeId a(smallest), b{std::size_t(tets[0].middle)}, c{std::size_t(tets[0].largest)};
        if (tets.size() > 2 || (tets.size() == 2 && tets[0].is_forward() == tets[1].is_forward())) {
            ++out_.misfits.overlaps;
            misfit(std::array{a, b, c});
            return;
        }
        const auto may_hold = [&](const Box& box) {
            return box.contains(point(a)) && box.contains(point(b)) && box.contains(point(c));
        };
        if (tets.size() == 2 && std::none_of(between.begin(), between.end(), may_hold)) return;
        MatchedTriangle triangle;
        triangle.nodes = tets[0].is_forward() ? std::array{a, b, c} : std::array{a, c, b};
        triangle.tets = {TetId(tets[0].element()), tets.size() == 2 ? TetId(tets[1].element()) : TetId()};
        if (tets.size() < meeting.size()) triangle.number = mesh_.triangle_numbers[meeting[tets.size()].element()];
        out_.triangles.push_back(triangle);
    }

    void locate_nodes() {
        std::vector<char> is_wanted(mesh_.node_count(), 0);
        is_outer_.assign(mesh_.node_count(), 0);
        for (const MatchedTriangle& t : out_.triangles)
            for (int k = 0; k < 3; ++k) {
                const bool is_outer = !t.tets[1].is_valid();
                const std::int32_t mid = mids_.find(t.nodes[k], t.nodes[(k + 1) % 3]);
                for (const std::int32_t n : {t.nodes[k].value, mid})
                    if (n >= 0) is_wanted[std::size_t(n)] = 1, is_outer_[std::size_t(n)] |= is_outer;
            }
        std::vector<std::size_t> wanted;
        for (std::size_t n = 0; n < is_wanted.size(); ++n)
            if (is_wanted[n]) wanted.push_back(n);
        parallel_for(context_, wanted.size(), 4096, [&](std::size_t begin, std::size_t end) {
            const EntityFinder finder = finder_.another();
            for (std::size_t i = begin; i < end; ++i) out_.places[wanted[i]] = finder.find(mesh_.points[wanted[i]]);
        });
        for (const std::size_t n : wanted)
            if (n < mesh_.corner_count && is_outer_[n] && out_.places[n].entity.dim == 3)
                ++out_.misfits.nodes_off_surface, out_.is_misfit[n] = 1;
    }

    void match_triangles() {
        std::vector<MatchedTriangle> matched;
        for (MatchedTriangle& triangle : out_.triangles) {
            triangle.face = face_of(triangle);
            if (triangle.face.is_valid()) {
                orient(triangle);
                matched.push_back(triangle);
            } else if (!triangle.tets[1].is_valid()) {
                out_.misfits.triangles_on_no_face += !has_misfit(triangle.nodes);
                misfit(triangle.nodes);
            }
        }
        out_.triangles = std::move(matched);
    }

    bool has_misfit(const std::array<NodeId, 3>& nodes) const {
        return std::any_of(nodes.begin(), nodes.end(), [&](NodeId n) { return out_.is_misfit[n.index()]; });
    }

    Vec3 normal_of(const MatchedTriangle& t) const {
        return cross(point(t.nodes[1]) - point(t.nodes[0]), point(t.nodes[2]) - point(t.nodes[0]));
    }
    Vec3 centre_of(const MatchedTriangle& t) const {
        return (point(t.nodes[0]) + point(t.nodes[1]) + point(t.nodes[2])) / 3;
    }

    // The nearest of the faces that all three nodes touch; one with the solid where the tet is, where it is the mesh's
    // boundary.
    FaceId face_of(const MatchedTriangle& triangle) const {
        const bool is_inner = triangle.tets[1].is_valid();
        std::vector<FaceId> faces = faces_at(brep_, place(triangle.nodes[0]).entity);
        for (int k = 1; k < 3; ++k) faces = in_both(faces, faces_at(brep_, place(triangle.nodes[k]).entity));
        const bool is_sure = faces.size() == 1 && std::any_of(triangle.nodes.begin(), triangle.nodes.end(),
                                                              [&](NodeId n) { return place(n).entity.dim == 2; });
        FaceId best;
        double nearest = std::numeric_limits<double>::infinity();
        for (const FaceId face : faces) {
            const auto solids = brep_.solids_beside(face);
            if (is_inner != (solids[0].is_valid() && solids[1].is_valid())) continue;
            const OnFace foot = finder_.projector().nearest(face, centre_of(triangle));
            const double outward =
                dot(finder_.projector().normal(face, foot.uv), normal_of(triangle)) * (solids[0].is_valid() ? 1 : -1);
            if (foot.distance >= nearest || (!is_inner && outward <= 0)) continue;
            if (!is_sure && !finder_.projector().is_inside_trim(face, foot.uv)) continue;
            nearest = foot.distance;
            best = face;
        }
        return best;
    }

    void orient(MatchedTriangle& triangle) const {
        const OnFace foot = finder_.projector().nearest(triangle.face, centre_of(triangle));
        if (dot(finder_.projector().normal(triangle.face, foot.uv), normal_of(triangle)) >= 0) return;
        std::swap(triangle.nodes[1], triangle.nodes[2]);
        std::swap(triangle.tets[0], triangle.tets[1]);
    }

    // Where triangles of different faces meet there has to be an edge of theirs.
    void match_sides() {
        for (const MatchedTriangle& t : out_.triangles)
            for (int k = 0; k < 3; ++k) add_side(t.nodes[k], t.nodes[(k + 1) % 3], t.face);
        for (SurfaceSide& side : sides_) {
            std::sort(side.faces.begin(), side.faces.end());
            const EdgeId edge = edge_of(side);
            const bool is_within_face = side.faces.size() == 2 && side.faces[0] == side.faces[1];
            if (edge.is_valid())
                out_.segments.push_back({side.nodes, edge});
            else if (!is_within_face) {
                out_.misfits.sides_on_no_edge +=
                    !out_.is_misfit[side.nodes[0].index()] && !out_.is_misfit[side.nodes[1].index()];
                misfit(side.nodes);
            }
            if (mesh_.order == 2 && (edge.is_valid() || is_within_face))
                check_mid(side, edge.is_valid() ? entity_of(edge) : entity_of(side.faces[0]));
        }
    }

    void add_side(NodeId a, NodeId b, FaceId face) {
        std::int32_t& index = sides_of_nodes_.value(a, b);
        if (index < 0) {
            index = std::int32_t(sides_.size());
            sides_.push_back({{a, b}, {}});
        }
        sides_[std::size_t(sides_of_nodes_.find(a, b))].faces.push_back(face);
    }

    EdgeId edge_of(const SurfaceSide& side) const {
        const auto edges =
            in_both(edges_at(brep_, place(side.nodes[0]).entity), edges_at(brep_, place(side.nodes[1]).entity));
        const Vec3 middle = (point(side.nodes[0]) + point(side.nodes[1])) * 0.5;
        EdgeId best;
        double nearest = std::numeric_limits<double>::infinity();
        for (const EdgeId edge : edges) {
            if (brep_.is_degenerated(edge) || faces_around(edge) != side.faces) continue;
            const double d = finder_.projector().nearest(edge, middle).distance;
            if (d < nearest) nearest = d, best = edge;
        }
        return best;
    }

    // As the triangles along the edge show them: a seam has its face left and right.
    std::vector<FaceId> faces_around(EdgeId edge) const {
        std::vector<FaceId> faces;
        for (const FaceId face : brep_.faces_of(edge)) {
            if (!brep_.is_meshed(face)) continue;
            faces.push_back(face);
            if (brep_.is_seam(edge, face)) faces.push_back(face);
        }
        std::sort(faces.begin(), faces.end());
        return faces;
    }

    // A mid-side node on the boundary has to lie on what its side lies on.
    void check_mid(const SurfaceSide& side, Entity entity) {
        const std::int32_t mid = mids_.find(side.nodes[0], side.nodes[1]);
        if (mid < 0 || out_.places[std::size_t(mid)].entity == entity) return;
        const Vec3& p = mesh_.points[std::size_t(mid)];
        const Vec3 foot = entity.dim == 1 ? finder_.projector().nearest(EdgeId(entity.index), p).point
                                          : finder_.projector().nearest(FaceId(entity.index), p).point;
        out_.moved_mids.push_back({NodeId(mid), foot});
    }

    // Nodes of an edge by parameter have to be joined one after the other; where they are not, the edge is open.
    void follow_edges() {
        std::vector<std::vector<std::pair<double, NodeId>>> inner(brep_.edge_count());
        std::vector<NodeId> at_vertex(brep_.vertex_count());
        for (std::size_t n = 0; n < mesh_.corner_count; ++n) {
            const PointPlace& p = out_.places[n];
            if (p.entity.dim == 0) {
                NodeId& first = at_vertex[std::size_t(p.entity.index)];
                if (first.is_valid())
                    out_.is_misfit[n] = 1;
                else
                    first = NodeId(n);
            }
            if (p.entity.dim == 1) inner[std::size_t(p.entity.index)].emplace_back(p.parameters[0], NodeId(n));
        }
        std::vector<std::vector<MatchedSegment>> on_edge(brep_.edge_count());
        for (const MatchedSegment& s : out_.segments) on_edge[s.edge.index()].push_back(s);
        out_.segments.clear();
        for (std::size_t e = 0; e < brep_.edge_count(); ++e) {
            if (brep_.is_degenerated(EdgeId(e)) || faces_at(brep_, entity_of(EdgeId(e))).empty()) continue;
            std::sort(inner[e].begin(), inner[e].end());
            follow(EdgeId(e), inner[e], at_vertex, on_edge[e]);
        }
    }

    void follow(EdgeId edge, const std::vector<std::pair<double, NodeId>>& inner, const std::vector<NodeId>& at_vertex,
                const std::vector<MatchedSegment>& segments) {
        const EdgeRange range = range_of(brep_, edge);
        const auto ends = brep_.ends_of(edge);
        std::vector<std::pair<double, NodeId>> chain{{range.first, at_vertex[ends[0].index()]}};
        chain.insert(chain.end(), inner.begin(), inner.end());
        chain.emplace_back(range.last, at_vertex[ends[1].index()]);
        std::vector<char> is_met(segments.size(), 0);
        bool is_open = false;
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const NodeId a = chain[i].second, b = chain[i + 1].second;
            const auto found = std::find_if(segments.begin(), segments.end(), [&](const MatchedSegment& s) {
                return s.nodes == std::array{a, b} || s.nodes == std::array{b, a};
            });
            if (found != segments.end() && !is_met[std::size_t(found - segments.begin())] &&
                chain[i].first < chain[i + 1].first) {
                is_met[std::size_t(found - segments.begin())] = 1;
                out_.segments.push_back({{a, b}, edge});
            } else {
                is_open = true;
                sample_edge(brep_, edge, {chain[i].first, chain[i + 1].first}, spacing(), gaps_);
            }
        }
        if (is_open) out_.misfits.open_edges.push_back(edge);
        for (std::size_t s = 0; s < segments.size(); ++s)
            if (!is_met[s]) misfit(segments[s].nodes);
    }

    // Tets that the shape's boundary cuts have a node within their longest side of an open place.
    void release_uncovered() {
        const std::vector<double> reach = longest_sides(mesh_);
        const double longest = *std::max_element(reach.begin(), reach.end());
        sample_open_faces(brep_, mesh_, out_.triangles, spacing(), out_.misfits.open_faces, gaps_, context_);
        if (gaps_.empty()) return;
        const PointGrid grid(gaps_, longest + spacing());
        parallel_for(context_, mesh_.corner_count, 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n)
                if (grid.has_within(mesh_.points[n], reach[n] + spacing())) out_.is_misfit[n] = 1;
        });
    }

    /// No smaller than a share of the shape, however small the elements are: a mesh in other units would take all
    /// memory.
    double spacing() {
        constexpr double least_share = 1e-3;
        if (spacing_ == 0) spacing_ = std::max(0.5 * mean_side(mesh_), least_share * brep_.tolerances().diagonal);
        return spacing_;
    }

    const Brep& brep_;
    const Mesh& mesh_;
    double tolerance_;
    RunContext& context_;
    EntityFinder finder_;
    SideTable mids_, sides_of_nodes_;
    std::vector<SurfaceSide> sides_;
    std::vector<char> is_outer_;
    std::vector<Vec3> gaps_;
    double spacing_ = 0;
    ForeignSurface out_;
};

}  // namespace

ForeignSurface match_surface(const Brep& brep, const Mesh& mesh, double tolerance, RunContext& context) {
    return Matcher(brep, mesh, tolerance, context).run();
}

}  // namespace featuremesh
