// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/keep.h"

#include <TopoDS_Face.hxx>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "features/occt_geometry.h"
#include "surface/projection.h"
#include "update/enclosure.h"
#include "update/entity_finder.h"
#include "update/shape_coverage.h"

namespace featuremesh {

namespace {

constexpr double size_change_that_releases = 1.2;
constexpr double clearance_between_motions = 1.5;   // edge lengths
constexpr double active_margin = 0.6;               // edge lengths
constexpr std::int32_t dropped = -1;

/// Where an old node would be in the new state.
struct Place {
    std::int32_t motion = dropped;
    Entity entity;
    std::array<double, 2> parameter{};
};

class Keeper {
  public:
    Keeper(const KeepInput& input, RunContext& context)
        : in_(input), context_(context), projector_(input.new_brep), places_(input.old_mesh.points.size()),
          is_untouched_(input.old_brep.face_count(), 0), face_boxes_(input.new_brep.face_count()) {
        for (const FaceChange& change : input.difference.faces)
            if (change.verdict == FaceVerdict::kept) is_untouched_[change.old_face.index()] = 1;
    }

    Kept run() {
        choose_motions();
        drop_near_changes();
        place_on_entities();
        clear_between_motions();
        choose_tets();
        return assemble();
    }

  private:
    const std::vector<CarriedRegion>& regions() const { return in_.difference.regions; }
    Vec3 carried(std::size_t node) const {
        return regions()[std::size_t(places_[node].motion)].motion.apply(in_.old_mesh.points[node]);
    }
    std::size_t node_count() const { return places_.size(); }

    // The nodes of tets inside a feature that moved prefer its motion, all others stay where they are. Nodes on the feature's own faces may be outside of
    // its triangulation; the middles of their tets are not.
    void choose_motions() {
        for (Place& place : places_) place.motion = 0;
        const Mesh& old = in_.old_mesh;
        for (std::size_t r = 1; r < regions().size(); ++r) {
            const Enclosure inside(regions()[r].volumes);
            for (std::size_t t = 0; t < old.tets.size(); ++t) {
                const auto& [a, b, c, d] = old.tets[t];
                if (!inside.contains((old.point(a) + old.point(b) + old.point(c) + old.point(d)) / 4)) continue;
                for (const NodeId n : old.tets[t]) places_[n.index()].motion = std::int32_t(r);
                if (old.order == 2)
                    for (const NodeId n : old.tet_mids[t]) places_[n.index()].motion = std::int32_t(r);
            }
        }
    }

    bool size_changed(const Vec3& old_place, double wanted) const {
        const double was = in_.old_sizing.at(old_place);
        return std::max(was / wanted, wanted / was) > size_change_that_releases;
    }

    // Away from everything that changed neither sizes nor distances need to be asked for.
    void drop_near_changes() {
        std::vector<Box> reach;
        const double widest = in_.margin * in_.new_sizing.largest();
        for (const CarriedRegion& region : regions())
            reach.push_back(region.changed.box().is_empty() ? Box{} : region.changed.box().grown(widest));
        const std::vector<Box> resized = where_different(in_.old_sizing, in_.new_sizing);
        parallel_for(context_, node_count(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                const auto r = std::size_t(places_[n].motion);
                const Vec3 p = carried(n);
                const auto holds_p = [&](const Box& box) { return box.contains(p); };
                const bool may_be_resized = r > 0 || std::any_of(resized.begin(), resized.end(), holds_p);
                const bool may_be_near = !reach[r].is_empty() && reach[r].contains(p);
                if (!may_be_resized && !may_be_near) continue;
                const double wanted = in_.new_sizing.at(p), limit = in_.margin * wanted;
                if ((may_be_resized && size_changed(in_.old_mesh.points[n], wanted)) || (may_be_near && regions()[r].changed.distance(p, limit) < limit))
                    places_[n].motion = dropped;
            }
        });
    }

