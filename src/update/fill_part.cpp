// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/fill_part.h"

#include <optional>
#include <set>
#include <utility>

#include "core/errors.h"
#include "mesh/tets_at_nodes.h"
#include "surface/mid_side_nodes.h"
#include "surface/turned_triangles.h"
#include "update/too_coarse.h"

namespace featuremesh {

namespace {

/// Marks the nodes around which something is new or gone; none when nothing was kept. The tets at them are those at the
/// rim and the new ones, as long as none at the rim was released.
void mark_unproven(const Mesh& mesh, Kept kept, std::size_t first_new_tet,
                   const std::vector<std::array<NodeId, 4>>& released, Expectation& expected) {
    if (kept.is_rim.empty()) return;
    std::vector<char>& unproven = expected.is_unproven = std::move(kept.is_rim);
    unproven.resize(mesh.points.size(), 1);
    bool is_wider = mesh.order == 2 || !released.empty();
    for (std::size_t t = first_new_tet; t < mesh.tets.size(); ++t)
        for (const NodeId n : mesh.tets[t]) is_wider |= !unproven[n.index()], unproven[n.index()] = 1;
    for (const auto& tet : released)
        for (const NodeId n : tet) unproven[n.index()] = 1;
    if (is_wider) return;
    expected.unproven_tets = std::move(kept.rim_tets);
    for (std::size_t t = first_new_tet; t < mesh.tets.size(); ++t) expected.unproven_tets.emplace_back(t);
}

void validate(const Mesh& mesh, const Brep& brep, Kept kept, std::size_t first_new_tet,
              const std::vector<std::array<NodeId, 4>>& released, RunContext& context) {
    RunContext::Step step(context, "validate");
    Expectation expected = expectation_of(brep);
    mark_unproven(mesh, std::move(kept), first_new_tet, released, expected);
    const std::vector<std::string> broken = broken_invariants(mesh, expected, context);
    if (broken.size() == 1)
        if (const std::vector<SolidId> off = solids_off_volume(mesh, brep, expected.volume_tolerance); !off.empty())
            throw off_volume(mesh, brep, off.front(), broken.front());
    if (!broken.empty())
        throw MeshError("The mesh is not valid: " + broken.front() +
                        (broken.size() > 1 ? " (and " + std::to_string(broken.size() - 1) + " more)" : "") + ".");
    const std::vector<TriangleId> turned = turned_triangles(brep, mesh, expected.is_unproven, context);
    if (!turned.empty()) throw turned_over(mesh, turned);
}

/// Nodes of new triangles belong to it, too.
void widen_rim(const Mesh& mesh, std::size_t kept_triangles, Kept& kept) {
    const std::size_t kept_nodes = kept.is_rim.size();
    kept.is_rim.resize(mesh.node_count(), 1);
    bool is_wider = false;
    for (std::size_t t = kept_triangles; t < mesh.triangles.size(); ++t)
        for (const NodeId n : mesh.triangles[t]) {
            char& is_rim = kept.is_rim[n.index()];
            is_wider |= n.index() < kept_nodes && !is_rim;
            is_rim = 1;
        }
    if (is_wider) kept.rim_tets = tets_at_nodes(mesh, kept.is_rim);
}

/// `second.shorter` tells where 10-node tets need shorter edges; without a valid mesh the result is empty.
Filled fill_volume(const Brep& brep, const SizingField& sizing, SurfaceResult surface, Kept kept,
                   const MeshOptions& options, SecondOrder& second, RunContext& context) {
    const std::size_t kept_tets = surface.mesh.tets.size();
    if (!kept.is_rim.empty()) widen_rim(surface.mesh, surface.kept.triangles, kept);
    VolumeOptions volume_options = options.volume;
    volume_options.is_for_curved_tets = options.order == 2;
    volume_options.splits_wall_tets |= options.sizing.elements_across_gap >= elements_that_bend;
    VolumeResult volume = fill_solids(brep, sizing, std::move(surface.mesh), kept.active, volume_options, context,
                                      {kept.is_rim, kept.rim_tets, surface.kept.nodes});
    Mesh mesh = std::move(volume.mesh);
    if (options.order == 2) {
        second = try_second_order(brep, std::move(mesh), kept.curved.get(), context);
        if (!second.is_valid()) return {};
        mesh = std::move(second.mesh);
    }
    validate(mesh, brep, std::move(kept), kept_tets - volume.released.size(), volume.released_nodes, context);
    return {std::move(mesh),         std::move(surface.report),    std::move(volume.report), std::move(volume.released),
            std::move(volume.moved), std::move(volume.used_active)};
}

/// Where tets cannot be made to meet a narrow face whose edges have their nodes opposite one another, other chains may
/// do.
Filled fill_once(const Brep& brep, const SizingField& sizing, Kept kept, const MeshOptions& options,
                 SecondOrder& second, RunContext& context) {
    context.check_cancelled();
    SurfaceOptions surface_options{.known = kept.merged.get()};
    SurfaceResult surface = fill_surface(brep, sizing, std::move(kept.mesh), context, surface_options);
    for (const NarrowFaces next : {NarrowFaces::shorter, NarrowFaces::own_chains}) {
        if (!surface.report.has_opposite_nodes) break;
        try {
            return fill_volume(brep, sizing, surface, kept, options, second, context);
        } catch (const MeshError&) {
            context.check_cancelled();
        }
        surface_options.narrow = next;
        surface = fill_surface(brep, sizing, taken_back(std::move(surface)), context, surface_options);
    }
    return fill_volume(brep, sizing, std::move(surface), std::move(kept), options, second, context);
}

/// A whole mesh that is too coarse to follow the part is made again with shorter edges there. What an update keeps is
/// not worth a copy for that: it keeps less, and in the end nothing.
Filled fill_following(const Brep& brep, SizingField sizing, std::vector<SizeSource> shorter, Kept kept,
                      const MeshOptions& options, SecondOrder& second, RunContext& context) {
    constexpr int attempts = 4;
    std::set<std::string> places;
    for (int attempt = 1; kept.mesh.points.empty(); ++attempt) {
        try {
            Filled filled = fill_once(brep, sizing, kept, options, second, context);
            for (const std::string& place : places)
                filled.surface.warnings.push_back("The mesh is finer than asked at " + place +
                                                  ", because elements of that size cannot follow the part there.");
            return filled;
        } catch (const TooCoarse& coarse) {
            context.check_cancelled();
            if (attempt == attempts) throw;
            for (const SizeSource& source : coarse.shorter) shorter.push_back(shorter_than_asked(sizing, source));
            places.insert(coarse.place);
            sizing = make_sizing(brep, options.sizing, shorter, context);
        }
    }
    return fill_once(brep, sizing, std::move(kept), options, second, context);
}

/// The better of the fillings whose 10-node tets are valid.
struct BestFilling {
    std::optional<Filled> filled;
    double smallest = 0;  ///< scaled Jacobian

