// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/keep.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "brep/enclosure.h"
#include "core/dimension.h"
#include "mesh/second_order.h"
#include "update/carried_nodes.h"
#include "update/doubled_nodes.h"
#include "update/entity_finder.h"
#include "update/kept_entities.h"
#include "update/kept_mesh.h"
#include "update/kept_surfaces.h"
#include "update/kept_tets.h"
#include "update/kept_triangles.h"
#include "update/untouched_solids.h"

namespace featuremesh {

namespace {

constexpr double size_change_that_releases = 1.2, asked_change_that_releases = 1.01;
constexpr double clearance_between_motions = 1.5;  // edge lengths
constexpr double active_margin = 0.6;              // edge lengths
constexpr double same_size = 1e-9;                 // relative
constexpr char stays_for_surface = 2;              // in near_change_

/// Edge lengths that were asked for at a node under its motion, mm; 0 where nobody asked.
struct SizesAtNode {
    double was = 0, wanted = 0;
    bool is_carried = false;  ///< by another motion than the identity
};

class Keeper {
  public:
    Keeper(const KeepInput& input, RunContext& context)
        : in_(input),
          context_(context),
          motions_(input.old_mesh.points.size(), 0),
          nodes_{input, motions_},
          entities_(nodes_),
          ends_of_mids_(ends_of_mids(input.old_mesh)),
          is_resized_(motions_.size(), 0),
          asked_(motions_.size()),
          surfaces_(input) {}

    Kept run() {
        if (has_tets()) {
            choose_motions();
            context_.check_cancelled();
            find_untouched_solids();
        }
        if (has_shells()) {
            mark_nodes_of_tets();
            find_untouched_entities();
            choose_motions_of_shells();
        }
        drop_near_changes();
        keep_surfaces();
        place_on_entities();
        clear_round_new_vertices();
        clear_between_motions();
        surfaces_.settle(motions_);
        context_.check_cancelled();
        std::optional<KeptShells> shells;
        if (has_shells()) shells.emplace(in_, motions_, near_change_, untouched_entities_);
        const KeptTets tets(in_.old_mesh, motions_, nodes_.regions(), in_.old_brep, in_.new_brep, near_change_,
                            untouched_solids_, is_resized_, &entities_);
        Kept kept = assemble(nodes_, entities_, tets, surfaces_, shells ? &*shells : nullptr, context_);
        context_.check_cancelled();
        remember_sizes(kept);
        if (has_straight_sides_) kept.straight = entities_.straight_sides_of(*kept.curved);
        collect_active(kept, tets);
        return kept;
    }

  private:
    std::size_t node_count() const { return motions_.size(); }
    bool has_tets() const { return in_.new_brep.dimension() == Dimension::solids; }
    bool has_shells() const { return in_.old_brep.has_free_faces() || in_.old_brep.has_free_edges(); }

    // The nodes of tets inside a feature that moved prefer its motion (that of the last one, inside several), all
    // others stay where they are. Nodes on the feature's own faces may be outside of its triangulation; the middles of
    // their tets are not.
    void choose_motions() {
        std::vector<std::pair<std::int32_t, Enclosure>> features;
        for (std::size_t r = nodes_.regions().size(); r-- > 1;) {
            std::vector<TopoDS_Shape> volumes = nodes_.regions()[r].volumes;
            std::erase_if(volumes, [](const TopoDS_Shape& v) { return dimension_of(v) != Dimension::solids; });
            if (!volumes.empty()) features.emplace_back(std::int32_t(r), Enclosure(volumes));
            context_.check_cancelled();
        }
        if (features.empty()) return;
        const Mesh& old = in_.old_mesh;
        std::vector<std::int32_t> motion_of(old.tets.size(), 0);
        parallel_for(context_, old.tets.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                const auto& [a, b, c, d] = old.tets[t];
                const Vec3 middle = (old.point(a) + old.point(b) + old.point(c) + old.point(d)) / 4;
                const auto holds_it = [&](const auto& feature) { return feature.second.contains(middle); };
                const auto found = std::find_if(features.begin(), features.end(), holds_it);
                if (found != features.end()) motion_of[t] = found->first;
            }
        });
        for (std::size_t t = 0; t < old.tets.size(); ++t) {
            if (motion_of[t] == 0) continue;
            const auto take = [&](NodeId n) { motions_[n.index()] = std::max(motions_[n.index()], motion_of[t]); };
            for (const NodeId n : old.tets[t]) take(n);
            if (old.order == 2)
                for (const NodeId n : old.tet_mids[t]) take(n);
        }
    }