    void place_on_entities() {
        for (std::size_t n = 0; n < node_count(); ++n)
            if (places_[n].motion != dropped && !place_node(n)) places_[n].motion = dropped;
    }

    // The verdict "unchanged" is not believed: every boundary node is measured against the new shape.
    bool place_node(std::size_t n) {
        const CarriedRegion& region = regions()[std::size_t(places_[n].motion)];
        const Entity old_entity = in_.old_mesh.entities[n];
        const std::size_t i = std::size_t(old_entity.index);
        Place& place = places_[n];
        place.parameter = in_.old_mesh.parameters[n];
        switch (old_entity.dim) {
            case 0:
                return i < region.new_vertex_of.size() && place_on_vertex(place, region.new_vertex_of[i], carried(n));
            case 1:
                return i < region.new_edges_of.size() && place_on_edges(place, region.new_edges_of[i], carried(n));
            case 2:
                return i < region.new_faces_of.size() && place_on_faces(place, i, carried(n));
            default:
                return true;   // its solid follows from its tets
        }
    }

    bool place_on_vertex(Place& place, VertexId vertex, const Vec3& p) const {
        if (!vertex.is_valid()) return false;
        place.entity = entity_of(vertex);
        return distance(in_.new_brep.point_of(vertex), p) <= tolerance();
    }

    // An edge may have been split, or be one with others: the piece that the node lies within has it.
    bool place_on_edges(Place& place, const std::vector<EdgeId>& pieces, const Vec3& p) const {
        return std::any_of(pieces.begin(), pieces.end(), [&](EdgeId edge) { return place_on_edge(place, edge, p); });
    }

    bool place_on_edge(Place& place, EdgeId edge, const Vec3& p) const {
        place.entity = entity_of(edge);
        const auto [first, last] = range_of(in_.new_brep, edge);
        const auto is_within = [&](double t) { return t > first && t < last; };
        if (is_within(place.parameter[0]) && distance(projector_.on_edge(edge, place.parameter[0]), p) <= tolerance()) return true;
        const OnEdge foot = projector_.nearest(edge, p);
        if (!is_within(foot.t) || foot.distance > tolerance()) return false;
        place.parameter[0] = foot.t;
        return true;
    }

    // Where a face's boundary is the old one a point that was inside still is: everywhere, or far from all that changed.
    bool is_untouched(const Place& place, std::size_t old_face, const Vec3& p) const {
        if (place.motion == 0 && is_untouched_[old_face]) return true;
        const Box changed = regions()[std::size_t(place.motion)].changed.box();
        if (changed.is_empty()) return false;
        return !changed.grown(2 * in_.margin * in_.new_sizing.largest()).contains(p) || !changed.grown(2 * in_.margin * in_.new_sizing.at(p)).contains(p);
    }

    bool place_on_faces(Place& place, std::size_t old_face, const Vec3& p) {
        const auto& pieces = regions()[std::size_t(place.motion)].new_faces_of[old_face];
        if (pieces.size() == 1) return place_on_face(place, pieces[0], p, is_untouched(place, old_face, p));
        return std::any_of(pieces.begin(), pieces.end(), [&](FaceId face) { return may_hold(face, p) && place_on_face(place, face, p, false); });
    }

    bool may_hold(FaceId face, const Vec3& p) {
        Box& box = face_boxes_[face.index()];
        if (box.is_empty()) box = box_of(in_.new_brep.face(face)).grown(tolerance());
        return box.contains(p);
    }

    bool place_on_face(Place& place, FaceId face, const Vec3& p, bool is_untouched) const {
        place.entity = entity_of(face);
        std::array<double, 2> uv = place.parameter;
        if (distance(projector_.on_face(face, uv), p) > tolerance()) {
            const OnFace foot = projector_.nearest(face, p);
            uv = foot.uv;
            if (foot.distance > tolerance()) return false;
        }
        if (!is_untouched && !projector_.is_inside_trim(face, uv)) return false;
        place.parameter = uv;
        return true;
    }

