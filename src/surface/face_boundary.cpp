// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_boundary.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <limits>
#include <map>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "core/errors.h"
#include "core/message.h"
#include "core/messages.h"
#include "core/sort_once.h"
#include "surface/projection.h"

namespace featuremesh {

namespace {

/// One use of an edge by the face, in the direction that has the face on its left.
struct Use {
    EdgeId edge;
    NodeId start, end;
    std::vector<Vec2> points;  ///< in the direction of the use
    std::vector<NodeId> nodes;
    std::vector<std::size_t> pieces;
    bool is_pole = false, is_inner = false;
    bool is_closed_slit = false;           ///< inner, since the face has it on both sides
    int start_point = -1, end_point = -1;  ///< index in the boundary, once the uses are joined
};

/// A pole is drawn as a line of several points in the chart, so that the triangles around it find a corner each.
constexpr int pole_pieces = 8;

class BoundaryBuilder {
  public:
    BoundaryBuilder(const Brep& brep, FaceId face, const Chart& chart, const EdgeChains& chains, const Mesh& mesh)
        : brep_(brep), face_(face), chart_(chart), chains_(chains), mesh_(mesh) {}

    FaceBoundary from_loops() {
        collect_uses();
        close_slits();
        join_uses();
        for (const Use& use : uses_) add_segments(use);
        add_vertices_inside();
        return std::move(boundary_);
    }

  private:
    void collect_uses() {
        const TopoDS_Face forward = TopoDS::Face(brep_.face(face_).Oriented(TopAbs_FORWARD));
        for (TopExp_Explorer it(forward, TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
            double first = 0, last = 0;
            const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, forward, first, last);
            if (curve.IsNull()) fail(say<Code::edge_without_trace>(brep_.find(edge)));
            Use use;
            use.edge = brep_.find(edge);
            if (chains_.is_point(use.edge)) {
                points_.push_back(brep_.ends_of(use.edge)[0]);
                continue;
            }
            use.is_pole = brep_.is_degenerated(use.edge);
            use.is_inner = edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED;
            sample(use, *curve, first, last);
            if (edge.Orientation() == TopAbs_REVERSED) {
                std::reverse(use.points.begin(), use.points.end());
                std::reverse(use.nodes.begin(), use.nodes.end());
                std::reverse(use.pieces.begin(), use.pieces.end());
            }
            // A cone's apex is one point of its developed plane.
            const double extent = distance(use.points.front(), use.points.back());
            if (use.is_pole && extent < 1e-9 * (1 + brep_.tolerances().diagonal)) continue;
            use.start = use.nodes.front(), use.end = use.nodes.back();
            uses_.push_back(std::move(use));
        }
    }

    void sample(Use& use, const Geom2d_Curve& curve, double first, double last) const {
        const auto add = [&](double t, NodeId node) {
            const gp_Pnt2d uv = curve.Value(t);
            use.points.push_back(chart_.to_plane({uv.X(), uv.Y()}));
            use.nodes.push_back(node);
        };
        if (use.is_pole) {
            const NodeId node = chains_.node_of(brep_.ends_of(use.edge)[0]);
            for (int i = 0; i <= pole_pieces; ++i) add(first + (last - first) * i / pole_pieces, node);
            for (std::size_t i = 0; i < pole_pieces; ++i) use.pieces.push_back(i);
            return;
        }
        const EdgeChain& chain = chains_[use.edge];
        // The range of the curve in the face is the edge's own; rescaling covers edges that are not "same range".
        const double t0 = chain.t.front(), scale = (last - first) / (chain.t.back() - t0);
        for (std::size_t i = 0; i < chain.nodes.size(); ++i) add(first + scale * (chain.t[i] - t0), chain.nodes[i]);
        for (std::size_t i = 0; i < chain.piece_count(); ++i) use.pieces.push_back(i);
    }