    // What changes beside a solid that is as it was, or moved as a whole, is none of its business.
    void find_untouched_solids() {
        const std::vector<std::int32_t> motion_of = motions_of_untouched_solids(in_);
        untouched_solids_.assign(motion_of.size(), 0);
        for (std::size_t s = 0; s < motion_of.size(); ++s) untouched_solids_[s] = motion_of[s] != dropped;
        if (std::count(untouched_solids_.begin(), untouched_solids_.end(), 1) == 0) return;
        near_change_.assign(node_count(), 0);
        untouched_under_.assign(node_count(), dropped);
        const Mesh& old = in_.old_mesh;
        for (std::size_t t = 0; t < old.tets.size(); ++t) {
            const std::int32_t motion = motion_of[old.tet_solids[t].index()];
            if (motion == dropped) continue;
            const auto take = [&](NodeId n) {
                untouched_under_[n.index()] = motion;
                motions_[n.index()] = motion;  // also where it overlaps a feature that moved
            };
            for (const NodeId n : old.tets[t]) take(n);
            if (old.order == 2)
                for (const NodeId n : old.tet_mids[t]) take(n);
        }
    }

    void mark_nodes_of_tets() {
        has_tet_.assign(node_count(), 0);
        for (const auto& tet : in_.old_mesh.tets)
            for (const NodeId n : tet) has_tet_[n.index()] = 1;
        for (const auto& mids : in_.old_mesh.tet_mids)
            for (const NodeId n : mids) has_tet_[n.index()] = 1;
    }

    void find_untouched_entities() {
        untouched_entities_ = untouched_entities(in_);
        if (std::count(untouched_entities_.begin(), untouched_entities_.end(), 1) == 0) return;
        if (near_change_.empty()) near_change_.assign(node_count(), 0), untouched_under_.assign(node_count(), dropped);
        const std::vector<char> on_them = nodes_on(in_, untouched_entities_);
        for (std::size_t n = 0; n < on_them.size(); ++n)
            if (on_them[n] && untouched_under_[n] == dropped) untouched_under_[n] = 0;
    }

    // What has tets goes with them.
    void choose_motions_of_shells() {
        const std::vector<std::int32_t> motions = motions_without_tets(in_, untouched_entities_, context_);
        for (std::size_t n = 0; n < motions.size(); ++n)
            if (!has_tet_[n]) motions_[n] = motions[n];
    }

    /// Of a solid, face or edge that is as it was, under the motion that it has.
    bool is_untouched(std::size_t n) const {
        return !untouched_under_.empty() && untouched_under_[n] != dropped && untouched_under_[n] == motions_[n];
    }

    double made_for(std::size_t n) const {
        const std::optional<double> remembered = in_.made_for.of(NodeId(n));
        return remembered ? *remembered : in_.old_sizing.at(in_.old_mesh.points[n]);
    }

    bool size_changed(double was, double wanted) const {
        const double most =
            in_.asked == AskedSizes::other_lengths ? asked_change_that_releases : size_change_that_releases;
        return std::max(was / wanted, wanted / was) > most;
    }