    double tolerance() const { return 5 * in_.new_brep.tolerances().on_entity(); }

    // Identity first: a carried node that comes near one that stayed is dropped.
    void clear_between_motions() {
        for (std::size_t r = 1; r < regions().size(); ++r) {
            Box box;
            double spacing = 0;
            for (std::size_t n = 0; n < node_count(); ++n)
                if (places_[n].motion == std::int32_t(r)) {
                    box.add(carried(n));
                    spacing = std::max(spacing, clearance_between_motions * in_.new_sizing.at(carried(n)));
                }
            if (box.is_empty()) continue;
            std::vector<Vec3> settled;
            for (std::size_t n = 0; n < node_count(); ++n)
                if (places_[n].motion >= 0 && places_[n].motion < std::int32_t(r) && box.grown(spacing).contains(carried(n)))
                    settled.push_back(carried(n));
            const PointGrid grid(std::move(settled), spacing);
            for (std::size_t n = 0; n < node_count(); ++n)
                if (places_[n].motion == std::int32_t(r) &&
                    grid.has_within(carried(n), clearance_between_motions * in_.new_sizing.at(carried(n))))
                    places_[n].motion = dropped;
        }
    }

    std::int32_t motion_of(std::size_t t) const {
        const Mesh& old = in_.old_mesh;
        const std::int32_t motion = places_[old.tets[t][0].index()].motion;
        const auto differs = [&](NodeId n) { return places_[n.index()].motion != motion; };
        if (std::any_of(old.tets[t].begin(), old.tets[t].end(), differs)) return dropped;
        if (old.order == 2 && std::any_of(old.tet_mids[t].begin(), old.tet_mids[t].end(), differs)) return dropped;
        return motion;
    }

    void choose_tets() {
        const auto& tets = in_.old_mesh.tets;
        tet_motion_.resize(tets.size());
        for (std::size_t t = 0; t < tets.size(); ++t) tet_motion_[t] = motion_of(t);
        settle_solids();
    }

    // Kept tets that share a node form a region; one point of each region says in which new solid it is, if any.
    void settle_solids() {
        const auto& tets = in_.old_mesh.tets;
        std::vector<std::int32_t> parent(node_count());
        std::iota(parent.begin(), parent.end(), 0);
        const auto root = [&](std::int32_t n) {
            while (parent[std::size_t(n)] != n) n = parent[std::size_t(n)] = parent[std::size_t(parent[std::size_t(n)])];
            return n;
        };
        tet_solid_.resize(tets.size());
        const SolidLocator locator(in_.new_brep);
        // Two old solids may meet at shared nodes: each keeps its own regions.
        for (std::size_t s = 0; s < in_.old_brep.solid_count(); ++s) {
            std::iota(parent.begin(), parent.end(), 0);
            for (std::size_t t = 0; t < tets.size(); ++t)
                if (tet_motion_[t] != dropped && in_.old_mesh.tet_solids[t] == SolidId(s))
                    for (int k = 1; k < 4; ++k) {
                        if (parent[tets[t][0].index()] == parent[tets[t][std::size_t(k)].index()]) continue;
                        const auto a = root(tets[t][0].value), b = root(tets[t][std::size_t(k)].value);
                        parent[std::size_t(std::max(a, b))] = std::min(a, b);
                    }
            std::vector<std::int32_t> solid_of_root(node_count(), -2);
            for (std::size_t t = 0; t < tets.size(); ++t) {
                if (tet_motion_[t] == dropped || in_.old_mesh.tet_solids[t] != SolidId(s)) continue;
                std::int32_t& solid = solid_of_root[std::size_t(root(tets[t][0].value))];
                if (solid == -2) solid = locator.solid_at(carried_centre(t)).value;
                if (solid < 0) tet_motion_[t] = dropped;
                tet_solid_[t] = SolidId(solid);
            }
        }
    }

