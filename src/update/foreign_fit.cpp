// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/foreign_fit.h"

#include <algorithm>
#include <map>

#include "brep/enclosure.h"
#include "core/errors.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/joined_sets.h"
#include "core/messages.h"
#include "mesh/second_order.h"
#include "mesh/side_table.h"
#include "mesh/triangle_uses.h"

namespace featuremesh {

namespace {

double six_volumes(const Mesh& mesh, std::size_t t) {
    const auto& n = mesh.tets[t];
    return 6 * signed_volume(mesh.point(n[0]), mesh.point(n[1]), mesh.point(n[2]), mesh.point(n[3]));
}

/// Other programs number the corners the other way round.
void turn_inside_out(Mesh& mesh) {
    for (auto& tet : mesh.tets) std::swap(tet[1], tet[2]);
    for (auto& mids : mesh.tet_mids) mids = {mids[2], mids[1], mids[0], mids[3], mids[5], mids[4]};
}

bool is_inverted(const Mesh& mesh, std::size_t t) {
    const auto& n = mesh.tets[t];
    const Vec3 a = mesh.point(n[0]);
    const double scale = distance(a, mesh.point(n[1])) * distance(a, mesh.point(n[2])) * distance(a, mesh.point(n[3]));
    if (!(six_volumes(mesh, t) > 1e-9 * scale)) return true;
    return mesh.order == 2 && has_curved_side(mesh, TetId(t)) && min_scaled_jacobian(tet_nodes(mesh, TetId(t))) <= 0;
}

class Fitter {
  public:
    Fitter(const Brep& brep, Mesh foreign, RunContext& context)
        : brep_(brep), mesh_(std::move(foreign)), context_(context) {}

    ForeignFit run(int layers) {
        orient();
        surface_ = match_surface(brep_, mesh_, 5 * brep_.tolerances().on_entity(), context_);
        move_mids();
        find_inverted();
        release(layers);
        sort_into_solids();
        name_reasons();
        if (std::count(solid_of_.begin(), solid_of_.end(), SolidId()) == std::ptrdiff_t(solid_of_.size()))
            throw InputError(say<Code::nothing_fits>(fit_.reasons));
        assemble();
        return std::move(fit_);
    }

  private:
    void orient() {
        std::size_t negative = 0;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) negative += six_volumes(mesh_, t) < 0;
        if (2 * negative > mesh_.tets.size()) turn_inside_out(mesh_);
    }

    // Elements that would be folded with their mid-side nodes on the surface are found as such.
    void move_mids() {
        is_moved_.assign(mesh_.node_count(), 0);
        for (const MovedMid& mid : surface_.moved_mids) {
            is_moved_[mid.node.index()] = 1;
            mesh_.points[mid.node.index()] = mid.point;
        }
        fit_.moved_mids = surface_.moved_mids.size();
    }