    // Away from everything that changed neither sizes nor distances need to be asked for. Mid-side nodes go with the
    // ends of their sides.
    void drop_near_changes() {
        std::vector<Box> reach;
        const double widest = in_.margin * in_.new_sizing.largest();
        for (const CarriedRegion& region : nodes_.regions())
            reach.push_back(region.changed.box().is_empty() ? Box{} : region.changed.box().grown(widest));
        const std::vector<Box> resized = where_different(in_.old_sizing, in_.new_sizing);
        parallel_for(context_, in_.old_mesh.corner_count, 4096, [&](std::size_t begin, std::size_t end) {
            std::vector<std::size_t> may_be_near, may_be_resized;
            for (std::size_t n = begin; n < end; ++n) {
                const Vec3 p = nodes_.at(n);
                const auto holds_p = [&](const Box& box) { return box.contains(p); };
                const bool is_carried = motions_[n] > 0, is_near = holds_p(reach[nodes_.motion_of(NodeId(n))]);
                if (is_near) may_be_near.push_back(n);
                if (is_carried || std::any_of(resized.begin(), resized.end(), holds_p))
                    may_be_resized.push_back(n);
                else if (!is_near)
                    continue;
                asked_[n] = {0, in_.new_sizing.at(p), is_carried};
            }
            // of one field after the other: it finds the size at a node quickly that is beside the one before
            for (const std::size_t n : may_be_resized) asked_[n].was = made_for(n);
            for (const std::size_t n : may_be_resized)
                if (size_changed(asked_[n].was, asked_[n].wanted)) drop(n, true);
            for (const std::size_t n : may_be_near)
                if (motions_[n] != dropped && is_near_change(n)) drop(n, false);
        });
        for (std::size_t mid = 0; mid < ends_of_mids_.size(); ++mid) {
            const std::size_t n = in_.old_mesh.corner_count + mid;
            const std::size_t a = ends_of_mids_[mid][0].index(), b = ends_of_mids_[mid][1].index();
            asked_[n] = asked_[a].wanted > 0 ? asked_[a] : asked_[b];
            asked_[n].is_carried = motions_[n] > 0;
            if (motions_[a] == dropped || motions_[b] == dropped) drop(n, is_resized_[a] || is_resized_[b]);
        }
    }

    bool is_near_change(std::size_t n) const {
        const ChangedBoundary& changed = nodes_.regions()[nodes_.motion_of(NodeId(n))].changed;
        return changed.is_within(in_.margin * asked_[n].wanted, nodes_.at(n));
    }

    void drop(std::size_t n, bool is_resized) {
        if (is_untouched(n) && (in_.asked == AskedSizes::same || !is_resized))
            near_change_[n] = 1;
        else
            motions_[n] = dropped, is_resized_[n] = is_resized;
    }

    // What lies on a surface may stay though its tets go: for its triangles only what changes on that surface counts.
    void keep_surfaces() {
        if (!has_tets() || has_shells()) return;
        const auto margin_of = [&](std::size_t n) {
            return is_resized_[n] || asked_[n].is_carried ? 0 : in_.margin * asked_[n].wanted;
        };
        surfaces_.find(motions_, margin_of, context_);
        for (std::size_t n = 0; n < node_count(); ++n) {
            if (!surfaces_.has_kept(n) || motions_[n] != dropped) continue;
            if (near_change_.empty()) near_change_.assign(node_count(), 0);
            motions_[n] = 0;
            near_change_[n] = stays_for_surface;
        }
    }
    bool is_for_surface(std::size_t n) const { return !near_change_.empty() && near_change_[n] == stays_for_surface; }

    void place_on_entities() {
        for (std::size_t n = 0; n < node_count(); ++n) {
            if (n % 4096 == 0) context_.check_cancelled();
            if (motions_[n] != dropped && !(place(n) && is_meshed(entities_.entities()[n]))) motions_[n] = dropped;
        }
        for (const std::size_t n : doubled_nodes(in_, motions_, entities_)) motions_[n] = dropped;
    }