    Vec3 carried_centre(std::size_t t) const {
        Vec3 sum;
        for (const NodeId n : in_.old_mesh.tets[t]) sum += carried(n.index());
        return sum / 4;
    }

    Kept assemble() {
        Kept kept;
        const std::vector<std::int32_t> new_index = number_nodes(kept);
        take_tets(kept, new_index);
        mark_rim(kept, new_index);
        take_triangles(kept, new_index);
        mark_changed_sides(kept);
        take_segments(kept, new_index);
        kept.mesh.next_node_number = in_.old_mesh.next_node_number;
        kept.mesh.next_element_number = in_.old_mesh.next_element_number;
        if (in_.old_mesh.order == 2) kept.curved = with_mid_side_nodes(kept);
        collect_active(kept, new_index);
        count_by_motion(kept);
        return kept;
    }

    // Nearly everything is kept, as a rule, and some is added.
    void reserve(Kept& kept) const {
        Mesh& mesh = kept.mesh;
        const auto most = [](std::size_t count) { return count + count / 16 + 1024; };
        const std::size_t nodes = most(in_.old_mesh.corner_count), triangles = most(in_.old_mesh.triangles.size()),
                          tets = most(in_.old_mesh.tets.size());
        mesh.points.reserve(nodes), mesh.entities.reserve(nodes), mesh.parameters.reserve(nodes), mesh.node_numbers.reserve(nodes);
        mesh.triangles.reserve(triangles), mesh.triangle_faces.reserve(triangles), mesh.triangle_numbers.reserve(triangles);
        mesh.tets.reserve(tets), mesh.tet_solids.reserve(tets), mesh.tet_numbers.reserve(tets);
        kept.node_origin.reserve(nodes), kept.triangle_origin.reserve(triangles), kept.tet_origin.reserve(tets), kept.tet_motion.reserve(tets);
    }

    std::vector<std::int32_t> number_nodes(Kept& kept) const {
        std::vector<std::int32_t> new_index(node_count(), -1);
        for (std::size_t t = 0; t < tet_motion_.size(); ++t)
            if (tet_motion_[t] != dropped)
                for (const NodeId n : in_.old_mesh.tets[t]) new_index[n.index()] = 0;
        Mesh& mesh = kept.mesh;
        reserve(kept);
        for (std::size_t n = 0; n < in_.old_mesh.corner_count; ++n) {
            if (new_index[n] < 0) continue;
            new_index[n] = std::int32_t(mesh.points.size());
            kept.node_origin.push_back(std::int32_t(n));
            mesh.points.push_back(carried(n));
            mesh.entities.push_back(places_[n].entity);
            mesh.parameters.push_back(places_[n].parameter);
            mesh.node_numbers.push_back(in_.old_mesh.node_numbers[n]);
        }
        mesh.corner_count = mesh.points.size();
        return new_index;
    }

    void take_tets(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        for (std::size_t t = 0; t < old.tets.size(); ++t) {
            if (tet_motion_[t] == dropped) continue;
            std::array<NodeId, 4> tet;
            for (int k = 0; k < 4; ++k) {
                tet[k] = NodeId(new_index[old.tets[t][k].index()]);
                Entity& entity = kept.mesh.entities[tet[k].index()];
                if (entity.dim == 3) entity = entity_of(tet_solid_[t]);
            }
            kept.mesh.tets.push_back(tet);
            kept.mesh.tet_solids.push_back(tet_solid_[t]);
            kept.mesh.tet_numbers.push_back(old.tet_numbers[t]);
            kept.tet_origin.push_back(std::int32_t(t));
            kept.tet_motion.push_back(tet_motion_[t]);
        }
    }

    void mark_rim(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        kept.is_rim.assign(kept.mesh.points.size(), 0);
        for (std::size_t t = 0; t < tet_motion_.size(); ++t)
            if (tet_motion_[t] == dropped)
                for (const NodeId n : in_.old_mesh.tets[t])
                    if (new_index[n.index()] >= 0) kept.is_rim[std::size_t(new_index[n.index()])] = 1;
    }

