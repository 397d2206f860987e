// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/keep.h"

#include <TopoDS_Face.hxx>
#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "features/occt_geometry.h"
#include "surface/projection.h"
#include "update/enclosure.h"
#include "update/entity_finder.h"
#include "update/kept_tets.h"
#include "update/shape_coverage.h"
#include "update/solid_sides.h"

namespace featuremesh {

namespace {

constexpr double size_change_that_releases = 1.2;
constexpr double clearance_between_motions = 1.5;   // edge lengths
constexpr double active_margin = 0.6;               // edge lengths

/// Where an old node would be in the new state.
struct Place {
    std::int32_t motion = dropped;
    Entity entity;
    std::array<double, 2> parameter{};
};

class Keeper {
  public:
    Keeper(const KeepInput& input, RunContext& context)
        : in_(input), context_(context), projector_(input.new_brep), merged_(std::make_shared<const MergedEntities>(input.new_brep)), motions_(input.old_mesh.points.size(), 0),
          entities_(input.old_mesh.entities), parameters_(input.old_mesh.parameters),
          is_untouched_(input.old_brep.face_count(), 0), face_boxes_(input.new_brep.face_count()), edge_ranges_(input.new_brep.edge_count()) {
        for (const FaceChange& change : input.difference.faces)
            if (change.verdict == BoundaryVerdict::kept) is_untouched_[change.old_face.index()] = 1;
    }

    Kept run() {
        choose_motions();
        context_.check_cancelled();
        find_untouched_solids();
        drop_near_changes();
        place_on_entities();
        clear_between_motions();
        context_.check_cancelled();
        const KeptTets tets(in_.old_mesh, motions_, regions(), in_.old_brep, in_.new_brep, near_change_, untouched_solids_);
        return assemble(tets);
    }

  private:
    const std::vector<CarriedRegion>& regions() const { return in_.difference.regions; }
    Vec3 carried(std::size_t node) const {
        return regions()[std::size_t(motions_[node])].motion.apply(in_.old_mesh.points[node]);
    }
    std::size_t node_count() const { return motions_.size(); }

    // The nodes of tets inside a feature that moved prefer its motion, all others stay where they are. Nodes on the feature's own faces may be outside of
    // its triangulation; the middles of their tets are not.
    void choose_motions() {
        const Mesh& old = in_.old_mesh;
        for (std::size_t r = 1; r < regions().size(); ++r) {
            if (regions()[r].volumes.empty()) continue;
            const Enclosure inside(regions()[r].volumes);
            RoundWatch watch(context_);
            for (std::size_t t = 0; t < old.tets.size(); ++t) {
                watch();
                const auto& [a, b, c, d] = old.tets[t];
                if (!inside.contains((old.point(a) + old.point(b) + old.point(c) + old.point(d)) / 4)) continue;
                for (const NodeId n : old.tets[t]) motions_[n.index()] = std::int32_t(r);
                if (old.order == 2)
                    for (const NodeId n : old.tet_mids[t]) motions_[n.index()] = std::int32_t(r);
            }
        }
    }

    // Of several solids those with the same faces as before and no others: what changes beside them is none of their business.
    void find_untouched_solids() {
        if (in_.old_brep.solid_count() < 2) return;
        const std::vector<std::vector<FaceId>> old_faces = faces_of_solids(in_.old_brep), new_faces = faces_of_solids(in_.new_brep);
        std::vector<FaceId> kept_as(in_.old_brep.face_count());
        for (const FaceChange& change : in_.difference.faces)
            if (change.verdict == BoundaryVerdict::kept) kept_as[change.old_face.index()] = change.new_face;
        untouched_solids_.assign(old_faces.size(), 0);
        for (std::size_t s = 0; s < old_faces.size(); ++s) {
            std::vector<FaceId> now;
            for (const FaceId f : old_faces[s]) now.push_back(kept_as[f.index()]);
            std::sort(now.begin(), now.end());
            untouched_solids_[s] = std::find(new_faces.begin(), new_faces.end(), now) != new_faces.end();
        }
        if (std::count(untouched_solids_.begin(), untouched_solids_.end(), 1) == 0) return;
        near_change_.assign(node_count(), 0);
        in_untouched_.assign(node_count(), 0);
        const Mesh& old = in_.old_mesh;
        for (std::size_t t = 0; t < old.tets.size(); ++t) {
            if (!untouched_solids_[old.tet_solids[t].index()]) continue;
            for (const NodeId n : old.tets[t]) in_untouched_[n.index()] = 1;
            if (old.order == 2)
                for (const NodeId n : old.tet_mids[t]) in_untouched_[n.index()] = 1;
        }
    }