    /// Pieces that two edges have in common, there and back, are no border: a spike or a slit too narrow for elements
    /// of its own. Where the face is on both sides they are inside.
    void close_slits() {
        const auto follows = [&](const Use& use) {
            return !use.is_pole && std::any_of(use.pieces.begin(), use.pieces.end(), [&](std::size_t piece) {
                return chains_.owner_of({use.edge, piece}).edge != use.edge;
            });
        };
        if (std::none_of(uses_.begin(), uses_.end(), follows)) return;
        std::map<EdgeChains::Piece, std::vector<Side>> sides_of;
        for (const Use& use : uses_)
            for (std::size_t i = 0; i < use.pieces.size(); ++i)
                if (!use.is_pole && !use.is_inner)
                    sides_of[chains_.owner_of({use.edge, use.pieces[i]})].push_back(side_of(use, i));
        std::erase_if(sides_of, [](const auto& with) { return !are_of_slit(with.second); });
        if (sides_of.empty()) return;
        std::vector<Use> whole = std::exchange(uses_, {});
        for (const Use& use : whole) {
            const auto first_of_two = [&](std::size_t piece) {
                const auto with = sides_of.find(chains_.owner_of({use.edge, piece}));
                const bool is_border = use.is_pole || use.is_inner || with == sides_of.end();
                return is_border ? EdgeId() : with->second.front().edge;
            };
            for (std::size_t begin = 0, end; begin < use.pieces.size(); begin = end) {
                const EdgeId first = first_of_two(use.pieces[begin]);
                end = begin + 1;
                while (end < use.pieces.size() && first_of_two(use.pieces[end]) == first) ++end;
                if (first.is_valid() && first != use.edge) continue;
                uses_.push_back(part_of(use, begin, end));
                if (first.is_valid()) uses_.back().is_inner = uses_.back().is_closed_slit = true;
            }
        }
    }

    /// A piece in the chart.
    struct Side {
        EdgeId edge;
        Vec2 middle;
        double length;
    };
    static Side side_of(const Use& use, std::size_t piece) {
        const Vec2 &a = use.points[piece], &b = use.points[piece + 1];
        return {use.edge, 0.5 * (a + b), distance(a, b)};
    }

    /// Of two edges, and near one another. Where a face runs all round something and closes but for a sliver, the two
    /// are as far apart as it is wide.
    static bool are_of_slit(const std::vector<Side>& sides) {
        constexpr double widest = 0.25;  // of a piece
        return sides.size() == 2 && sides[0].edge != sides[1].edge &&
               distance(sides[0].middle, sides[1].middle) <= widest * std::max(sides[0].length, sides[1].length);
    }

    static Use part_of(const Use& use, std::size_t begin, std::size_t end) {
        const auto slice = [&](const auto& all, std::size_t past) {
            return std::decay_t<decltype(all)>(all.begin() + std::ptrdiff_t(begin), all.begin() + std::ptrdiff_t(past));
        };
        Use part = use;
        part.points = slice(use.points, end + 1), part.nodes = slice(use.nodes, end + 1);
        part.pieces = slice(use.pieces, end);
        part.start = part.nodes.front(), part.end = part.nodes.back();
        return part;
    }