    // A face may have a solid on a side where it had none.
    void mark_changed_sides(Kept& kept) const {
        for (std::size_t t = 0; t < kept.triangle_origin.size(); ++t) {
            const auto was = in_.old_brep.sides_of(in_.old_mesh.triangle_faces[std::size_t(kept.triangle_origin[t])]);
            const auto is = in_.new_brep.sides_of(kept.mesh.triangle_faces[t]);
            if (was[0].is_valid() + was[1].is_valid() == is[0].is_valid() + is[1].is_valid()) continue;
            for (const NodeId n : kept.mesh.triangles[t]) kept.is_rim[n.index()] = 1;
        }
    }

    template <std::size_t N>
    bool survives(const std::array<NodeId, N>& nodes, const std::vector<std::int32_t>& new_index) const {
        for (const NodeId n : nodes)
            if (new_index[n.index()] < 0 || places_[n.index()].motion != places_[nodes[0].index()].motion) return false;
        return true;
    }

    void take_triangles(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        const std::vector<char> backed = backed_by_kept_tets(kept, new_index);
        std::map<std::tuple<std::size_t, FaceId, FaceId>, bool> flipped;
        for (std::size_t t = 0; t < old.triangles.size(); ++t) {
            const auto& nodes = old.triangles[t];
            if (!backed[t] || !survives(nodes, new_index)) continue;
            const std::size_t r = std::size_t(places_[nodes[0].index()].motion);
            const FaceId old_face = old.triangle_faces[t], face = face_of(r, t);
            if (!face.is_valid()) {
                for (const NodeId n : nodes) kept.is_rim[std::size_t(new_index[n.index()])] = 1;
                continue;
            }
            const auto [flip, is_new] = flipped.try_emplace({r, old_face, face}, false);
            if (is_new) flip->second = is_flipped(t, face);
            std::array<NodeId, 3> triangle;
            for (int k = 0; k < 3; ++k) triangle[k] = NodeId(new_index[nodes[k].index()]);
            if (flip->second) std::swap(triangle[1], triangle[2]);
            kept.mesh.triangles.push_back(triangle);
            kept.mesh.triangle_faces.push_back(face);
            kept.mesh.triangle_numbers.push_back(old.triangle_numbers[t]);
            kept.triangle_origin.push_back(std::int32_t(t));
        }
    }

    // The piece of its face that an old triangle is on.
    FaceId face_of(std::size_t r, std::size_t triangle) const {
        const auto& pieces = regions()[r].new_faces_of[in_.old_mesh.triangle_faces[triangle].index()];
        if (pieces.size() < 2) return pieces.empty() ? FaceId() : pieces[0];
        const auto& nodes = in_.old_mesh.triangles[triangle];
        for (const NodeId n : nodes)
            if (places_[n.index()].entity.dim == 2) return FaceId(places_[n.index()].entity.index);
        const Vec3 middle = (carried(nodes[0].index()) + carried(nodes[1].index()) + carried(nodes[2].index())) / 3.0;
        for (const FaceId face : pieces) {
            const auto is_at = [&](NodeId n) {
                const std::vector<FaceId> faces = faces_at(in_.new_brep, places_[n.index()].entity);
                return std::binary_search(faces.begin(), faces.end(), face);
            };
            if (std::all_of(nodes.begin(), nodes.end(), is_at) && projector_.is_inside_trim(face, projector_.nearest(face, middle).uv)) return face;
        }
        return FaceId();
    }

