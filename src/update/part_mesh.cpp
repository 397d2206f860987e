// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/part_mesh.h"

#include <Standard_Failure.hxx>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "cells/cells_after_edit.h"
#include "core/errors.h"
#include "core/numbers_in_words.h"
#include "difference/volume_faces.h"
#include "mesh/tets_at_nodes.h"
#include "mesh/validation.h"
#include "sizing/lost_sizes.h"
#include "surface/mid_side_nodes.h"
#include "surface/turned_triangles.h"
#include "update/adopted_sizes.h"
#include "update/foreign_fit.h"
#include "update/keep.h"
#include "update/thin_tets.h"
#include "update/too_coarse.h"

namespace featuremesh {

namespace {

constexpr double elements_that_bend = 2;          // across a wall: none may span it
// What is changed reaches this much further than it must, in the smallest wanted edge lengths, and at least in global sizes: a detail with tiny
// elements anywhere in the part is no reason to look that closely at all that changed.
constexpr double resolution_of_changes = 0.5, coarsest_resolution_needed = 0.05;

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

void refuse_too_many(const Brep& brep, const SizingField& sizing, const MeshOptions& options, const RunContext& context) {
    if (10 * brep.volume() < options.most_tets * std::pow(sizing.smallest(), 3)) return;   // however the sizes are spread
    const double tets = estimate_tets(brep, sizing, context);
    if (tets > options.most_tets)
        throw InputError("A size of " + in_words(options.sizing.size) + " mm would make about " +
                         std::to_string(std::llround(tets / 1e6)) + " million tets; at most " +
                         std::to_string(std::llround(options.most_tets / 1e6)) + " million are made. Choose a larger size.");
}

Expectation expectation_of(const Brep& brep) {
    Expectation expected;
    for (std::size_t s = 0; s < brep.solid_count(); ++s) expected.solid_volumes.push_back(brep.volume_of(SolidId(s)));
    for (std::size_t f = 0; f < brep.face_count(); ++f) expected.face_sides.push_back(brep.sides_of(FaceId(f)));
    // Chords cut curved faces; how much is the judgement of the surface module, so only gross errors count here.
    expected.volume_tolerance = 0.3;
    return expected;
}

/// Marks the nodes around which something is new or gone; none when nothing was kept. The tets at them are those at the
/// rim and the new ones, as long as none at the rim was released.
void mark_unproven(const Mesh& mesh, Kept kept, std::size_t first_new_tet, const std::vector<std::array<NodeId, 4>>& released,
                   Expectation& expected) {
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

void validate(const Mesh& mesh, const Brep& brep, Kept kept, std::size_t first_new_tet, const std::vector<std::array<NodeId, 4>>& released,
              RunContext& context) {
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

struct Filled {
    Mesh mesh;
    SurfaceReport surface;
    VolumeReport volume;
    std::vector<TetId> released;
    std::vector<NodeId> moved;
    std::vector<Vec3> used_active;
};

/// `second.shorter` tells where 10-node tets need shorter edges; without a valid mesh the result is empty.
Filled fill_volume(const Brep& brep, const SizingField& sizing, SurfaceResult surface, Kept kept, const MeshOptions& options, SecondOrder& second,
                   RunContext& context) {
    const std::size_t kept_tets = surface.mesh.tets.size();
    if (!kept.is_rim.empty()) widen_rim(surface.mesh, surface.kept.triangles, kept);
    VolumeOptions volume_options = options.volume;
    volume_options.is_for_curved_tets = options.order == 2;
    volume_options.splits_wall_tets |= options.sizing.elements_across_gap >= elements_that_bend;
    VolumeResult volume = fill_solids(brep, sizing, std::move(surface.mesh), kept.active, volume_options, context, {kept.is_rim, kept.rim_tets, surface.kept.nodes});
    Mesh mesh = std::move(volume.mesh);
    if (options.order == 2) {
        second = try_second_order(brep, std::move(mesh), kept.curved.get(), context);
        if (!second.is_valid()) return {};
        mesh = std::move(second.mesh);
    }
    validate(mesh, brep, std::move(kept), kept_tets - volume.released.size(), volume.released_nodes, context);
    return {std::move(mesh), std::move(surface.report), std::move(volume.report), std::move(volume.released), std::move(volume.moved), std::move(volume.used_active)};
}

/// Where tets cannot be made to meet a narrow face whose edges have their nodes opposite one another, other chains may do.
Filled fill_once(const Brep& brep, const SizingField& sizing, Kept kept, const MeshOptions& options, SecondOrder& second, RunContext& context) {
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

/// A whole mesh that is too coarse to follow the part is made again with shorter edges there. What an update keeps is not worth a copy for that: it
/// keeps less, and in the end nothing.
Filled fill_following(const Brep& brep, SizingField sizing, std::vector<SizeSource> shorter, Kept kept, const MeshOptions& options, SecondOrder& second,
                      RunContext& context) {
    constexpr int attempts = 4;
    std::set<std::string> places;
    for (int attempt = 1; kept.mesh.points.empty(); ++attempt) {
        try {
            Filled filled = fill_once(brep, sizing, kept, options, second, context);
            for (const std::string& place : places)
                filled.surface.warnings.push_back("The mesh is finer than asked at " + place + ", because elements of that size cannot follow the part there.");
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
            filled->surface.warnings.push_back("The mesh is finer than asked at " + place +
                                               ", because 10-node tets of that size would be folded, or nearly so, by the curved face.");
    }
};

/// Where 10-node tets would be folded whatever is done to them, everything that is not kept is filled again with shorter edges there; when that fails
/// in turn, with other lengths. Twice at most where they are valid, but miss the aim: the best filling counts.
Filled fill_and_check(const Brep& brep, const SizingField& sizing, Kept kept, MeshOptions options, RunContext& context) {
    constexpr int attempts = 6, most_valid = 3;
    SecondOrder second;
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
            if (best.filled && (valid == most_valid || second.shorter.empty() || attempt == attempts)) return std::move(*best.filled);
            first_of_last = shorter.size();
            for (const SizeSource& source : second.shorter) shorter.push_back(shorter_than_asked(field, source));
            places.insert(second.place);
            // what is best for straight tets may leave curved ones no room
            options.volume.moves_surface_nodes = !best.filled;
        } catch (const MeshError&) {
            context.check_cancelled();
            if (attempt == 1) throw;
            if (best.filled) return std::move(*best.filled);
            const double factor = ++failures % 2 == 1 ? 1.5 : 0.4;   // milder first, then stronger
            for (std::size_t i = first_of_last; i < shorter.size(); ++i) shorter[i].size *= factor;
        }
        if (attempt == attempts)
            throw MeshError("10-node tets would be folded near " + *places.begin() + ", with shorter edges there, too, in " +
                            std::to_string(attempts - 1) + " attempts: the face bends too much within one element. Ask for a smaller size there, or for "
                            "4-node tets.");
        field = make_sizing(brep, options.sizing, shorter, context);
    }
}

Kept nothing_kept(NextNumbers next) {
    Kept nothing;
    nothing.mesh.next_node_number = next.node;
    nothing.mesh.next_element_number = next.element;
    return nothing;
}

std::string first_line(const char* text) { return std::string(text).substr(0, std::string(text).find('\n')); }

/// What the libraries throw becomes one of our errors.
template <class Work>
auto with_our_errors(Work work) {
    const std::string advice = ". Try another size, or check the shape (Part: Check geometry).";
    try {
        return work();
    } catch (const Error&) {
        throw;
    } catch (const Standard_Failure& failure) {
        throw KernelError("The geometry kernel failed while meshing: " + first_line(failure.GetMessageString()) + advice);
    } catch (const std::bad_alloc&) {
        throw MeshError("There is not enough memory for this mesh. Choose a larger size.");
    } catch (const std::exception& failure) {
        throw MeshError("The part could not be filled: " + first_line(failure.what()) + advice);
    }
}

/// The one operation: fills whatever is not meshed yet.
Filled fill(const Brep& brep, const SizingField& sizing, Kept kept, const MeshOptions& options, RunContext& context) {
    return with_our_errors([&] { return fill_and_check(brep, sizing, std::move(kept), options, context); });
}

void record_mesh(const Mesh& mesh, const SizingField& sizing, const MeshOptions& options, RunContext& context, Report& report) {
    const RunContext::Step step(context, "measure");
    report.nodes = mesh.node_count();
    report.tets = mesh.tets.size();
    report.order = options.order;
    report.size = options.sizing.size;
    report.quality = measure_quality(mesh, context);
    report.lengths = measure_size_conformity(mesh, sizing);
    for (const std::string& line : warnings_of_thin_tets(mesh, report.quality)) report.warnings.push_back(line);
}

void record_fill(const Filled& filled, Report& report) {
    report.surface = filled.surface;
    report.volume = filled.volume;
    report.warnings.insert(report.warnings.end(), filled.surface.warnings.begin(), filled.surface.warnings.end());
    report.warnings.insert(report.warnings.end(), filled.volume.warnings.begin(), filled.volume.warnings.end());
}

void record_run(const PartState& part, const MeshOptions& options, const RunContext& context, double total, Report& report) {
    for (const std::string& line : lost_sizes(part.brep, options.sizing)) report.warnings.push_back(line);
    report.seconds = context.seconds();
    for (const char* step : {"read", "cells", "difference", "keep", "surface", "volume", "optimise", "validate", "measure"})
        report.seconds.try_emplace(step, 0.0);
    report.seconds["engine_total"] = total;
    report.peak_memory_mb = peak_memory_mb();
    report.warnings.insert(report.warnings.end(), part.tree.notes.begin(), part.tree.notes.end());
    for (const auto& lines : {part.cells.report.fallbacks, part.cells.report.findings})
        report.warnings.insert(report.warnings.end(), lines.begin(), lines.end());
}

std::string listed(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : ", ") + line;
    return text;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::int32_t> extended(std::vector<std::int32_t> origins, std::size_t count) {
    origins.resize(count, -1);
    return origins;
}

std::vector<std::int32_t> without(const std::vector<std::int32_t>& origins, const std::vector<TetId>& released) {
    std::vector<char> gone(origins.size(), 0);
    for (const TetId t : released) gone[t.index()] = 1;
    std::vector<std::int32_t> left;
    for (std::size_t t = 0; t < origins.size(); ++t)
        if (!gone[t]) left.push_back(origins[t]);
    return left;
}

/// Kept corner nodes stay in front; kept mid-side nodes are found by their numbers, which are never given twice.
std::vector<std::int32_t> node_origins(const Mesh& old, const Filled& filled, const std::vector<std::int32_t>& corners, const RunContext& context) {
    const Mesh& mesh = filled.mesh;
    std::vector<std::int32_t> origins = extended(corners, mesh.node_count());
    for (const NodeId n : filled.moved) origins[n.index()] = -1;
    if (old.order == 1 || mesh.order == 1) return origins;
    std::vector<std::pair<Number, std::int32_t>> of_number;
    for (std::size_t n = old.corner_count; n < old.node_count(); ++n) of_number.emplace_back(old.node_numbers[n], std::int32_t(n));
    if (!std::is_sorted(of_number.begin(), of_number.end())) std::sort(of_number.begin(), of_number.end());
    RoundWatch watch(context);
    auto it = of_number.begin();
    for (std::size_t n = mesh.corner_count; n < mesh.node_count(); ++n) {
        watch();
        const Number number = mesh.node_numbers[n];
        if (it == of_number.end() || it->first != number)   // kept ones are in their old order, as a rule
            it = std::lower_bound(of_number.begin(), of_number.end(), std::pair<Number, std::int32_t>{number, 0});
        if (it != of_number.end() && it->first == number) origins[n] = it++->second;
    }
    return origins;
}

void record_kept(const PartMesh& now, const std::vector<KeptByMotion>& by_motion, Report& report) {
    const auto share = [](const std::vector<std::int32_t>& origin) {
        const auto kept = std::count_if(origin.begin(), origin.end(), [](std::int32_t o) { return o >= 0; });
        return origin.empty() ? 0.0 : double(kept) / double(origin.size());
    };
    report.kept = by_motion;
    report.kept_nodes_share = share(now.node_origin);
    report.kept_tets_share = share(now.tet_origin);
    report.active_nodes = now.active_points.size();
}

/// The document is the same to the last bit, and so is its mesh.
PartMeshResult unchanged(const PartMesh& old, RunContext& context) {
    const auto start = std::chrono::steady_clock::now();
    PartMeshResult result;
    Report& report = result.report;
    report.difference = compare(old.part, old.part, old.sizing.smallest(), context);
    auto now = std::make_shared<PartMesh>(old);
    std::iota(now->node_origin.begin(), now->node_origin.end(), 0);
    std::iota(now->tet_origin.begin(), now->tet_origin.end(), 0);
    now->active_points.clear();
    const double total = seconds_since(start);
    record_mesh(old.mesh, old.sizing, old.options, context, report);
    record_kept(*now, {{RigidMotion{}, report.difference.regions[0].features, now->node_origin.size(), now->tet_origin.size()}}, report);
    record_run(now->part, now->options, context, total, report);
    result.part_mesh = std::move(now);
    return result;
}

/// What of the old mesh may be kept, or why nothing can.
std::string reason_for_full_mesh(const PartMesh& old, const MeshOptions& options) {
    if (old.options.order != options.order) return "the element order changed";
    const double ratio = options.sizing.size / old.options.sizing.size;
    if (std::max(ratio, 1 / ratio) > 1.2) return "the global size changed by more than 1.2 times";
    if (options.sizing.elements_across_gap >= elements_that_bend && old.options.sizing.elements_across_gap < elements_that_bend)
        return "elements may not span thin walls any more";
    return {};
}

FeatureTree interpreted(const RawDocument& document, RunContext& context, const FeatureTree* known) {
    const RunContext::Step step(context, "read");
    return interpret(document, context, known);
}

void leave_cells_out(PartState& part) {
    part.cells = cells_without_fuse(part.tree, part.brep);
    part.cells.owners_of_final_face = VolumeFaces(part.tree).owners_of_faces(part.brep);
}

PartState with_cells(FeatureTree tree, RunContext& context, const PartState* before, double seconds) {
    const RunContext::Step step(context, "cells");
    Brep brep(tree.final_shape);
    std::optional<CellModel> cells;
    if (before) cells = cells_after_edit({before->tree, before->cells}, tree, brep, context);
    if (!cells) cells = build_cells(tree, brep, context, seconds);
    return {std::move(tree), std::move(brep), std::move(*cells)};
}

double resolution(const SizingField& sizing, const MeshOptions& options) {
    return std::max(resolution_of_changes * sizing.smallest(), coarsest_resolution_needed * options.sizing.size);
}

/// Where sizes change along a seam, the tets that have to change with them need more room.
double margin_of(const MeshOptions& options, const SizingField& sizing) {
    if (options.keep_margin > 0) return options.keep_margin;
    return sizing.is_uniform() ? 0.9 : 1.5;
}

/// The share of the part that is not kept.
double share_to_fill(const Kept& kept, const Mesh& old) {
    return 1 - double(kept.tet_origin.size()) / double(std::max<std::size_t>(1, old.tets.size()));
}

}  // namespace

PartState read_part(const RawDocument& document, RunContext& context, const FeatureTree* known) {
    return with_cells(interpreted(document, context, known), context, nullptr, most_seconds_of_cells);
}

PartState read_part_to_mesh(const RawDocument& document, RunContext& context, const PartState* before, double seconds) {
    PartState part = with_cells(interpreted(document, context, before ? &before->tree : nullptr), context, before, seconds);
    if (!part.cells.report.is_out_of_time) return part;
    const RunContext::Step step(context, "cells");
    leave_cells_out(part);
    part.cells.report.fallbacks = {"the volumes of the features take too long to fuse; who owns a face was found by points on it"};
    return part;
}

PartState read_part_unfused(const RawDocument& document, RunContext& context, const FeatureTree* known) {
    FeatureTree tree = interpreted(document, context, known);
    const RunContext::Step step(context, "cells");
    Brep brep(tree.final_shape);
    PartState part{std::move(tree), std::move(brep), {}};
    leave_cells_out(part);
    return part;
}

PartMeshResult mesh_part(RawDocument document, const MeshOptions& options, RunContext& context, NextNumbers next) {
    const auto start = std::chrono::steady_clock::now();
    PartState part = read_part_to_mesh(document, context);
    const SizingField sizing = make_sizing(part.brep, options.sizing, {}, context);
    refuse_too_many(part.brep, sizing, options, context);
    Filled filled = fill(part.brep, sizing, nothing_kept(next), options, context);
    const double total = seconds_since(start);
    PartMeshResult result;
    record_mesh(filled.mesh, sizing, options, context, result.report);
    record_fill(filled, result.report);
    record_run(part, options, context, total, result.report);
    const std::size_t nodes = filled.mesh.node_count(), tets = filled.mesh.tets.size();
    result.part_mesh = std::make_shared<const PartMesh>(PartMesh{std::move(part), std::move(document), options, sizing, std::move(filled.mesh),
                                                                 std::vector<std::int32_t>(nodes, -1), std::vector<std::int32_t>(tets, -1), {}});
    return result;
}

PartMeshResult update_part(const PartMesh& old, RawDocument document, const MeshOptions& options, RunContext& context) {
    const auto start = std::chrono::steady_clock::now();
    if (options == old.options && document == old.document) return unchanged(old, context);
    PartState part = read_part_to_mesh(document, context, &old.part);
    const std::string why_full = reason_for_full_mesh(old, options);
    const std::vector<SizeSource> adopted_sizes = why_full.empty() ? old.adopted_sizes : std::vector<SizeSource>{};
    const SizingField sizing = make_sizing(part.brep, options.sizing, adopted_sizes, context);
    refuse_too_many(part.brep, sizing, options, context);

    PartMeshResult result;
    Report& report = result.report;
    const double smallest_margin = margin_of(options, sizing);
    std::vector<double> margins{smallest_margin, 2 * smallest_margin};
    try {
        report.difference = with_our_errors([&] { return compare(old.part, part, resolution(sizing, options), context); });
        part.cells.owners_of_final_face = report.difference.owners_of_new_face;
    } catch (const Error& failure) {
        context.check_cancelled();
        report.fallbacks.push_back(std::string("full mesh: what changed could not be found: ") + failure.what());
        margins.clear();
        part = read_part_to_mesh(document, context);
    }
    if (!why_full.empty()) {
        report.fallbacks.push_back("full mesh: " + why_full);
        margins.clear();
    }
    std::vector<std::int32_t> node_origin, tet_origin;
    std::optional<Filled> filled;
    double share_tried = 0;   // of the part, by all attempts
    std::string why_nothing = "full mesh: nothing could be kept";
    for (const double margin : margins) {
        try {
            Kept kept = with_our_errors([&] {
                return keep({old.mesh, old.part.brep, part.brep, report.difference, old.sizing, sizing, old.made_for, margin, old.options.sizing == options.sizing}, context);
            });
            const double share = share_to_fill(kept, old.mesh);
            if (share_tried > 0 && share_tried + share > 1) {
                why_nothing = "full mesh: keeping still less would take longer than meshing the part anew";
                break;
            }
            share_tried += share;
            node_origin = kept.node_origin;
            tet_origin = kept.tet_origin;
            const std::vector<KeptByMotion> by_motion = kept.by_motion;
            if (node_origin.empty()) report.fallbacks.push_back("full mesh: no element of the old mesh is clear of what changed");
            filled = fill(part.brep, sizing, std::move(kept), options, context);
            report.kept = by_motion;
            break;
        } catch (const Error& failure) {
            context.check_cancelled();
            report.fallbacks.push_back("keeping everything further than " + in_words(margin) + " edge lengths from the change failed: " +
                                       failure.what());
        }
    }
    if (!filled) {
        if (!margins.empty()) report.fallbacks.push_back(why_nothing);
        node_origin.clear(), tet_origin.clear();
        filled = fill(part.brep, sizing, nothing_kept({old.mesh.next_node_number, old.mesh.next_element_number}), options, context);
    }
    const double total = seconds_since(start);
    record_mesh(filled->mesh, sizing, options, context, report);
    record_fill(*filled, report);
    node_origin = node_origins(old.mesh, *filled, node_origin, context);
    tet_origin = extended(without(tet_origin, filled->released), filled->mesh.tets.size());
    MadeFor sizes = made_for(filled->mesh, sizing, {old.mesh, old.sizing, old.made_for}, node_origin);
    auto now = std::make_shared<PartMesh>(PartMesh{std::move(part), std::move(document), options, sizing, std::move(filled->mesh), std::move(node_origin),
                                                   std::move(tet_origin), std::move(filled->used_active), std::move(sizes), adopted_sizes});
    record_kept(*now, report.kept, report);
    record_run(now->part, now->options, context, total, report);
    result.part_mesh = std::move(now);
    return result;
}

PartMeshResult adopt_part(RawDocument document, const MeshOptions& options, const Mesh& foreign, RunContext& context) {
    const auto start = std::chrono::steady_clock::now();
    if (options.order != foreign.order) throw InputError("An adopted mesh keeps its element order.");
    PartState part = read_part_to_mesh(document, context);
    const std::vector<SizeSource> adopted_sizes = local_sizes(foreign, options.sizing.size);
    const SizingField sizing = make_sizing(part.brep, options.sizing, adopted_sizes, context);
    refuse_too_many(part.brep, sizing, options, context);
    PartMeshResult result;
    Report& report = result.report;
    std::vector<std::int32_t> node_origin, tet_origin;
    std::optional<Filled> filled;
    for (const int more_layers : {0, 2}) {
        ForeignFit fit = fit_to_shape(part.brep, foreign, more_layers, context);
        node_origin = fit.kept.node_origin;
        tet_origin = fit.kept.tet_origin;
        const std::vector<KeptByMotion> by_motion = fit.kept.by_motion;
        if (more_layers == 0 && fit.released_tets > 0)
            report.fallbacks.push_back(std::to_string(fit.released_tets) + " of " + std::to_string(foreign.tets.size()) +
                                       " elements do not fit the part and were made anew: " + listed(fit.reasons));
        if (more_layers == 0 && fit.moved_mids > 0)
            report.fallbacks.push_back(std::to_string(fit.moved_mids) + " mid-side nodes were off the surface and are new, on it");
        try {
            filled = fill(part.brep, sizing, std::move(fit.kept), options, context);
            report.kept = by_motion;
            break;
        } catch (const Error& failure) {
            context.check_cancelled();
            report.fallbacks.push_back(std::string("keeping all that fits failed: ") + failure.what());
        }
    }
    if (!filled) {
        report.fallbacks.push_back("full mesh: nothing could be kept");
        node_origin.clear(), tet_origin.clear();
        filled = fill(part.brep, sizing, nothing_kept({foreign.next_node_number, foreign.next_element_number}), options, context);
    }
    const double total = seconds_since(start);
    record_mesh(filled->mesh, sizing, options, context, report);
    record_fill(*filled, report);
    node_origin = node_origins(foreign, *filled, node_origin, context);
    tet_origin = extended(without(tet_origin, filled->released), filled->mesh.tets.size());
    auto now = std::make_shared<PartMesh>(PartMesh{std::move(part), std::move(document), options, sizing, std::move(filled->mesh),
                                                   std::move(node_origin), std::move(tet_origin), {}, {}, adopted_sizes});
    record_kept(*now, report.kept, report);
    record_run(now->part, now->options, context, total, report);
    result.part_mesh = std::move(now);
    return result;
}

std::shared_ptr<const PartMesh> restore_part(RawDocument document, const MeshOptions& options, Mesh mesh, RunContext& context,
                                             MadeFor made_for, std::vector<SizeSource> adopted_sizes) {
    PartState part = read_part_unfused(document, context);
    const std::vector<std::string> broken = broken_invariants(mesh, expectation_of(part.brep), context);
    if (!broken.empty()) throw StateError("The saved mesh does not fit the part: " + broken.front() + ".");
    const SizingField sizing = make_sizing(part.brep, options.sizing, adopted_sizes, context);
    const std::size_t nodes = mesh.node_count(), tets = mesh.tets.size();
    return std::make_shared<const PartMesh>(PartMesh{std::move(part), std::move(document), options, sizing, std::move(mesh),
                                                     std::vector<std::int32_t>(nodes, -1), std::vector<std::int32_t>(tets, -1), {}, std::move(made_for), std::move(adopted_sizes)});
}

}  // namespace featuremesh