    // A vertex may be new where nothing changed that is worth the name: a feature has come to touch an edge there, or a
    // solid to share an edge with another one that has a vertex there. It needs a node, and room for it.
    void clear_round_new_vertices() {
        const Brep& brep = in_.new_brep;
        const std::vector<VertexId>& vertex_of = entities_.merged()->vertex_of;
        std::vector<char> is_old(brep.vertex_count(), 0);
        for (const CarriedRegion& region : nodes_.regions())
            for (const VertexId v : region.new_vertex_of)
                if (v.is_valid()) is_old[vertex_of[v.index()].index()] = 1;
        for (const VertexId v : vertices_new_on_edges(*entities_.merged())) is_old[v.index()] = 0;
        std::vector<Vec3> bare;
        for (std::size_t v = 0; v < is_old.size(); ++v)
            if (!is_old[v] && vertex_of[v] == VertexId(v) && is_meshed(entity_of(VertexId(v))))
                bare.push_back(brep.point_of(VertexId(v)));
        if (bare.empty()) return;
        const double widest = in_.margin * in_.new_sizing.largest();
        const PointGrid grid(std::move(bare), widest);
        for (std::size_t n = 0; n < in_.old_mesh.corner_count; ++n) {
            if (motions_[n] == dropped) continue;
            const Vec3 p = nodes_.at(n);
            if (grid.has_within(p, widest) && grid.has_within(p, in_.margin * in_.new_sizing.at(p))) drop(n, false);
        }
    }

    /// On edges that were there without them: between the pieces of one, or beside it and merged with it since.
    std::vector<VertexId> vertices_new_on_edges(const MergedEntities& merged) const {
        std::vector<VertexId> found;
        const std::vector<std::vector<VertexId>> old_vertices = old_vertices_on_edges();
        for (const CarriedRegion& region : nodes_.regions()) {
            const auto place_of = [&](VertexId old) {
                const VertexId now = old.is_valid() ? region.new_vertex_of[old.index()] : VertexId();
                return now.is_valid() ? merged.vertex_of[now.index()] : now;
            };
            for (std::size_t e = 0; e < region.new_edges_of.size(); ++e) {
                std::vector<VertexId> on;
                for (const EdgeId piece : region.new_edges_of[e]) {
                    if (region.new_edges_of[e].size() > 1)
                        for (const VertexId end : in_.new_brep.ends_of(piece))
                            if (end.is_valid()) on.push_back(merged.vertex_of[end.index()]);
                    for (const auto& [t, vertex] : merged.vertices_on[piece.index()]) on.push_back(vertex);
                }
                if (on.empty()) continue;
                std::vector<VertexId> was_on;
                for (const VertexId old : old_vertices[e]) was_on.push_back(place_of(old));
                for (const VertexId v : on)
                    if (std::find(was_on.begin(), was_on.end(), v) == was_on.end()) found.push_back(v);
            }
        }
        return found;
    }

    /// By edge: its ends, and others whose nodes it had.
    std::vector<std::vector<VertexId>> old_vertices_on_edges() const {
        const Mesh& old = in_.old_mesh;
        std::vector<std::vector<VertexId>> on(in_.old_brep.edge_count());
        for (std::size_t e = 0; e < on.size(); ++e)
            for (const VertexId end : in_.old_brep.ends_of(EdgeId(e))) on[e].push_back(end);
        for (std::size_t s = 0; s < old.segments.size(); ++s)
            for (const NodeId n : old.segments[s])
                if (old.entities[n.index()].dim == 0)
                    on[old.segment_edges[s].index()].emplace_back(old.entities[n.index()].index);
        return on;
    }

    bool place(std::size_t n) {
        if (entities_.place(n)) return true;
        if (!is_straight(n) || !entities_.place_straight(n)) return false;
        return has_straight_sides_ = true;
    }

    /// A mid-side node between ends that stay.
    bool is_straight(std::size_t n) const {
        const Mesh& old = in_.old_mesh;
        if (n < old.corner_count) return false;
        const auto& [a, b] = ends_of_mids_[n - old.corner_count];
        return motions_[a.index()] != dropped && motions_[b.index()] != dropped &&
               old.points[n] == 0.5 * (old.point(a) + old.point(b));
    }