    /// Joins the end of each use to the start of another at the same vertex, the nearest pairs in the chart first.
    void join_uses() {
        struct Pair {
            double distance;
            std::size_t from, to;
        };
        std::map<NodeId, std::vector<std::size_t>> starts;
        for (std::size_t u = 0; u < uses_.size(); ++u)
            if (!uses_[u].is_inner) starts[uses_[u].start].push_back(u);
        std::vector<Pair> pairs;
        for (std::size_t u = 0; u < uses_.size(); ++u)
            if (!uses_[u].is_inner)
                for (const std::size_t next : starts[uses_[u].end])
                    pairs.push_back({distance(uses_[u].points.back(), uses_[next].points.front()), u, next});
        std::stable_sort(pairs.begin(), pairs.end(),
                         [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
        for (const Pair& pair : pairs)
            if (uses_[pair.from].end_point < 0 && uses_[pair.to].start_point < 0)
                uses_[pair.from].end_point = uses_[pair.to].start_point =
                    corner(uses_[pair.to].start, uses_[pair.to].points.front(),
                           shortest_piece(uses_[pair.from], uses_[pair.to]));
        for (Use& use : uses_) {
            if (use.is_inner) {
                const double near = use.is_closed_slit ? std::numeric_limits<double>::infinity()
                                                       : 1e-3 * distance(use.points[0], use.points[1]);
                use.start_point = corner(use.start, use.points.front(), near);
                use.end_point = corner(use.end, use.points.back(), near);
            }
            if (use.start_point < 0 || use.end_point < 0) fail(say<Code::boundary_not_closed>(use.edge));
        }
    }

    static double shortest_piece(const Use& a, const Use& b) {
        return 1e-3 *
               std::min(distance(a.points[a.points.size() - 2], a.points.back()), distance(b.points[0], b.points[1]));
    }

    /// The point of a vertex: the nearest that is there already when it is as near as two wires that touch are.
    int corner(NodeId node, Vec2 p, double near) {
        auto& known = corners_[node];
        const auto off = [&](int c) { return distance(boundary_.points[static_cast<std::size_t>(c)], p); };
        const auto nearest =
            std::min_element(known.begin(), known.end(), [&](int a, int b) { return off(a) < off(b); });
        if (nearest != known.end() && off(*nearest) <= near) return *nearest;
        known.push_back(add_point(p, node));
        return known.back();
    }

    int add_point(Vec2 p, NodeId node) {
        boundary_.points.push_back(p);
        boundary_.nodes.push_back(node);
        return static_cast<int>(boundary_.points.size()) - 1;
    }

    void add_segments(const Use& use) {
        int before = use.start_point;
        for (std::size_t i = 0; i < use.pieces.size(); ++i) {
            const int here = i + 1 == use.pieces.size() ? use.end_point : inner_point(use, i + 1);
            (use.is_inner ? boundary_.inner : boundary_.segments)
                .push_back({before, here, use.edge, use.pieces[i], use.is_pole});
            before = here;
        }
    }

    /// Where a use passes a vertex that another edge of the face has, the two have one point there, as they have one
    /// node: the face between them ends at it. Both sides of a seam are further apart.
    int inner_point(const Use& use, std::size_t i) {
        const NodeId node = use.nodes[i];
        if (use.is_pole || mesh_.entities[node.index()].dim != 0) return add_point(use.points[i], node);
        const Vec2 p = use.points[i];
        return corner(node, p, 0.5 * std::min(distance(use.points[i - 1], p), distance(p, use.points[i + 1])));
    }

    /// Those that no edge of the face with a chain has.
    void add_vertices_inside() {
        const auto inside = brep_.vertices_inside(face_);
        points_.insert(points_.begin(), inside.begin(), inside.end());
        if (points_.empty()) return;
        const Projector projector(brep_);
        for (const VertexId vertex : points_) {
            const NodeId node = chains_.node_of(vertex);
            if (std::find(boundary_.nodes.begin(), boundary_.nodes.end(), node) != boundary_.nodes.end()) continue;
            const auto uv = projector.nearest(face_, brep_.point_of(vertex)).uv;
            boundary_.lone_points.push_back(add_point(chart_.to_plane(chart_.in_trim_period(uv)), node));
        }
    }

    [[noreturn]] void fail(const Message& why) const { throw MeshError(say<Code::face_not_bounded>(face_, why)); }

    const Brep& brep_;
    FaceId face_;
    const Chart& chart_;
    const EdgeChains& chains_;
    const Mesh& mesh_;
    std::vector<Use> uses_;
    std::vector<VertexId> points_;  ///< at which an edge is that has no chain
    std::map<NodeId, std::vector<int>> corners_;
    FaceBoundary boundary_;
};

std::uint64_t side_key(int a, int b) { return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b); }

/// Cuts the kept triangles out of what is to be filled.
class KeptCutter {
  public:
    KeptCutter(const Brep& brep, FaceId face, const Chart& chart, const Mesh& mesh, FaceBoundary boundary)
        : brep_(brep),
          face_(face),
          chart_(chart),
          mesh_(mesh),
          boundary_(std::move(boundary)),
          first_point_(mesh.node_count(), -1),
          next_point_(boundary_.points.size(), -1) {
        for (std::size_t p = boundary_.points.size(); p-- > 0;) {
            int& first = first_point_[boundary_.nodes[p].index()];
            next_point_[p] = std::exchange(first, static_cast<int>(p));
        }
    }