    // A triangle stays with the tet behind it: the cavity's boundary is then where kept tets end. Around a node off the rim all tets are kept, so only
    // triangles between rim nodes need a look.
    std::vector<char> backed_by_kept_tets(const Kept& kept, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        const auto is_rim = [&](NodeId n) { return new_index[n.index()] >= 0 && kept.is_rim[std::size_t(new_index[n.index()])]; };
        std::vector<char> backed(old.triangles.size(), 1);
        std::vector<std::pair<std::array<NodeId, 3>, std::size_t>> doubtful;
        for (std::size_t t = 0; t < old.triangles.size(); ++t) {
            auto corners = old.triangles[t];
            if (!is_rim(corners[0]) || !is_rim(corners[1]) || !is_rim(corners[2])) continue;
            std::sort(corners.begin(), corners.end());
            doubtful.emplace_back(corners, t);
            backed[t] = 0;
        }
        std::sort(doubtful.begin(), doubtful.end());
        for (const std::int32_t tet : kept.tet_origin) {
            const auto& nodes = old.tets[std::size_t(tet)];
            if (is_rim(nodes[0]) + is_rim(nodes[1]) + is_rim(nodes[2]) + is_rim(nodes[3]) < 3) continue;
            for (int skip = 0; skip < 4; ++skip) {
                std::array<NodeId, 3> side;
                for (int k = 0, j = 0; k < 4; ++k)
                    if (k != skip) side[std::size_t(j++)] = nodes[std::size_t(k)];
                std::sort(side.begin(), side.end());
                const auto it = std::lower_bound(doubtful.begin(), doubtful.end(), side, [](const auto& d, const auto& s) { return d.first < s; });
                if (it != doubtful.end() && it->first == side) backed[it->second] = 1;
            }
        }
        return backed;
    }

    bool is_flipped(std::size_t triangle, FaceId face) const {
        const auto& nodes = in_.old_mesh.triangles[triangle];
        const Vec3 a = carried(nodes[0].index()), b = carried(nodes[1].index()), c = carried(nodes[2].index());
        const OnFace foot = projector_.nearest(face, (a + b + c) / 3.0);
        return dot(projector_.normal(face, foot.uv), cross(b - a, c - a)) < 0;
    }

    void take_segments(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        for (std::size_t s = 0; s < old.segments.size(); ++s) {
            const auto& nodes = old.segments[s];
            if (!survives(nodes, new_index)) continue;
            const EdgeId edge = edge_of(s);
            if (!edge.is_valid()) continue;
            std::array<NodeId, 2> segment{NodeId(new_index[nodes[0].index()]), NodeId(new_index[nodes[1].index()])};
            if (runs_backwards(kept.mesh, segment, edge)) std::swap(segment[0], segment[1]);
            kept.mesh.segments.push_back(segment);
            kept.mesh.segment_edges.push_back(edge);
            kept.mesh.segment_numbers.push_back(old.segment_numbers[s]);
            kept.segment_origin.push_back(std::int32_t(s));
        }
    }

    // The piece of its edge that an old segment is on: both its nodes are, and of several (two arcs between two vertices) it is the nearest.
    EdgeId edge_of(std::size_t segment) const {
        const auto& nodes = in_.old_mesh.segments[segment];
        const Vec3 middle = (carried(nodes[0].index()) + carried(nodes[1].index())) / 2.0;
        EdgeId best;
        double least = std::numeric_limits<double>::infinity();
        const std::size_t r = std::size_t(places_[nodes[0].index()].motion);
        for (const EdgeId edge : regions()[r].new_edges_of[in_.old_mesh.segment_edges[segment].index()]) {
            const auto is_at = [&](NodeId n) {
                const Entity entity = places_[n.index()].entity;
                const auto ends = in_.new_brep.ends_of(edge);
                return entity == entity_of(edge) || entity == entity_of(ends[0]) || entity == entity_of(ends[1]);
            };
            if (!is_at(nodes[0]) || !is_at(nodes[1])) continue;
            const double d = projector_.nearest(edge, middle).distance;
            if (d < least) least = d, best = edge;
        }
        return best;
    }

