// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/kept_mesh.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/ids.h"
#include "core/run_context.h"
#include "difference/feature_difference.h"
#include "mesh/mesh.h"
#include "update/solids_beside.h"

namespace featuremesh {

namespace {
constexpr double sure_of_side = 0.5;  // of the sum of cosines between triangles and their face

class Assembler {
  public:
    Assembler(const CarriedNodes& nodes, const KeptEntities& entities, const KeptTets& tets,
              const KeptSurfaces& surfaces, const KeptShells* shells, RunContext& context)
        : nodes_(nodes),
          in_(nodes.input),
          entities_(entities),
          tets_(tets),
          surfaces_(surfaces),
          shells_(shells),
          context_(context) {}

    Kept run() {
        Kept kept;
        reserve(kept);
        context_.check_cancelled();
        const std::vector<std::int32_t> new_index = take_nodes(kept);
        take_tets(kept, new_index);
        context_.check_cancelled();
        take_triangles(kept, new_index);
        mark_changed_solids(kept);
        take_segments(kept, new_index);
        kept.rim_tets = tets_.tets_at(kept.mesh, kept.is_rim, kept.node_origin);
        kept.mesh.next_node_number = in_.old_mesh.next_node_number;
        kept.mesh.next_element_number = in_.old_mesh.next_element_number;
        if (in_.old_mesh.order == 2) kept.curved = std::make_shared<const Mesh>(with_mid_side_nodes(kept));
        count_by_motion(kept);
        kept.merged = entities_.merged();
        return kept;
    }

  private:
    // Nearly everything is kept, as a rule, and some is added.
    void reserve(Kept& kept) const {
        Mesh& mesh = kept.mesh;
        const auto most = [](std::size_t count) { return count + count / 16 + 1024; };
        const std::size_t nodes = most(in_.old_mesh.corner_count), triangles = most(in_.old_mesh.triangles.size()),
                          tets = most(in_.old_mesh.tets.size());
        mesh.points.reserve(nodes), mesh.entities.reserve(nodes), mesh.parameters.reserve(nodes),
            mesh.node_numbers.reserve(nodes);
        mesh.triangles.reserve(triangles), mesh.triangle_faces.reserve(triangles),
            mesh.triangle_numbers.reserve(triangles);
        mesh.tets.reserve(tets), mesh.tet_solids.reserve(tets), mesh.tet_numbers.reserve(tets);
        kept.node_origin.reserve(nodes), kept.triangle_origin.reserve(triangles), kept.tet_origin.reserve(tets),
            kept.is_rim.reserve(nodes);
    }

    std::vector<std::int32_t> take_nodes(Kept& kept) const {
        const Mesh& old = in_.old_mesh;
        Mesh& mesh = kept.mesh;
        std::vector<std::int32_t> new_index(nodes_.motions.size(), -1);
        for (std::size_t n = 0; n < old.corner_count; ++n) {
            if (!tets_.has_kept_tet(n) && !surfaces_.has_kept(n) && !(shells_ && shells_->has_kept(n))) continue;
            new_index[n] = std::int32_t(kept.node_origin.size());
            kept.node_origin.push_back(std::int32_t(n));
        }
        const std::size_t count = kept.node_origin.size();
        mesh.points.resize(count), kept.is_rim.resize(count);
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t origin = std::size_t(kept.node_origin[n]);
            mesh.points[n] = nodes_.at(origin);
            kept.is_rim[n] = tets_.is_rim(origin);
        }
        take(mesh.entities, entities_.entities(), kept.node_origin);
        take(mesh.parameters, entities_.parameters(), kept.node_origin);
        take(mesh.node_numbers, std::span(old.node_numbers), kept.node_origin);
        for (std::size_t n = 0; n < mesh.entities.size(); ++n)
            if (Entity& entity = mesh.entities[n]; entity.dim == 3)
                entity = entity_of(
                    tets_.solid_of_group(SolidId(entity.index), nodes_.motions[std::size_t(kept.node_origin[n])]));
        mesh.corner_count = mesh.points.size();
        return new_index;
    }