    // Faces and edges beside solids may not be meshed any more.
    bool is_meshed(Entity entity) const {
        const Brep& brep = in_.new_brep;
        if (entity.dim == 1) return brep.is_meshed(EdgeId(entity.index));
        if (entity.dim == 2) return brep.is_meshed(FaceId(entity.index));
        const auto edges = edges_at(brep, entity);
        return entity.dim == 3 || !faces_at(brep, entity).empty() ||
               std::any_of(edges.begin(), edges.end(), [&](EdgeId edge) { return brep.is_meshed(edge); });
    }

    // Nodes that stay have precedence: a node that moved and comes near one that stayed is dropped. The nodes of a
    // solid that moved as a whole are never dropped.
    void clear_between_motions() {
        if (!has_tets()) return clear_between_motions_without_tets();
        for (std::size_t r = 1; r < nodes_.regions().size(); ++r) {
            Box box;
            double spacing = 0;
            for (std::size_t n = 0; n < node_count(); ++n)
                if (motions_[n] == std::int32_t(r)) {
                    box.add(nodes_.at(n));
                    spacing = std::max(spacing, clearance_between_motions * asked_[n].wanted);
                }
            if (box.is_empty()) continue;
            std::vector<Vec3> settled;
            for (std::size_t n = 0; n < node_count(); ++n)
                if (motions_[n] >= 0 && motions_[n] < std::int32_t(r) && !is_for_surface(n) &&
                    box.grown(spacing).contains(nodes_.at(n)))
                    settled.push_back(nodes_.at(n));
            const PointGrid grid(std::move(settled), spacing);
            for (std::size_t n = 0; n < node_count(); ++n)
                if (motions_[n] == std::int32_t(r) && !is_untouched(n) &&
                    grid.has_within(nodes_.at(n), clearance_between_motions * asked_[n].wanted))
                    motions_[n] = dropped;
        }
        clear_surfaces_of_carried();
    }

    // Tets come first: a node that stays for a surface alone goes where carried ones come near.
    void clear_surfaces_of_carried() {
        std::vector<Vec3> carried;
        double spacing = 0;
        for (std::size_t n = 0; n < node_count(); ++n)
            if (motions_[n] > 0) {
                carried.push_back(nodes_.at(n));
                spacing = std::max(spacing, clearance_between_motions * asked_[n].wanted);
            }
        if (carried.empty() || near_change_.empty()) return;
        const PointGrid grid(std::move(carried), spacing);
        for (std::size_t n = 0; n < node_count(); ++n)
            if (motions_[n] == 0 && is_for_surface(n) &&
                grid.has_within(nodes_.at(n), clearance_between_motions * asked_[n].wanted))
                motions_[n] = dropped;
    }

    // Likewise, but only on a face, or edge, that both are on.
    void clear_between_motions_without_tets() {
        if (nodes_.regions().size() < 2) return;
        const bool has_faces = in_.new_brep.dimension() == Dimension::faces;
        std::vector<std::vector<std::size_t>> on(has_faces ? in_.new_brep.face_count() : in_.new_brep.edge_count());
        for (std::size_t n = 0; n < node_count(); ++n) {
            if (motions_[n] == dropped) continue;
            const Entity entity = entities_.entities()[n];
            if (has_faces)
                for (const FaceId face : in_.new_brep.faces_at(entity)) on[face.index()].push_back(n);
            else
                for (const EdgeId edge : edges_at(in_.new_brep, entity)) on[edge.index()].push_back(n);
        }
        for (const std::vector<std::size_t>& nodes : on)
            for (std::size_t r = 1; r < nodes_.regions().size(); ++r) clear_beside_settled(nodes, std::int32_t(r));
    }