    void find_inverted() {
        std::vector<char> bad(mesh_.tets.size(), 0);
        parallel_for(context_, bad.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) bad[t] = is_inverted(mesh_, t);
        });
        for (std::size_t t = 0; t < bad.size(); ++t) {
            if (!bad[t]) continue;
            ++inverted_;
            for (const NodeId n : mesh_.tets[t]) surface_.is_misfit[n.index()] = 1;
        }
    }

    bool touches_misfit(std::size_t t) const {
        const auto is_misfit = [&](NodeId n) { return surface_.is_misfit[n.index()] != 0; };
        return std::any_of(mesh_.tets[t].begin(), mesh_.tets[t].end(), is_misfit) ||
               (mesh_.order == 2 && std::any_of(mesh_.tet_mids[t].begin(), mesh_.tet_mids[t].end(), is_misfit));
    }

    void release(int layers) {
        is_released_.assign(mesh_.tets.size(), 0);
        for (int layer = 0;; ++layer) {
            for (std::size_t t = 0; t < mesh_.tets.size(); ++t) is_released_[t] = touches_misfit(t);
            if (layer == layers) return;
            for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
                if (is_released_[t])
                    for (const NodeId n : mesh_.tets[t]) surface_.is_misfit[n.index()] = 1;
        }
    }

    // Tets that meet in a triangle are in the same solid unless a face between two solids is there: one point tells for
    // all.
    void sort_into_solids() {
        JoinedSets pieces(mesh_.tets.size());
        join_neighbours([&](std::size_t a, std::size_t b) { pieces.join(std::int32_t(a), std::int32_t(b)); });
        std::vector<std::int32_t> largest(mesh_.tets.size(), -1);
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            if (is_released_[t]) continue;
            std::int32_t& best = largest[std::size_t(pieces.root(std::int32_t(t)))];
            if (best < 0 || six_volumes(mesh_, t) > six_volumes(mesh_, std::size_t(best))) best = std::int32_t(t);
        }
        // Solids may overlap, so a point may be in several: where a face is known, in one that it bounds.
        std::map<std::int32_t, std::vector<char>> may_be;  // by root and solid
        for (const MatchedTriangle& triangle : surface_.triangles) {
            const std::array<SolidId, 2> beside = brep_.solids_beside(triangle.face);
            for (std::size_t k = 0; k < 2; ++k) {
                const TetId tet = triangle.tets[k];
                if (!tet.is_valid() || is_released_[tet.index()] || !beside[k].is_valid()) continue;
                std::vector<char>& solids = may_be[pieces.root(tet.value)];
                solids.resize(brep_.solid_count());
                solids[beside[k].index()] = 1;
            }
        }
        const SolidLocator locator(brep_);
        std::vector<SolidId> solid_of_root(mesh_.tets.size());
        for (std::size_t r = 0; r < largest.size(); ++r)
            if (largest[r] >= 0)
                solid_of_root[r] = locator.solid_at(centre(std::size_t(largest[r])), may_be[std::int32_t(r)]);
        solid_of_.assign(mesh_.tets.size(), SolidId());
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            if (is_released_[t]) continue;
            solid_of_[t] = solid_of_root[std::size_t(pieces.root(std::int32_t(t)))];
            outside_ += !solid_of_[t].is_valid();
        }
        fit_.released_tets = std::size_t(std::count(solid_of_.begin(), solid_of_.end(), SolidId()));
    }

    template <class Join>
    void join_neighbours(Join join) const {
        std::vector<std::array<NodeId, 3>> walls;
        for (const MatchedTriangle& triangle : surface_.triangles)
            if (triangle.tets[0].is_valid() && triangle.tets[1].is_valid()) {
                walls.push_back(triangle.nodes);
                std::sort(walls.back().begin(), walls.back().end());
            }
        std::sort(walls.begin(), walls.end());
        TriangleUses uses(mesh_);
        for (std::size_t b = 0; b < uses.bucket_count(); ++b)
            uses.visit_bucket(b, [&](std::span<const TriangleUse> meeting) {
                if (meeting.size() < 2 || !meeting[1].is_tet()) return;
                const std::array nodes{NodeId(b), NodeId(std::size_t(meeting[0].middle)),
                                       NodeId(std::size_t(meeting[0].largest))};
                const std::size_t s = meeting[0].element(), t = meeting[1].element();
                if (!is_released_[s] && !is_released_[t] && !std::binary_search(walls.begin(), walls.end(), nodes))
                    join(s, t);
            });
    }

    Vec3 centre(std::size_t t) const {
        const auto& n = mesh_.tets[t];
        return (mesh_.point(n[0]) + mesh_.point(n[1]) + mesh_.point(n[2]) + mesh_.point(n[3])) / 4;
    }

    void name_reasons() {
        const Misfits& misfits = surface_.misfits;
        count<Code::misfit_inverted>(inverted_);
        count<Code::misfit_overlaps>(misfits.overlaps);
        count<Code::misfit_nodes>(misfits.nodes_off_surface);
        count<Code::misfit_triangles>(misfits.triangles_on_no_face);
        count<Code::misfit_sides>(misfits.sides_on_no_edge);
        if (!misfits.open_edges.empty()) fit_.reasons.push_back(say<Code::misfit_edges>(misfits.open_edges));
        if (!misfits.open_faces.empty()) fit_.reasons.push_back(say<Code::misfit_faces>(misfits.open_faces));
        count<Code::misfit_outside>(outside_);
    }
    template <Code code>
    void count(std::size_t number) {
        if (number > 0) fit_.reasons.push_back(say<code>(number));
    }

    void assemble() {
        number_nodes();
        take_tets();
        take_triangles();
        take_segments();
        if (mesh_.order == 2) take_mids();
        Mesh& mesh = fit_.kept.mesh;
        fit_.kept.by_motion = {{RigidMotion{}, {}, mesh.node_count(), mesh.tets.size()}};
    }

    void number_nodes() {
        new_index_.assign(mesh_.node_count(), -1);
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
            if (solid_of_[t].is_valid())
                for (const NodeId n : mesh_.tets[t]) new_index_[n.index()] = 0;
        Kept& kept = fit_.kept;
        for (std::size_t n = 0; n < mesh_.corner_count; ++n) {
            if (new_index_[n] < 0) continue;
            new_index_[n] = std::int32_t(kept.mesh.points.size());
            kept.node_origin.push_back(std::int32_t(n));
            append_node(kept.mesh, n);
        }
        kept.mesh.corner_count = kept.mesh.points.size();
        kept.mesh.next_node_number = mesh_.next_node_number;
        kept.mesh.next_element_number = mesh_.next_element_number;
    }

    void append_node(Mesh& mesh, std::size_t n) const {
        mesh.points.push_back(mesh_.points[n]);
        mesh.entities.push_back(surface_.places[n].entity);
        mesh.parameters.push_back(surface_.places[n].parameters);
        mesh.node_numbers.push_back(mesh_.node_numbers[n]);
    }

    template <std::size_t N>
    std::array<NodeId, N> renamed(std::array<NodeId, N> nodes) const {
        for (NodeId& n : nodes) n = NodeId(new_index_[n.index()]);
        return nodes;
    }

    void take_tets() {
        Kept& kept = fit_.kept;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            if (!solid_of_[t].is_valid()) continue;
            kept.mesh.tets.push_back(renamed(mesh_.tets[t]));
            for (const NodeId n : kept.mesh.tets.back())
                if (Entity& entity = kept.mesh.entities[n.index()]; entity.dim == 3) entity = entity_of(solid_of_[t]);
            kept.mesh.tet_solids.push_back(solid_of_[t]);
            kept.mesh.tet_numbers.push_back(mesh_.tet_numbers[t]);
            kept.tet_origin.push_back(std::int32_t(t));
        }
    }

    void take_triangles() {
        Mesh& mesh = fit_.kept.mesh;
        for (const MatchedTriangle& triangle : surface_.triangles) {
            const auto stays = [&](TetId t) { return t.is_valid() && solid_of_[t.index()].is_valid(); };
            if (!stays(triangle.tets[0]) && !stays(triangle.tets[1])) continue;
            mesh.triangles.push_back(renamed(triangle.nodes));
            mesh.triangle_faces.push_back(triangle.face);
            mesh.triangle_numbers.push_back(triangle.number > 0 ? triangle.number : mesh.next_element_number++);
        }
    }

    void take_segments() {
        SideTable known(mesh_.node_count());
        for (std::size_t s = 0; s < mesh_.segments.size(); ++s)
            known.value(mesh_.segments[s][0], mesh_.segments[s][1]) = std::int32_t(s);
        Mesh& mesh = fit_.kept.mesh;
        for (const MatchedSegment& segment : surface_.segments) {
            if (new_index_[segment.nodes[0].index()] < 0 || new_index_[segment.nodes[1].index()] < 0) continue;
            const std::int32_t old = known.find(segment.nodes[0], segment.nodes[1]);
            mesh.segments.push_back(renamed(segment.nodes));
            mesh.segment_edges.push_back(segment.edge);
            mesh.segment_numbers.push_back(old >= 0 ? mesh_.segment_numbers[std::size_t(old)]
                                                    : mesh.next_element_number++);
        }
    }

    static constexpr std::int32_t to_be_made = -2;
    static NodeId known_mid(std::int32_t mid) { return mid >= 0 ? NodeId(mid) : NodeId(); }

    void take_mids() {
        Kept& kept = fit_.kept;
        Mesh curved = kept.mesh;
        curved.order = 2;
        SideTable mids(curved.corner_count);
        for (std::size_t t = 0; t < kept.tet_origin.size(); ++t) {
            const auto& old = mesh_.tet_mids[std::size_t(kept.tet_origin[t])];
            std::array<NodeId, 6>& own = curved.tet_mids.emplace_back();
            for (int s = 0; s < 6; ++s) {
                std::int32_t& mid = mids.value(curved.tets[t][tet_sides[s][0]], curved.tets[t][tet_sides[s][1]]);
                if (is_moved_[old[s].index()]) {
                    mid = to_be_made;
                } else if (mid < 0) {
                    mid = std::int32_t(curved.node_count());
                    append_node(curved, old[s].index());
                    if (curved.entities.back().dim == 3) curved.entities.back() = entity_of(curved.tet_solids[t]);
                }
                own[s] = known_mid(mid);
            }
        }
        for (const auto& n : curved.triangles)
            curved.triangle_mids.push_back(
                {known_mid(mids.find(n[0], n[1])), known_mid(mids.find(n[1], n[2])), known_mid(mids.find(n[2], n[0]))});
        drop_bare_segments(curved, mids);
        kept.mesh.segments = curved.segments;
        kept.mesh.segment_edges = curved.segment_edges;
        kept.mesh.segment_numbers = curved.segment_numbers;
        kept.mesh.next_element_number = curved.next_element_number;
        kept.curved = std::make_shared<const Mesh>(std::move(curved));
    }

    // A segment whose tets have all gone has no mid-side node any more.
    static void drop_bare_segments(Mesh& mesh, const SideTable& mids) {
        std::size_t left = 0;
        for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
            const std::int32_t mid = mids.find(mesh.segments[s][0], mesh.segments[s][1]);
            if (mid == -1) continue;
            mesh.segments[left] = mesh.segments[s];
            mesh.segment_edges[left] = mesh.segment_edges[s];
            mesh.segment_numbers[left++] = mesh.segment_numbers[s];
            mesh.segment_mids.push_back(known_mid(mid));
        }
        mesh.segments.resize(left), mesh.segment_edges.resize(left), mesh.segment_numbers.resize(left);
    }

    const Brep& brep_;
    Mesh mesh_;
    RunContext& context_;
    ForeignSurface surface_;
    std::vector<char> is_released_, is_moved_;
    std::vector<SolidId> solid_of_;
    std::vector<std::int32_t> new_index_;
    std::size_t inverted_ = 0, outside_ = 0;
    ForeignFit fit_;
};

}  // namespace

ForeignFit fit_to_shape(const Brep& brep, Mesh foreign, int layers, RunContext& context) {
    RunContext::Step step(context, "keep");
    return Fitter(brep, std::move(foreign), context).run(layers);
}

}  // namespace featuremesh