    FaceBoundary cut(std::span<const TriangleId> triangles, std::span<const NodeId> nodes) {
        std::vector<char> is_covered(mesh_.node_count(), 0);
        for (const TriangleId t : triangles)
            for (const NodeId n : mesh_.triangles[t.index()]) is_covered[n.index()] = 1;
        find_border(triangles, is_covered);
        find_poles();
        std::vector<std::array<int, 4>> at_pole;
        for (const TriangleId t : triangles) {
            int count = 0;
            for (const NodeId n : mesh_.triangles[t.index()]) count += border_[n.index()];
            if (count < 2) continue;
            if (const int pole = pole_corner(t); pole >= 0)
                at_pole.push_back(corners_at_pole(t, pole));
            else
                add_sides(corners_in_chart(t));
        }
        for (const std::array<int, 4>& corners : at_pole) add_sides(around_pole(corners));
        replace_segments();
        std::erase_if(boundary_.lone_points, [&](int p) { return is_covered[node_at(p).index()]; });
        for (const NodeId n : nodes)
            if (!is_covered[n.index()] && first_point_[n.index()] < 0)
                boundary_.lone_points.push_back(points_of(n).front());
        return std::move(boundary_);
    }

  private:
    /// Sets border_ of every node. 0: each side at the node belongs to two triangles, or to a triangle and a segment,
    /// so the keys cancel. 2: the boundary meets itself at the node, or the node has several points in the chart; all
    /// its triangles are looked at. 1: all other nodes.
    void find_border(std::span<const TriangleId> triangles, const std::vector<char>& is_covered) {
        std::vector<std::uint64_t> sums(mesh_.node_count(), 0);
        const auto add = [&](NodeId a, NodeId b) {
            const std::uint64_t key = node_pair_key(a, b);
            sums[a.index()] ^= key, sums[b.index()] ^= key;
        };
        for (const TriangleId t : triangles) {
            const auto& [a, b, c] = mesh_.triangles[t.index()];
            add(a, b), add(b, c), add(c, a);
        }
        std::vector<int> segment_count(boundary_.points.size(), 0);
        for (const BoundarySegment& s : boundary_.segments) {
            add(node_at(s.a), node_at(s.b));
            ++segment_count[static_cast<std::size_t>(s.a)], ++segment_count[static_cast<std::size_t>(s.b)];
        }
        border_.resize(sums.size());
        std::transform(sums.begin(), sums.end(), border_.begin(), [](std::uint64_t sum) { return sum != 0; });
        for (std::size_t p = 0; p < boundary_.nodes.size(); ++p) {
            const std::size_t n = boundary_.nodes[p].index();
            const bool is_simple =
                segment_count[p] == 2 && first_point_[n] == static_cast<int>(p) && next_point_[p] < 0;
            if (!is_simple)
                border_[n] = 2;
            else if (!is_covered[n])
                border_[n] = 1;
        }
    }

    NodeId node_at(int p) const { return boundary_.nodes[static_cast<std::size_t>(p)]; }

    /// May only one triangle have this side? It can only be so if both of its ends are at the border.
    bool may_be_open(int a, int b) const { return border_[node_at(a).index()] + border_[node_at(b).index()] >= 2; }