    bool size_changed(std::size_t n, double wanted) const {
        const SizedMesh old{in_.old_mesh, in_.old_sizing, in_.made_for};
        const double was = old.made_for_at(NodeId(n));
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
                const auto r = std::size_t(motions_[n]);
                const Vec3 p = carried(n);
                const auto holds_p = [&](const Box& box) { return box.contains(p); };
                const bool may_be_resized = r > 0 || std::any_of(resized.begin(), resized.end(), holds_p);
                const bool may_be_near = !reach[r].is_empty() && reach[r].contains(p);
                if (!may_be_resized && !may_be_near) continue;
                const double wanted = in_.new_sizing.at(p), limit = in_.margin * wanted;
                const bool is_resized = may_be_resized && size_changed(n, wanted);
                if (!is_resized && !(may_be_near && regions()[r].changed.distance(p, limit) < limit)) continue;
                if (r == 0 && !in_untouched_.empty() && in_untouched_[n] && (in_.same_sizes_asked || !is_resized))
                    near_change_[n] = 1;
                else
                    motions_[n] = dropped;
            }
        });
    }

    void place_on_entities() {
        for (std::size_t n = 0; n < node_count(); ++n) {
            if (n % 4096 == 0) context_.check_cancelled();
            if (motions_[n] != dropped && !place_node(n)) motions_[n] = dropped;
        }
    }

    // The verdict "unchanged" is not believed: every boundary node is measured against the new shape.
    bool place_node(std::size_t n) {
        const Entity old_entity = in_.old_mesh.entities[n];
        if (old_entity.dim == 3) return true;   // its solid follows from its tets
        Place place{motions_[n], old_entity, parameters_[n]};
        if (!find_place(place, std::size_t(old_entity.index), carried(n))) return false;
        entities_[n] = place.entity;
        parameters_[n] = place.parameter;
        return true;
    }

    /// `old_index`: of the old vertex, edge or face, whose dimension `place` has.
    bool find_place(Place& place, std::size_t old_index, const Vec3& p) {
        const CarriedRegion& region = regions()[std::size_t(place.motion)];
        switch (place.entity.dim) {
            case 0:
                return old_index < region.new_vertex_of.size() && place_on_vertex(place, region.new_vertex_of[old_index], p);
            case 1:
                return old_index < region.new_edges_of.size() && place_on_edges(place, region.new_edges_of[old_index], p);
            case 2:
                return old_index < region.new_faces_of.size() && place_on_faces(place, old_index, p);
            default:
                return false;
        }
    }

    bool place_on_vertex(Place& place, VertexId vertex, const Vec3& p) const {
        if (!vertex.is_valid()) return false;
        place.entity = entity_of(vertex);
        return in_.new_brep.distance_from(vertex, p) <= tolerance();
    }

    // An edge may have been split, or be one with others: the piece that the node lies within has it.
    bool place_on_edges(Place& place, const std::vector<EdgeId>& pieces, const Vec3& p) {
        return std::any_of(pieces.begin(), pieces.end(), [&](EdgeId edge) { return place_on_edge(place, edge, p); });
    }

    bool place_on_edge(Place& place, EdgeId piece, const Vec3& p) {
        const EdgeId edge = merged_->edge_of[piece.index()];   // the one that has the chain
        place.entity = entity_of(edge);
        EdgeRange& range = edge_ranges_[edge.index()];
        if (!(range.first < range.last)) range = range_of(in_.new_brep, edge);
        const auto is_within = [&](double t) { return t > range.first && t < range.last; };
        if (is_within(place.parameter[0]) && distance(projector_.on_edge(edge, place.parameter[0]), p) <= tolerance()) return true;
        const OnEdge foot = projector_.nearest(edge, p);
        if (!is_within(foot.t) || foot.distance > tolerance()) return false;
        place.parameter[0] = foot.t;
        return true;
    }

    // Where a face's boundary is the old one a point that was inside still is: everywhere, or far from all that changed.
    bool is_untouched(const Place& place, std::size_t old_face, const Vec3& p) const {
        return (place.motion == 0 && is_untouched_[old_face]) || is_far_from_changes(place, p);
    }

    bool is_far_from_changes(const Place& place, const Vec3& p) const {
        const Box changed = regions()[std::size_t(place.motion)].changed.box();
        if (changed.is_empty()) return false;
        return !changed.grown(2 * in_.margin * in_.new_sizing.largest()).contains(p) || !changed.grown(2 * in_.margin * in_.new_sizing.at(p)).contains(p);
    }

    bool place_on_faces(Place& place, std::size_t old_face, const Vec3& p) {
        const auto& pieces = regions()[std::size_t(place.motion)].new_faces_of[old_face];
        if (pieces.size() == 1) return place_on_face(place, pieces[0], p, is_untouched(place, old_face, p));
        std::vector<FaceId> near;
        for (const FaceId face : pieces)
            if (may_hold(face, p)) near.push_back(face);
        const bool is_clear = near.size() == 1 && is_far_from_changes(place, p);
        return std::any_of(near.begin(), near.end(), [&](FaceId face) { return place_on_face(place, face, p, is_clear); });
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
                if (motions_[n] == std::int32_t(r)) {
                    box.add(carried(n));
                    spacing = std::max(spacing, clearance_between_motions * in_.new_sizing.at(carried(n)));
                }
            if (box.is_empty()) continue;
            std::vector<Vec3> settled;
            for (std::size_t n = 0; n < node_count(); ++n)
                if (motions_[n] >= 0 && motions_[n] < std::int32_t(r) && box.grown(spacing).contains(carried(n)))
                    settled.push_back(carried(n));
            const PointGrid grid(std::move(settled), spacing);
            for (std::size_t n = 0; n < node_count(); ++n)
                if (motions_[n] == std::int32_t(r) &&
                    grid.has_within(carried(n), clearance_between_motions * in_.new_sizing.at(carried(n))))
                    motions_[n] = dropped;
        }
    }

    Kept assemble(const KeptTets& tets) {
        Kept kept;
        reserve(kept);
        context_.check_cancelled();
        const std::vector<std::int32_t> new_index = take_nodes(kept, tets);
        take_tets(kept, tets, new_index);
        context_.check_cancelled();
        take_triangles(kept, tets, new_index);
        mark_changed_sides(kept);
        take_segments(kept, new_index);
        kept.rim_tets = tets.tets_at(kept.mesh, kept.is_rim, kept.node_origin);
        kept.mesh.next_node_number = in_.old_mesh.next_node_number;
        kept.mesh.next_element_number = in_.old_mesh.next_element_number;
        if (in_.old_mesh.order == 2) kept.curved = std::make_shared<const Mesh>(with_mid_side_nodes(kept));
        context_.check_cancelled();
        collect_active(kept, new_index);
        count_by_motion(kept, tets);
        kept.merged = merged_;
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
        kept.node_origin.reserve(nodes), kept.triangle_origin.reserve(triangles), kept.tet_origin.reserve(tets), kept.is_rim.reserve(nodes);
    }

    std::vector<std::int32_t> take_nodes(Kept& kept, const KeptTets& tets) const {
        const Mesh& old = in_.old_mesh;
        Mesh& mesh = kept.mesh;
        std::vector<std::int32_t> new_index(node_count(), -1);
        for (std::size_t n = 0; n < old.corner_count; ++n) {
            if (!tets.has_kept_tet(n)) continue;
            new_index[n] = std::int32_t(kept.node_origin.size());
            kept.node_origin.push_back(std::int32_t(n));
        }
        const std::size_t count = kept.node_origin.size();
        mesh.points.resize(count), kept.is_rim.resize(count);
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t origin = std::size_t(kept.node_origin[n]);
            mesh.points[n] = motions_[origin] == 0 ? old.points[origin] : carried(origin);   // the first motion is the identity
            kept.is_rim[n] = tets.is_rim(origin);
        }
        take(mesh.entities, entities_, kept.node_origin);
        take(mesh.parameters, parameters_, kept.node_origin);
        take(mesh.node_numbers, old.node_numbers, kept.node_origin);
        for (std::size_t n = 0; n < mesh.entities.size(); ++n)
            if (Entity& entity = mesh.entities[n]; entity.dim == 3)
                entity = entity_of(tets.solid_of_group(SolidId(entity.index), motions_[std::size_t(kept.node_origin[n])]));
        mesh.corner_count = mesh.points.size();
        return new_index;
    }

    template <class T>
    static void take(std::vector<T>& list, const std::vector<T>& old, const std::vector<std::int32_t>& origins) {
        list.resize(origins.size());
        for (std::size_t i = 0; i < origins.size(); ++i) list[i] = old[std::size_t(origins[i])];
    }

    // From one tet that does not stay to the next.
    void take_tets(Kept& kept, const KeptTets& tets, const std::vector<std::int32_t>& new_index) const {
        std::size_t begin = 0;
        for (const std::int32_t end : tets.dropped_tets()) {
            take_run(begin, std::size_t(end), kept, tets, new_index);
            begin = std::size_t(end) + 1;
        }
        take_run(begin, in_.old_mesh.tets.size(), kept, tets, new_index);
        if (tets.is_uniform()) return;
        for (std::size_t t = 0; t < kept.mesh.tets.size(); ++t)
            for (const NodeId n : kept.mesh.tets[t])
                if (Entity& entity = kept.mesh.entities[n.index()]; entity.dim == 3) entity = entity_of(kept.mesh.tet_solids[t]);
    }

    void take_run(std::size_t begin, std::size_t end, Kept& kept, const KeptTets& tets, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        Mesh& mesh = kept.mesh;
        const auto place = [&](NodeId n) { return NodeId(new_index[n.index()]); };
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c, d] = old.tets[t];
            mesh.tets.push_back({place(a), place(b), place(c), place(d)});
            mesh.tet_solids.push_back(tets.solid_of(t));
            kept.tet_origin.push_back(std::int32_t(t));
        }
        mesh.tet_numbers.insert(mesh.tet_numbers.end(), old.tet_numbers.begin() + std::ptrdiff_t(begin), old.tet_numbers.begin() + std::ptrdiff_t(end));
    }

    // A face may have a solid on a side where it had none.
    void mark_changed_sides(Kept& kept) const {
        const std::vector<char> was = counts_of_sides(in_.old_brep), is = counts_of_sides(in_.new_brep);
        for (std::size_t t = 0; t < kept.triangle_origin.size(); ++t) {
            const FaceId old_face = in_.old_mesh.triangle_faces[std::size_t(kept.triangle_origin[t])];
            if (was[old_face.index()] == is[kept.mesh.triangle_faces[t].index()]) continue;
            for (const NodeId n : kept.mesh.triangles[t]) kept.is_rim[n.index()] = 1;
        }
    }

    template <std::size_t N>
    bool survives(const std::array<NodeId, N>& nodes, const std::vector<std::int32_t>& new_index) const {
        for (const NodeId n : nodes)
            if (new_index[n.index()] < 0 || motions_[n.index()] != motions_[nodes[0].index()]) return false;
        return true;
    }

    void take_triangles(Kept& kept, const KeptTets& tets, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        const std::vector<char> backed = backed_by_kept_tets(tets, new_index);
        std::map<std::tuple<std::size_t, FaceId, FaceId>, bool> flipped;
        auto flip = flipped.end();
        for (std::size_t t = 0; t < old.triangles.size(); ++t) {
            const auto& nodes = old.triangles[t];
            if (!backed[t] || !survives(nodes, new_index)) continue;
            const std::size_t r = std::size_t(motions_[nodes[0].index()]);
            const FaceId old_face = old.triangle_faces[t], face = face_of(r, t);
            if (!face.is_valid()) {
                for (const NodeId n : nodes) kept.is_rim[std::size_t(new_index[n.index()])] = 1;
                continue;
            }
            if (flip == flipped.end() || flip->first != std::tuple{r, old_face, face}) {   // most triangles are on the face of the one before
                bool is_new = false;
                std::tie(flip, is_new) = flipped.try_emplace({r, old_face, face}, false);
                if (is_new) flip->second = is_flipped(t, face);
            }
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
            if (entities_[n.index()].dim == 2) return FaceId(entities_[n.index()].index);
        const auto is_at = [&](NodeId n, FaceId face) {
            const std::vector<FaceId> faces = faces_at(in_.new_brep, entities_[n.index()]);
            return std::binary_search(faces.begin(), faces.end(), face);
        };
        std::vector<FaceId> candidates;
        for (const FaceId face : pieces)
            if (std::all_of(nodes.begin(), nodes.end(), [&](NodeId n) { return is_at(n, face); }))
                candidates.push_back(face);
        if (candidates.size() < 2)
            return candidates.empty() ? FaceId() : candidates[0];  // its middle may lie beyond the chord of an arc
        const Vec3 middle = (carried(nodes[0].index()) + carried(nodes[1].index()) + carried(nodes[2].index())) / 3.0;
        for (const FaceId face : candidates)
            if (projector_.is_inside_trim(face, projector_.nearest(face, middle).uv)) return face;
        return FaceId();
    }

    // A triangle stays with the tet behind it: the cavity's boundary is then where kept tets end. Around a node off the rim all tets are kept, so only
    // triangles between rim nodes need a look.
    std::vector<char> backed_by_kept_tets(const KeptTets& tets, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        const auto is_rim = [&](NodeId n) { return tets.is_rim(n.index()) && new_index[n.index()] >= 0; };
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
        for (const std::int32_t tet : tets.tets_at_rim()) {
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
        const auto inner = std::find_if(nodes.begin(), nodes.end(), [&](NodeId n) { return entities_[n.index()] == entity_of(face); });
        const std::array<double, 2> uv = inner != nodes.end() ? parameters_[inner->index()] : projector_.nearest(face, (a + b + c) / 3.0).uv;
        return dot(projector_.normal(face, uv), cross(b - a, c - a)) < 0;
    }

    void take_segments(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        std::map<std::tuple<std::size_t, EdgeId, EdgeId>, bool> turned;
        for (std::size_t s = 0; s < old.segments.size(); ++s) {
            const auto& nodes = old.segments[s];
            if (!survives(nodes, new_index) || !has_its_mid(s)) continue;
            const EdgeId edge = edge_of(s);
            if (!edge.is_valid()) continue;
            std::array<NodeId, 2> segment{NodeId(new_index[nodes[0].index()]), NodeId(new_index[nodes[1].index()])};
            const auto [turn, is_new] = turned.try_emplace({std::size_t(motions_[nodes[0].index()]), old.segment_edges[s], edge}, false);
            if (is_new) turn->second = runs_backwards(kept.mesh, segment, edge);
            if (turn->second) std::swap(segment[0], segment[1]);
            kept.mesh.segments.push_back(segment);
            kept.mesh.segment_edges.push_back(edge);
            kept.mesh.segment_numbers.push_back(old.segment_numbers[s]);
            kept.segment_origin.push_back(std::int32_t(s));
        }
    }

    // Its ends may stay for other tets' sake while all tets that had its mid-side node go.
    bool has_its_mid(std::size_t segment) const {
        const Mesh& old = in_.old_mesh;
        return old.order == 1 || motions_[old.segment_mids[segment].index()] == motions_[old.segments[segment][0].index()];
    }

    // The piece of its edge that an old segment is on: both its nodes are, and of several (two arcs between two vertices) it is the nearest.
    EdgeId edge_of(std::size_t segment) const {
        const auto& nodes = in_.old_mesh.segments[segment];
        std::vector<EdgeId> candidates;
        const std::size_t r = std::size_t(motions_[nodes[0].index()]);
        for (const EdgeId piece : regions()[r].new_edges_of[in_.old_mesh.segment_edges[segment].index()])
            if (const EdgeId edge = merged_->edge_of[piece.index()]; is_at(edge, nodes[0]) && is_at(edge, nodes[1])) candidates.push_back(edge);
        if (candidates.size() < 2) return candidates.empty() ? EdgeId() : candidates[0];
        const Vec3 middle = (carried(nodes[0].index()) + carried(nodes[1].index())) / 2.0;
        EdgeId best;
        double least = std::numeric_limits<double>::infinity();
        for (const EdgeId edge : candidates) {
            const double d = projector_.nearest(edge, middle).distance;
            if (d < least) least = d, best = edge;
        }
        return best;
    }

    bool is_at(EdgeId edge, NodeId node) const {
        const Entity entity = entities_[node.index()];
        if (entity.dim == 1) return entity == entity_of(edge);
        const auto ends = in_.new_brep.ends_of(edge);
        const VertexId vertex = merged_->vertex_of[std::size_t(entity.index)];
        return merged_->vertex_of[ends[0].index()] == vertex || merged_->vertex_of[ends[1].index()] == vertex;
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
        const std::size_t nodes = old.points.size() + curved.points.size() - old.corner_count;
        curved.points.reserve(nodes), curved.entities.reserve(nodes), curved.parameters.reserve(nodes), curved.node_numbers.reserve(nodes);
        curved.tet_mids.reserve(kept.tet_origin.size());
        std::vector<NodeId> new_mid(old.points.size());
        const auto take = [&](NodeId old_mid, SolidId solid) {
            NodeId& mid = new_mid[old_mid.index()];
            if (mid.is_valid()) return mid;
            const std::size_t n = old_mid.index();
            mid = NodeId(curved.points.size());
            curved.points.push_back(motions_[n] == 0 ? old.points[n] : carried(n));
            curved.entities.push_back(entities_[n].dim == 3 ? entity_of(solid) : entities_[n]);
            curved.parameters.push_back(parameters_[n]);
            curved.node_numbers.push_back(old.node_numbers[n]);
            return mid;
        };
        RoundWatch watch(context_);
        for (std::size_t t = 0; t < kept.tet_origin.size(); ++t) {
            watch();
            std::array<NodeId, 6> mids;
            for (int s = 0; s < 6; ++s) mids[s] = take(old.tet_mids[std::size_t(kept.tet_origin[t])][s], kept.mesh.tet_solids[t]);
            curved.tet_mids.push_back(mids);
        }
        // A triangle or segment may have been turned round: its sides are found again by their corners.
        for (std::size_t t = 0; t < kept.triangle_origin.size(); ++t) {
            auto mids = old.triangle_mids[std::size_t(kept.triangle_origin[t])];
            const auto& corners = old.triangles[std::size_t(kept.triangle_origin[t])];
            const bool turned = kept.node_origin[curved.triangles[t][1].index()] != corners[1].value;
            if (turned) std::swap(mids[0], mids[2]);
            curved.triangle_mids.push_back({take(mids[0], {}), take(mids[1], {}), take(mids[2], {})});   // tets have brought them
        }
        for (const std::int32_t s : kept.segment_origin) curved.segment_mids.push_back(take(old.segment_mids[std::size_t(s)], {}));
        return curved;
    }

    void collect_active(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        RoundWatch watch(context_);
        for (std::size_t n = 0; n < in_.old_mesh.corner_count; ++n) {
            watch();
            if (new_index[n] >= 0 || in_.old_mesh.entities[n].dim != 3) continue;
            const Vec3& p = in_.old_mesh.points[n];
            const double wanted = in_.new_sizing.at(p);
            if (!size_changed(n, wanted) && regions()[0].changed.distance(p, active_margin * wanted) >= active_margin * wanted)
                kept.active.push_back(p);
        }
    }

    void count_by_motion(Kept& kept, const KeptTets& tets) const {
        for (const CarriedRegion& region : regions()) kept.by_motion.push_back({region.motion, region.features});
        for (const std::int32_t n : kept.node_origin) ++kept.by_motion[std::size_t(motions_[std::size_t(n)])].nodes;
        const std::vector<std::size_t> counts = tets.counts();
        for (std::size_t r = 0; r < counts.size(); ++r) kept.by_motion[r].tets = counts[r];
    }

    const KeepInput& in_;
    RunContext& context_;
    Projector projector_;
    const std::shared_ptr<const MergedEntities> merged_;
    // By old node: index of its carried region; then, where it stays, what it is on in the new shape (of inner nodes still the old solid).
    std::vector<std::int32_t> motions_;
    std::vector<Entity> entities_;
    std::vector<std::array<double, 2>> parameters_;
    std::vector<char> untouched_solids_;   // by old solid; empty where there is only one
    std::vector<char> in_untouched_;   // by old node: a tet of an untouched solid has it; empty where there is no such solid
    std::vector<char> near_change_;    // likewise: and it stays for those tets only
    std::vector<char> is_untouched_;   // by old face: kept in place with all its edges
    std::vector<Box> face_boxes_;      // by new face, empty until asked for
    std::vector<EdgeRange> edge_ranges_;   // by new edge, likewise
};

}  // namespace

Kept keep(const KeepInput& input, RunContext& context) {
    RunContext::Step step(context, "keep");
    return Keeper(input, context).run();
}

}  // namespace featuremesh