    template <class T>
    static void take(std::vector<T>& list, std::span<const T> old, const std::vector<std::int32_t>& origins) {
        list.resize(origins.size());
        for (std::size_t i = 0; i < origins.size(); ++i) list[i] = old[std::size_t(origins[i])];
    }

    // From one tet that does not stay to the next.
    void take_tets(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        std::size_t begin = 0;
        for (const std::int32_t end : tets_.dropped_tets()) {
            take_run(begin, std::size_t(end), kept, new_index);
            begin = std::size_t(end) + 1;
        }
        take_run(begin, in_.old_mesh.tets.size(), kept, new_index);
        if (const SolidId solid = tets_.only_solid(); solid.is_valid())
            kept.mesh.tet_solids.assign(kept.tet_origin.size(), solid);
        else
            for (const std::int32_t t : kept.tet_origin) kept.mesh.tet_solids.push_back(tets_.solid_of(std::size_t(t)));
        if (tets_.is_uniform()) return;
        for (std::size_t t = 0; t < kept.mesh.tets.size(); ++t)
            for (const NodeId n : kept.mesh.tets[t])
                if (Entity& entity = kept.mesh.entities[n.index()]; entity.dim == 3)
                    entity = entity_of(kept.mesh.tet_solids[t]);
    }

    void take_run(std::size_t begin, std::size_t end, Kept& kept, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        Mesh& mesh = kept.mesh;
        const auto place = [index = new_index.data()](NodeId n) { return NodeId(index[n.index()]); };
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c, d] = old.tets[t];
            mesh.tets.push_back({place(a), place(b), place(c), place(d)});
            kept.tet_origin.push_back(std::int32_t(t));
        }
        mesh.tet_numbers.insert(mesh.tet_numbers.end(), old.tet_numbers.begin() + std::ptrdiff_t(begin),
                                old.tet_numbers.begin() + std::ptrdiff_t(end));
    }

    // A face may have a solid beside it where it had none.
    void mark_changed_solids(Kept& kept) const {
        const std::vector<char> was = counts_of_solids_beside(in_.old_brep), is = counts_of_solids_beside(in_.new_brep);
        for (std::size_t t = 0; t < kept.triangle_origin.size(); ++t) {
            const FaceId old_face = in_.old_mesh.triangle_faces[std::size_t(kept.triangle_origin[t])];
            if (was[old_face.index()] == is[kept.mesh.triangle_faces[t].index()]) continue;
            for (const NodeId n : kept.mesh.triangles[t]) kept.is_rim[n.index()] = 1;
        }
    }

    template <std::size_t N>
    bool survives(const std::array<NodeId, N>& nodes, const std::vector<std::int32_t>& new_index) const {
        for (const NodeId n : nodes)
            if (new_index[n.index()] < 0 || nodes_.motions[n.index()] != nodes_.motions[nodes[0].index()]) return false;
        return true;
    }

    // Do the triangles of the face of the `first` lie the other way round in the new one? A coarse triangle on a round
    // face may stand across it, so others are asked until it is sure that they do not. Where a node lies inside the
    // face its parameters are known; elsewhere they would be searched for in all of it.
    bool are_flipped(std::size_t first, FaceId face, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        const std::size_t r = nodes_.motion_of(old.triangles[first][0]);
        double sum = 0;
        for (const bool is_told : {true, false})
            for (std::size_t t = first; t < old.triangles.size() && old.triangle_faces[t] == old.triangle_faces[first];
                 ++t) {
                if (sum > sure_of_side) return false;
                if (survives(old.triangles[t], new_index) && nodes_.motion_of(old.triangles[t][0]) == r &&
                    entities_.has_node_inside(t, face) == is_told)
                    sum += entities_.cosine_to(face, t);
            }
        return sum < 0;
    }

    void take_triangles(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        std::vector<char> backed = backed_by_kept_tets(new_index);
        if (shells_) mark_shells(backed);
        std::map<std::tuple<std::size_t, FaceId, FaceId>, bool> flipped;
        auto flip = flipped.end();
        for (std::size_t t = 0; t < old.triangles.size(); ++t) {
            const auto& nodes = old.triangles[t];
            if (!(backed[t] || surfaces_.is_kept(t)) || !survives(nodes, new_index)) continue;
            const std::size_t r = nodes_.motion_of(nodes[0]);
            const FaceId old_face = old.triangle_faces[t], face = entities_.face_of(t);
            if (!face.is_valid() || !in_.new_brep.is_meshed(face)) {
                for (const NodeId n : nodes) kept.is_rim[std::size_t(new_index[n.index()])] = 1;
                continue;
            }
            if (flip == flipped.end() ||
                flip->first != std::tuple{r, old_face, face}) {  // most triangles are on the face of the one before
                bool is_new = false;
                std::tie(flip, is_new) = flipped.try_emplace({r, old_face, face}, false);
                if (is_new) flip->second = are_flipped(t, face, new_index);
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

    void mark_shells(std::vector<char>& backed) const {
        for (std::size_t t = 0; t < backed.size(); ++t)
            if (in_.old_brep.is_free(in_.old_mesh.triangle_faces[t])) backed[t] = shells_->is_kept(t);
    }

    // A triangle stays with the tet behind it: the cavity's boundary is then where kept tets end. Around a node off the
    // rim all tets are kept, so only triangles between rim nodes need a look.
    std::vector<char> backed_by_kept_tets(const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        const auto is_rim = [&](NodeId n) { return tets_.is_rim(n.index()) && new_index[n.index()] >= 0; };
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
        for (const std::int32_t tet : tets_.tets_at_rim()) {
            const auto& nodes = old.tets[std::size_t(tet)];
            if (is_rim(nodes[0]) + is_rim(nodes[1]) + is_rim(nodes[2]) + is_rim(nodes[3]) < 3) continue;
            for (int skip = 0; skip < 4; ++skip) {
                std::array<NodeId, 3> facet;
                for (int k = 0, j = 0; k < 4; ++k)
                    if (k != skip) facet[std::size_t(j++)] = nodes[std::size_t(k)];
                std::sort(facet.begin(), facet.end());
                const auto it = std::lower_bound(doubtful.begin(), doubtful.end(), facet,
                                                 [](const auto& d, const auto& s) { return d.first < s; });
                if (it != doubtful.end() && it->first == facet) backed[it->second] = 1;
            }
        }
        return backed;
    }

    void take_segments(Kept& kept, const std::vector<std::int32_t>& new_index) const {
        const Mesh& old = in_.old_mesh;
        std::map<std::tuple<std::size_t, EdgeId, EdgeId>, bool> turned;
        for (std::size_t s = 0; s < old.segments.size(); ++s) {
            const auto& nodes = old.segments[s];
            if (!survives(nodes, new_index) || !has_its_mid(s)) continue;
            const EdgeId edge = entities_.edge_of(s);
            if (!edge.is_valid() || !in_.new_brep.is_meshed(edge)) continue;
            std::array<NodeId, 2> segment{NodeId(new_index[nodes[0].index()]), NodeId(new_index[nodes[1].index()])};
            const auto [turn, is_new] =
                turned.try_emplace({nodes_.motion_of(nodes[0]), old.segment_edges[s], edge}, false);
            if (is_new) turn->second = entities_.runs_backwards(s, edge);
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
        return old.order == 1 ||
               nodes_.motions[old.segment_mids[segment].index()] == nodes_.motions[old.segments[segment][0].index()];
    }

    // Which mid-side nodes there are, in the order in which elements have them, is found first; their data after that.
    Mesh with_mid_side_nodes(const Kept& kept) const {
        const Mesh& old = in_.old_mesh;
        Mesh curved = kept.mesh;
        curved.order = 2;
        std::vector<NodeId> new_mid(old.points.size());
        std::vector<std::int32_t> origins;
        std::vector<SolidId> solids;  // of the first tet with it
        origins.reserve(old.points.size() - old.corner_count), solids.reserve(origins.capacity());
        const auto take = [&](NodeId old_mid, SolidId solid) {
            NodeId& mid = new_mid[old_mid.index()];
            if (mid.is_valid()) return mid;
            mid = NodeId(curved.corner_count + origins.size());
            origins.push_back(old_mid.value), solids.push_back(solid);
            return mid;
        };
        RoundWatch watch(context_);
        curved.tet_mids.resize(kept.tet_origin.size());
        for (std::size_t t = 0; t < kept.tet_origin.size(); ++t) {
            watch();
            const auto& mids = old.tet_mids[std::size_t(kept.tet_origin[t])];
            for (std::size_t s = 0; s < 6; ++s) curved.tet_mids[t][s] = take(mids[s], kept.mesh.tet_solids[t]);
        }
        // A triangle or segment may have been turned round: its sides are found again by their corners.
        for (std::size_t t = 0; t < kept.triangle_origin.size(); ++t) {
            auto mids = old.triangle_mids[std::size_t(kept.triangle_origin[t])];
            const auto& corners = old.triangles[std::size_t(kept.triangle_origin[t])];
            const bool turned = kept.node_origin[curved.triangles[t][1].index()] != corners[1].value;
            if (turned) std::swap(mids[0], mids[2]);
            curved.triangle_mids.push_back(
                {take(mids[0], {}), take(mids[1], {}), take(mids[2], {})});  // tets have brought them
        }
        for (const std::int32_t s : kept.segment_origin)
            curved.segment_mids.push_back(take(old.segment_mids[std::size_t(s)], {}));
        append_mids(curved, origins, solids);
        return curved;
    }

    void append_mids(Mesh& curved, const std::vector<std::int32_t>& origins, const std::vector<SolidId>& solids) const {
        const std::size_t first = curved.corner_count, count = first + origins.size();
        curved.points.resize(count), curved.entities.resize(count);
        curved.parameters.resize(count), curved.node_numbers.resize(count);
        RoundWatch watch(context_);
        for (std::size_t i = 0; i < origins.size(); ++i) {
            watch();
            const std::size_t n = std::size_t(origins[i]);
            const Entity entity = entities_.entities()[n];
            curved.points[first + i] = nodes_.at(n);
            curved.entities[first + i] = entity.dim == 3 ? entity_of(solids[i]) : entity;
            curved.parameters[first + i] = entities_.parameters()[n];
            curved.node_numbers[first + i] = in_.old_mesh.node_numbers[n];
        }
    }

    void count_by_motion(Kept& kept) const {
        for (const CarriedRegion& region : nodes_.regions()) kept.by_motion.push_back({region.motion, region.features});
        for (const std::int32_t n : kept.node_origin)
            ++kept.by_motion[std::size_t(nodes_.motions[std::size_t(n)])].nodes;
        if (in_.old_mesh.tets.empty()) return count_elements_without_tets(kept);
        const std::vector<std::size_t> counts = tets_.counts();
        for (std::size_t r = 0; r < counts.size(); ++r) kept.by_motion[r].tets = counts[r];
    }

    void count_elements_without_tets(Kept& kept) const {
        const auto count = [&](const auto& elements) {
            for (const auto& nodes : elements) {
                const std::size_t first = std::size_t(kept.node_origin[nodes[0].index()]);
                ++kept.by_motion[std::size_t(nodes_.motions[first])].tets;
            }
        };
        if (!in_.old_mesh.triangles.empty())
            count(kept.mesh.triangles);
        else
            count(kept.mesh.segments);
    }

    const CarriedNodes& nodes_;
    const KeepInput& in_;
    const KeptEntities& entities_;
    const KeptTets& tets_;
    const KeptSurfaces& surfaces_;
    const KeptShells* shells_;
    RunContext& context_;
};

}  // namespace

Kept assemble(const CarriedNodes& nodes, const KeptEntities& entities, const KeptTets& tets,
              const KeptSurfaces& surfaces, const KeptShells* shells, RunContext& context) {
    return Assembler(nodes, entities, tets, surfaces, shells, context).run();
}

}  // namespace featuremesh