    std::vector<int> points_of(NodeId node) {
        int& first = first_point_[node.index()];
        if (first < 0) {
            if (mesh_.entities[node.index()] != entity_of(face_))
                fail(say<Code::kept_node_off_face>(mesh_.node_numbers[node.index()]));
            boundary_.points.push_back(chart_.to_plane(chart_.in_trim_period(mesh_.parameters[node.index()])));
            boundary_.nodes.push_back(node);
            next_point_.push_back(-1);
            first = static_cast<int>(boundary_.points.size()) - 1;
        }
        std::vector<int> points;
        for (int p = first; p >= 0; p = next_point_[static_cast<std::size_t>(p)]) points.push_back(p);
        return points;
    }

    /// The points of a kept triangle's corners, in the chart's orientation. Where a corner has several (seam, pole),
    /// the choice with the shortest sides among those that are the right way round.
    std::array<int, 3> corners_in_chart(TriangleId t) {
        auto corners = mesh_.triangles[t.index()];
        if (chart_.is_reversed()) std::swap(corners[1], corners[2]);
        const std::vector<int> a = points_of(corners[0]), b = points_of(corners[1]), c = points_of(corners[2]);
        std::array<int, 3> best{-1, -1, -1};
        double shortest = std::numeric_limits<double>::infinity();
        for (const int i : a)
            for (const int j : b)
                for (const int k : c) {
                    const Vec2 p = at(i), q = at(j), r = at(k);
                    const double length = distance(p, q) + distance(q, r) + distance(r, p);
                    if (doubled_area(p, q, r) > 0 && length < shortest) shortest = length, best = {i, j, k};
                }
        if (best[0] < 0) fail(say<Code::kept_triangle_turned>());
        return best;
    }

    Vec2 at(int p) const { return boundary_.points[static_cast<std::size_t>(p)]; }

    void find_poles() {
        for (const BoundarySegment& s : boundary_.segments)
            if (s.is_pole) poles_.push_back(node_at(s.a));
        sort_once(poles_);
    }

    /// Which corner of a kept triangle is a pole; -1 for none.
    int pole_corner(TriangleId t) const {
        const auto& corners = mesh_.triangles[t.index()];
        for (int i = 0; i < 3; ++i)
            if (std::binary_search(poles_.begin(), poles_.end(), corners[static_cast<std::size_t>(i)])) return i;
        return -1;
    }

    /// A triangle at a pole has four corners in the chart: its other two, and the points of the pole that are opposite
    /// them. Its sides run straight to the pole there as on the surface, whatever triangle is beside it.
    std::array<int, 4> corners_at_pole(TriangleId t, int pole) {
        const auto& corners = mesh_.triangles[t.index()];
        const auto node = [&](int i) { return corners[static_cast<std::size_t>((pole + i) % 3)]; };
        const std::vector<int> from = points_of(node(chart_.is_reversed() ? 2 : 1)),
                               to = points_of(node(chart_.is_reversed() ? 1 : 2));
        std::array<int, 2> best{-1, -1};
        double shortest = std::numeric_limits<double>::infinity();
        for (const int q : from)
            for (const int r : to) {
                const Vec2 foot = nearest_on_pole(node(0), 0.5 * (at(q) + at(r))).point;
                if (doubled_area(at(q), at(r), foot) > 0 && distance(at(q), at(r)) < shortest)
                    shortest = distance(at(q), at(r)), best = {q, r};
            }
        if (best[0] < 0) fail(say<Code::kept_triangle_turned>());
        return {best[0], best[1], pole_point(node(0), at(best[1])), pole_point(node(0), at(best[0]))};
    }

    struct OnPole {
        std::size_t segment = 0;
        double share = 0;
        Vec2 point;
    };
    OnPole nearest_on_pole(NodeId pole, Vec2 p) const {
        OnPole nearest;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < boundary_.segments.size(); ++i) {
            const BoundarySegment& s = boundary_.segments[i];
            if (!s.is_pole || node_at(s.a) != pole) continue;
            const Vec2 along = at(s.b) - at(s.a);
            const double share = std::clamp(dot(p - at(s.a), along) / dot(along, along), 0.0, 1.0);
            const Vec2 point = at(s.a) + share * along;
            if (distance(point, p) < least) least = distance(point, p), nearest = {i, share, point};
        }
        return nearest;
    }