    void clear_beside_settled(const std::vector<std::size_t>& nodes, std::int32_t motion) {
        std::vector<Vec3> settled;
        double spacing = 0;
        for (const std::size_t n : nodes) {
            if (motions_[n] >= 0 && motions_[n] < motion) settled.push_back(nodes_.at(n));
            if (motions_[n] == motion) spacing = std::max(spacing, clearance_between_motions * asked_[n].wanted);
        }
        if (settled.empty() || spacing == 0) return;
        const PointGrid grid(std::move(settled), spacing);
        for (const std::size_t n : nodes)
            if (motions_[n] == motion && grid.has_within(nodes_.at(n), clearance_between_motions * asked_[n].wanted))
                motions_[n] = dropped;
    }

    // Writes down for which edge length each kept node was made, where that is not the length wanted there now. A node
    // that no change came near was made for the wanted length, unless the old mesh has another one on record.
    void remember_sizes(Kept& kept) const {
        for (std::size_t k = 0; k < kept.node_origin.size(); ++k) {
            const auto n = std::size_t(kept.node_origin[k]);
            const SizesAtNode& asked = asked_[n];
            const double was = asked.was > 0 ? asked.was : in_.made_for.of(NodeId(n)).value_or(0);
            if (was == 0) continue;
            const double wanted = asked.wanted > 0 ? asked.wanted : in_.new_sizing.at(nodes_.at(n));
            if (std::abs(was - wanted) <= same_size * wanted) continue;
            kept.made_for.nodes.emplace_back(k);
            kept.made_for.sizes.push_back(was);
        }
    }

    void collect_active(Kept& kept, const KeptTets& tets) const {
        RoundWatch watch(context_);
        for (std::size_t n = 0; n < in_.old_mesh.corner_count; ++n) {
            watch();
            if (tets.has_kept_tet(n) || in_.old_mesh.entities[n].dim != 3) continue;
            const Vec3& p = in_.old_mesh.points[n];
            const SizesAtNode asked = asked_[n].is_carried ? SizesAtNode{} : asked_[n];
            const double wanted = asked.wanted > 0 ? asked.wanted : in_.new_sizing.at(p);
            if (!nodes_.regions()[0].changed.is_within(active_margin * wanted, p) &&
                !size_changed(asked.was > 0 ? asked.was : made_for(n), wanted))
                kept.active.push_back(p);
        }
    }

    const KeepInput& in_;
    RunContext& context_;
    std::vector<std::int32_t> motions_;  // by old node: index of its carried region
    const CarriedNodes nodes_;
    KeptEntities entities_;
    const std::vector<std::array<NodeId, 2>> ends_of_mids_;
    bool has_straight_sides_ = false;
    std::vector<char> untouched_solids_;    // by old solid; empty where there is only one
    std::vector<char> untouched_entities_;  // by old face, then by old edge: the free ones
    std::vector<char> has_tet_;             // by old node; only where there are free faces or edges
    // By old node: the motion of the untouched solid, face or edge that it is of; empty where there is none.
    std::vector<std::int32_t> untouched_under_;
    std::vector<char> near_change_;   // likewise: and it stays for those tets only, or for the triangles of surfaces
    std::vector<char> is_resized_;    // by old node: it goes, since another size is wanted
    std::vector<SizesAtNode> asked_;  // by old node
    KeptSurfaces surfaces_;
};

}  // namespace

AskedSizes compare_asked_sizes(const SizingOptions& before, const SizingOptions& now) {
    if (before == now) return AskedSizes::same;
    const auto without_entities = [](SizingOptions options) {
        for (LocalSize& local : options.local) local.entity = {};
        const auto by_size = [](const LocalSize& a, const LocalSize& b) { return a.size < b.size; };
        std::sort(options.local.begin(), options.local.end(), by_size);
        options.local.erase(std::unique(options.local.begin(), options.local.end()), options.local.end());
        return options;
    };
    return without_entities(before) == without_entities(now) ? AskedSizes::same_lengths : AskedSizes::other_lengths;
}

Kept keep(const KeepInput& input, RunContext& context) {
    RunContext::Step step(context, "keep");
    return Keeper(input, context).run();
}

}  // namespace featuremesh