    // The new edge may be parametrised the other way round.
    bool runs_backwards(const Mesh& mesh, const std::array<NodeId, 2>& segment, EdgeId edge) const {
        const Vec3 a = mesh.point(segment[0]), b = mesh.point(segment[1]);
        const double t = projector_.nearest(edge, (a + b) * 0.5).t;
        const double step = 1e-4 * (std::abs(t) + 1);
        return dot(projector_.on_edge(edge, t + step) - projector_.on_edge(edge, t - step), b - a) < 0;
    }

    Mesh with_mid_side_nodes(const Kept& kept) const {
        const Mesh& old = in_.old_mesh;
        Mesh curved = kept.mesh;
        curved.order = 2;
        std::vector<NodeId> new_mid(old.points.size());
        const auto take = [&](NodeId old_mid) {
            NodeId& mid = new_mid[old_mid.index()];
            if (mid.is_valid()) return mid;
            const std::size_t n = old_mid.index();
            mid = NodeId(curved.points.size());
            curved.points.push_back(carried(n));
            curved.entities.push_back(places_[n].entity);
            curved.parameters.push_back(places_[n].parameter);
            curved.node_numbers.push_back(old.node_numbers[n]);
            return mid;
        };
        for (std::size_t t = 0; t < kept.tet_origin.size(); ++t) {
            std::array<NodeId, 6> mids;
            for (int s = 0; s < 6; ++s) {
                mids[s] = take(old.tet_mids[std::size_t(kept.tet_origin[t])][s]);
                Entity& entity = curved.entities[mids[s].index()];
                if (entity.dim == 3) entity = entity_of(kept.mesh.tet_solids[t]);
            }
            curved.tet_mids.push_back(mids);
        }
        // A triangle or segment may have been turned round: its sides are found again by their corners.
        for (std::size_t t = 0; t < kept.triangle_origin.size(); ++t) {
            auto mids = old.triangle_mids[std::size_t(kept.triangle_origin[t])];
            const auto& corners = old.triangles[std::size_t(kept.triangle_origin[t])];
            const bool turned = kept.node_origin[curved.triangles[t][1].index()] != corners[1].value;
            if (turned) std::swap(mids[0], mids[2]);
            curved.triangle_mids.push_back({take(mids[0]), take(mids[1]), take(mids[2])});
        }
        for (const std::int32_t s : kept.segment_origin) curved.segment_mids.push_back(take(old.segment_mids[std::size_t(s)]));
        return curved;
    }

    void collect_active(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        for (std::size_t n = 0; n < in_.old_mesh.corner_count; ++n) {
            if (new_index[n] >= 0 || in_.old_mesh.entities[n].dim != 3) continue;
            const Vec3& p = in_.old_mesh.points[n];
            const double wanted = in_.new_sizing.at(p);
            if (!size_changed(p, wanted) && regions()[0].changed.distance(p, active_margin * wanted) >= active_margin * wanted)
                kept.active.push_back(p);
        }
    }

    void count_by_motion(Kept& kept) const {
        for (const CarriedRegion& region : regions()) kept.by_motion.push_back({region.motion, region.features});
        for (const std::int32_t n : kept.node_origin) ++kept.by_motion[std::size_t(places_[std::size_t(n)].motion)].nodes;
        for (const std::int32_t motion : kept.tet_motion) ++kept.by_motion[std::size_t(motion)].tets;
    }

    const KeepInput& in_;
    RunContext& context_;
    Projector projector_;
    std::vector<Place> places_;
    std::vector<std::int32_t> tet_motion_;
    std::vector<SolidId> tet_solid_;
    std::vector<char> is_untouched_;   // by old face: kept in place with all its edges
    std::vector<Box> face_boxes_;      // by new face, empty until asked for
};

}  // namespace

Kept keep(const KeepInput& input, RunContext& context) {
    RunContext::Step step(context, "keep");
    return Keeper(input, context).run();
}

}  // namespace featuremesh