    void offer(Filled&& next, double its_smallest, const std::set<std::string>& places) {
        if (filled && its_smallest <= smallest) return;
        filled = std::move(next);
        smallest = its_smallest;
        for (const std::string& place : places)
            filled->surface.warnings.push_back(
                "The mesh is finer than asked at " + place +
                ", because 10-node tets of that size would be folded, or nearly so, by the curved face.");
    }
};

}  // namespace

Expectation expectation_of(const Brep& brep) {
    Expectation expected;
    for (std::size_t s = 0; s < brep.solid_count(); ++s) expected.solid_volumes.push_back(brep.volume_of(SolidId(s)));
    expected.face_sides = brep.sides_of_faces();
    // Chords cut curved faces; how much is the judgement of the surface module, so only gross errors count here.
    expected.volume_tolerance = 0.3;
    return expected;
}

Kept nothing_kept(NextNumbers next) {
    Kept nothing;
    nothing.mesh.next_node_number = next.node;
    nothing.mesh.next_element_number = next.element;
    return nothing;
}

/// Where 10-node tets would be folded whatever is done to them, everything that is not kept is filled again with
/// shorter edges there; when that fails in turn, with other lengths. Twice at most where they are valid, but miss the
/// aim: the best filling counts.
Filled fill_part(const Brep& brep, const SizingField& sizing, Kept kept, MeshOptions options, RunContext& context) {
    constexpr int attempts = 6, most_valid = 3;
    SecondOrder second;
    options.volume.smallest_asked = sizing.smallest();
    if (options.order == 1) return fill_following(brep, sizing, {}, std::move(kept), options, second, context);
    std::vector<SizeSource> shorter;
    std::size_t first_of_last = 0;
    int failures = 0, valid = 0;
    std::set<std::string> places;
    SizingField field = sizing;
    BestFilling best;
    for (int attempt = 1;; ++attempt) {
        try {
            Filled filled = fill_following(brep, field, shorter, kept, options, second, context);
            if (!filled.mesh.tets.empty()) ++valid, best.offer(std::move(filled), second.smallest, places);
            if (best.filled && (valid == most_valid || second.shorter.empty() || attempt == attempts))
                return std::move(*best.filled);
            first_of_last = shorter.size();
            for (const SizeSource& source : second.shorter) shorter.push_back(shorter_than_asked(field, source));
            places.insert(second.place);
            // what is best for straight tets may leave curved ones no room
            options.volume.moves_surface_nodes = !best.filled;
        } catch (const MeshError&) {
            context.check_cancelled();
            if (attempt == 1) throw;
            if (best.filled) return std::move(*best.filled);
            const double factor = ++failures % 2 == 1 ? 1.5 : 0.4;  // milder first, then stronger
            for (std::size_t i = first_of_last; i < shorter.size(); ++i) shorter[i].size *= factor;
        }
        if (attempt == attempts)
            throw MeshError(
                "10-node tets would be folded near " + *places.begin() + ", with shorter edges there, too, in " +
                std::to_string(attempts - 1) +
                " attempts: the face bends too much within one element. Ask for a smaller size there, or for "
                "4-node tets.");
        field = make_sizing(brep, options.sizing, shorter, context);
    }
}

}  // namespace featuremesh