    /// The pole's point opposite another one; a new one where there is none yet.
    int pole_point(NodeId pole, Vec2 p) {
        constexpr double same = 1e-6;
        const OnPole foot = nearest_on_pole(pole, p);
        BoundarySegment& segment = boundary_.segments[foot.segment];
        if (foot.share < same) return segment.a;
        if (foot.share > 1 - same) return segment.b;
        boundary_.points.push_back(foot.point);
        boundary_.nodes.push_back(pole);
        const int added = static_cast<int>(boundary_.points.size()) - 1;
        next_point_.push_back(std::exchange(first_point_[pole.index()], added));
        BoundarySegment rest = segment;
        rest.a = segment.b = added;
        boundary_.segments.push_back(rest);
        return added;
    }

    /// With the points between the last two, which are the pole's.
    std::vector<int> around_pole(const std::array<int, 4>& corners) const {
        const auto& [q, r, first, last] = corners;
        std::vector<int> around{q, r, first};
        while (around.back() != last) {
            const auto next = std::find_if(boundary_.segments.begin(), boundary_.segments.end(),
                                           [&](const BoundarySegment& s) { return s.is_pole && s.a == around.back(); });
            if (next == boundary_.segments.end() || around.size() > boundary_.points.size())
                fail(say<Code::kept_triangle_turned>());
            around.push_back(next->b);
        }
        return around;
    }

    void add_sides(std::span<const int> corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const int a = corners[i], b = corners[(i + 1) % corners.size()];
            if (!may_be_open(a, b)) continue;
            if (const auto back = sides_.find(side_key(b, a)); back != sides_.end()) {
                sides_.erase(back);
            } else if (!sides_.emplace(side_key(a, b), order_++).second) {
                fail(say<Code::kept_triangles_overlap>());
            }
        }
    }

    /// Segments that a kept triangle covers go; the other sides of kept triangles become segments the other way round.
    void replace_segments() {
        std::vector<BoundarySegment> open;
        for (const BoundarySegment& s : boundary_.segments)
            if (may_be_open(s.a, s.b) && sides_.erase(side_key(s.a, s.b)) == 0) open.push_back(s);
        std::vector<std::pair<int, std::uint64_t>> rest;
        for (const auto& [key, order] : sides_) rest.emplace_back(order, key);
        std::sort(rest.begin(), rest.end());
        std::erase_if(boundary_.inner, [&](const BoundarySegment& s) {  // kept on one side
            return sides_.contains(side_key(s.a, s.b)) || sides_.contains(side_key(s.b, s.a));
        });
        for (const auto& [order, key] : rest)
            open.push_back({static_cast<int>(key & 0xffffffffu), static_cast<int>(key >> 32), EdgeId(), 0, false});
        boundary_.segments = std::move(open);
    }

    [[noreturn]] void fail(const Message& why) const { throw MeshError(say<Code::face_not_filled>(face_, why)); }

    const Brep& brep_;
    FaceId face_;
    const Chart& chart_;
    const Mesh& mesh_;
    FaceBoundary boundary_;
    std::vector<int> first_point_, next_point_;  ///< by node, by point: all points of a node; -1 ends the list
    std::vector<char> border_;                   ///< by node
    std::vector<NodeId> poles_;                  ///< sorted
    std::unordered_map<std::uint64_t, int> sides_;
    int order_ = 0;
};

}  // namespace

FaceBoundary find_boundary(const Brep& brep, FaceId face, const Chart& chart, const EdgeChains& chains,
                           const Mesh& mesh, std::span<const TriangleId> kept_triangles,
                           std::span<const NodeId> kept_nodes) {
    FaceBoundary boundary = BoundaryBuilder(brep, face, chart, chains, mesh).from_loops();
    if (kept_triangles.empty() && kept_nodes.empty()) return boundary;
    return KeptCutter(brep, face, chart, mesh, std::move(boundary)).cut(kept_triangles, kept_nodes);
}

}  // namespace featuremesh
