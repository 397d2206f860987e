// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/part_mesh.h"

#include <sys/resource.h>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "cells/cells_after_edit.h"
#include "core/errors.h"
#include "core/numbers_in_words.h"
#include "difference/volume_faces.h"
#include "features/deadline.h"
#include "mesh/validation.h"
#include "sizing/lost_sizes.h"
#include "surface/mid_side_nodes.h"
#include "update/adopted_sizes.h"
#include "update/fill_part.h"
#include "update/foreign_fit.h"
#include "update/keep.h"
#include "update/thin_tets.h"

namespace featuremesh {

namespace {

// What is changed reaches this much further than it must: in wanted edge lengths there, and at least in the smallest
// ones and in global sizes. A detail with tiny elements anywhere is no reason to look that closely at all that changed.
constexpr double resolution_of_changes = 1.0 / 3, finest_resolution_needed = 0.5, coarsest_resolution_needed = 0.05;
constexpr double least_seconds_beside_mesh = 2, most_seconds_beside_mesh = 5;  // of the processor, for cells

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

void refuse_too_many(const Brep& brep, const SizingField& sizing, const MeshOptions& options,
                     const RunContext& context) {
    if (10 * brep.volume() < options.most_tets * std::pow(sizing.smallest(), 3))
        return;  // however the sizes are spread
    const double tets = estimate_tets(brep, sizing, context);
    if (tets > options.most_tets)
        throw InputError("A size of " + in_words(options.sizing.size) + " mm would make about " +
                         std::to_string(std::llround(tets / 1e6)) + " million tets; at most " +
                         std::to_string(std::llround(options.most_tets / 1e6)) +
                         " million are made. Choose a larger size.");
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
        throw KernelError("The geometry kernel failed while meshing: " + first_line(failure.GetMessageString()) +
                          advice);
    } catch (const std::bad_alloc&) {
        throw MeshError("There is not enough memory for this mesh. Choose a larger size.");
    } catch (const std::exception& failure) {
        throw MeshError("The part could not be filled: " + first_line(failure.what()) + advice);
    }
}

Filled fill(const Brep& brep, const SizingField& sizing, Kept kept, const MeshOptions& options, RunContext& context) {
    return with_our_errors([&] { return fill_part(brep, sizing, std::move(kept), options, context); });
}

/// A mesh from nothing, and with what it was made.
struct Whole {
    MeshOptions options;
    SizingField sizing;
    Filled filled;
};

Whole nothing_filled(const Brep& brep, MeshOptions options, bool refines_narrow_faces,
                     std::span<const SizeSource> adopted_sizes, RunContext& context) {
    options.sizing.refines_narrow_faces = refines_narrow_faces;
    return {options, make_sizing(brep, options.sizing, adopted_sizes, context), {}};
}

void fill_whole(const Brep& brep, NextNumbers next, Whole& whole, RunContext& context) {
    refuse_too_many(brep, whole.sizing, whole.options, context);
    whole.filled = fill(brep, whole.sizing, nothing_kept(next), whole.options, context);
}

/// What cannot be meshed with shorter pieces along narrow faces is meshed without them.
Whole mesh_whole(const Brep& brep, const MeshOptions& options, std::span<const SizeSource> adopted_sizes,
                 NextNumbers next, RunContext& context) {
    Whole whole = nothing_filled(brep, options, true, adopted_sizes, context);
    try {
        fill_whole(brep, next, whole, context);
        return whole;
    } catch (const Error& failure) {
        context.check_cancelled();
        Whole plain = nothing_filled(brep, options, false, adopted_sizes, context);
        if (where_different(plain.sizing, whole.sizing).empty()) throw;
        fill_whole(brep, next, plain, context);
        plain.filled.surface.warnings.push_back(
            std::string("Faces far narrower than the size are meshed at the plain size, since shorter edges failed: ") +
            failure.what());
        return plain;
    }
}

void record_mesh(const Mesh& mesh, const SizingField& sizing, const MeshOptions& options, RunContext& context,
                 Report& report) {
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

void record_run(const PartState& part, const MeshOptions& options, const RunContext& context, double total,
                Report& report) {
    for (const std::string& line : lost_sizes(part.brep, options.sizing)) report.warnings.push_back(line);
    report.seconds = context.seconds();
    for (const char* step :
         {"read", "cells", "difference", "keep", "surface", "volume", "optimise", "validate", "measure"})
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
std::vector<std::int32_t> node_origins(const Mesh& old, const Filled& filled, const std::vector<std::int32_t>& corners,
                                       const RunContext& context) {
    const Mesh& mesh = filled.mesh;
    std::vector<std::int32_t> origins = extended(corners, mesh.node_count());
    for (const NodeId n : filled.moved) origins[n.index()] = -1;
    if (old.order == 1 || mesh.order == 1) return origins;
    std::vector<std::pair<Number, std::int32_t>> of_number;
    for (std::size_t n = old.corner_count; n < old.node_count(); ++n)
        of_number.emplace_back(old.node_numbers[n], std::int32_t(n));
    if (!std::is_sorted(of_number.begin(), of_number.end())) std::sort(of_number.begin(), of_number.end());
    RoundWatch watch(context);
    auto it = of_number.begin();
    for (std::size_t n = mesh.corner_count; n < mesh.node_count(); ++n) {
        watch();
        const Number number = mesh.node_numbers[n];
        if (it == of_number.end() || it->first != number)  // kept ones are in their old order, as a rule
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
    record_kept(
        *now, {{RigidMotion{}, report.difference.regions[0].features, now->node_origin.size(), now->tet_origin.size()}},
        report);
    record_run(now->part, now->options, context, total, report);
    result.part_mesh = std::move(now);
    return result;
}

/// What of the old mesh may be kept, or why nothing can.
std::string reason_for_full_mesh(const PartMesh& old, const MeshOptions& options) {
    if (old.options.order != options.order) return "the element order changed";
    const double ratio = options.sizing.size / old.options.sizing.size;
    if (std::max(ratio, 1 / ratio) > 1.2) return "the global size changed by more than 1.2 times";
    if (options.sizing.elements_across_gap >= elements_that_bend &&
        old.options.sizing.elements_across_gap < elements_that_bend)
        return "elements may not span thin walls any more";
    return {};
}

FeatureTree interpreted(const RawDocument& document, RunContext& context, const FeatureTree* known) {
    const RunContext::Step step(context, "read");
    return interpret(document, context, known);
}

/// Tree and final shape; the cells are still to come.
PartState without_cells(FeatureTree tree, RunContext& context) {
    const RunContext::Step step(context, "cells");
    Brep brep(tree.final_shape);
    return {std::move(tree), std::move(brep), {}};
}

void find_owners_by_points(PartState& part) {
    part.cells = cells_without_fuse(part.tree, part.brep);
    part.cells.owners_of_final_face = VolumeFaces(part.tree).owners_of_faces(part.brep);
}

void find_cells(PartState& part, RunContext& context, const PartState* before, double seconds) {
    const RunContext::Step step(context, "cells");
    std::optional<CellModel> cells;
    if (before) cells = cells_after_edit({before->tree, before->cells}, part.tree, part.brep, context);
    if (!cells) cells = build_cells(part.tree, part.brep, context, seconds);
    part.cells = std::move(*cells);
}

void find_cells_or_owners(PartState& part, RunContext& context, const PartState* before, double seconds) {
    find_cells(part, context, before, seconds);
    if (!part.cells.report.is_out_of_time) return;
    const RunContext::Step step(context, "cells");
    find_owners_by_points(part);
    part.cells.report.fallbacks = {
        "the volumes of the features take too long to fuse; who owns a face was found by points on it"};
}

/// Nobody should wait longer for cells than for the mesh, which does not need them; but a moment is always worth it.
void find_cells_of_meshed(PartState& part, RunContext& context, double seconds_of_meshing) {
    find_cells_or_owners(part, context, nullptr,
                         std::clamp(seconds_of_meshing, least_seconds_beside_mesh, most_seconds_beside_mesh));
}

Resolution resolution(const SizingField& sizing, const MeshOptions& options) {
    const double finest =
        std::max(finest_resolution_needed * sizing.smallest(), coarsest_resolution_needed * options.sizing.size);
    if (sizing.is_uniform()) return finest;
    return {finest, [&sizing](const Vec3& p) { return resolution_of_changes * sizing.at(p); }};
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
    PartState part = without_cells(interpreted(document, context, known), context);
    find_cells(part, context, nullptr, most_seconds_of_cells);
    return part;
}

PartState read_part_to_mesh(const RawDocument& document, RunContext& context, const PartState* before, double seconds) {
    PartState part = without_cells(interpreted(document, context, before ? &before->tree : nullptr), context);
    find_cells_or_owners(part, context, before, seconds);
    return part;
}

PartState read_part_unfused(const RawDocument& document, RunContext& context, const FeatureTree* known) {
    PartState part = without_cells(interpreted(document, context, known), context);
    const RunContext::Step step(context, "cells");
    find_owners_by_points(part);
    return part;
}

PartMeshResult mesh_part(RawDocument document, const MeshOptions& options, RunContext& context, NextNumbers next) {
    const auto start = std::chrono::steady_clock::now();
    PartState part = without_cells(interpreted(document, context, nullptr), context);
    const double start_of_meshing = used_seconds(context);
    Whole whole = mesh_whole(part.brep, options, {}, next, context);
    find_cells_of_meshed(part, context, used_seconds(context) - start_of_meshing);
    const double total = seconds_since(start);
    PartMeshResult result;
    Mesh& mesh = whole.filled.mesh;
    record_mesh(mesh, whole.sizing, options, context, result.report);
    record_fill(whole.filled, result.report);
    record_run(part, options, context, total, result.report);
    const std::size_t nodes = mesh.node_count(), tets = mesh.tets.size();
    result.part_mesh = std::make_shared<const PartMesh>(PartMesh{std::move(part),
                                                                 std::move(document),
                                                                 std::move(whole.options),
                                                                 std::move(whole.sizing),
                                                                 std::move(mesh),
                                                                 std::vector<std::int32_t>(nodes, -1),
                                                                 std::vector<std::int32_t>(tets, -1),
                                                                 {}});
    return result;
}

PartMeshResult update_part(const PartMesh& old, RawDocument document, const MeshOptions& asked, RunContext& context) {
    const auto start = std::chrono::steady_clock::now();
    MeshOptions options = asked;
    options.sizing.refines_narrow_faces = old.options.sizing.refines_narrow_faces;
    if (options == old.options && document == old.document) return unchanged(old, context);
    PartState part = read_part_to_mesh(document, context, &old.part);
    const std::string why_full = reason_for_full_mesh(old, options);
    const std::vector<SizeSource> adopted_sizes = why_full.empty() ? old.adopted_sizes : std::vector<SizeSource>{};
    SizingField sizing = make_sizing(part.brep, options.sizing, adopted_sizes, context);
    refuse_too_many(part.brep, sizing, options, context);

    PartMeshResult result;
    Report& report = result.report;
    MeshOptions filling = options;
    filling.volume.moves_kept_nodes = true;
    const double smallest_margin = margin_of(options, sizing);
    std::vector<double> margins{smallest_margin, 2 * smallest_margin};
    try {
        report.difference =
            with_our_errors([&] { return compare(old.part, part, resolution(sizing, options), context); });
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
    double share_tried = 0;  // of the part, by all attempts
    std::string why_nothing = "full mesh: nothing could be kept";
    for (const double margin : margins) {
        try {
            Kept kept = with_our_errors([&] {
                return keep({old.mesh, old.part.brep, part.brep, report.difference, old.sizing, sizing, old.made_for,
                             margin, old.options.sizing == options.sizing},
                            context);
            });
            const double share = share_to_fill(kept, old.mesh);
            if (share_tried > 0 && share_tried + share > 1) {
                why_nothing = "full mesh: keeping still less would take longer than meshing the part anew";
                break;
            }
            share_tried += share;
            node_origin = std::move(kept.node_origin);
            tet_origin = std::move(kept.tet_origin);
            const std::vector<KeptByMotion> by_motion = kept.by_motion;
            if (node_origin.empty()) {
                why_nothing = "full mesh: no element of the old mesh is clear of what changed";
                break;
            }
            filled = fill(part.brep, sizing, std::move(kept), filling, context);
            report.kept = by_motion;
            break;
        } catch (const Error& failure) {
            context.check_cancelled();
            report.fallbacks.push_back("keeping everything further than " + in_words(margin) +
                                       " edge lengths from the change failed: " + failure.what());
        }
    }
    if (!filled) {
        if (!margins.empty()) report.fallbacks.push_back(why_nothing);
        node_origin.clear(), tet_origin.clear();
        Whole whole = mesh_whole(part.brep, options, adopted_sizes,
                                 {old.mesh.next_node_number, old.mesh.next_element_number}, context);
        options = std::move(whole.options);
        sizing = std::move(whole.sizing);
        filled = std::move(whole.filled);
    }
    const double total = seconds_since(start);
    record_mesh(filled->mesh, sizing, options, context, report);
    record_fill(*filled, report);
    node_origin = node_origins(old.mesh, *filled, node_origin, context);
    tet_origin = extended(without(tet_origin, filled->released), filled->mesh.tets.size());
    MadeFor sizes = made_for(filled->mesh, sizing, {old.mesh, old.sizing, old.made_for}, node_origin);
    auto now = std::make_shared<PartMesh>(
        PartMesh{std::move(part), std::move(document), options, sizing, std::move(filled->mesh), std::move(node_origin),
                 std::move(tet_origin), std::move(filled->used_active), std::move(sizes), adopted_sizes});
    record_kept(*now, report.kept, report);
    record_run(now->part, now->options, context, total, report);
    result.part_mesh = std::move(now);
    return result;
}

PartMeshResult adopt_part(RawDocument document, const MeshOptions& asked, const Mesh& foreign, RunContext& context) {
    const auto start = std::chrono::steady_clock::now();
    MeshOptions options = asked;
    options.sizing.refines_narrow_faces = false;
    if (options.order != foreign.order) throw InputError("An adopted mesh keeps its element order.");
    PartState part = without_cells(interpreted(document, context, nullptr), context);
    const double start_of_meshing = used_seconds(context);
    const std::vector<SizeSource> adopted_sizes = local_sizes(foreign, options.sizing.size);
    SizingField sizing = make_sizing(part.brep, options.sizing, adopted_sizes, context);
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
            report.fallbacks.push_back(std::to_string(fit.released_tets) + " of " +
                                       std::to_string(foreign.tets.size()) +
                                       " elements do not fit the part and were made anew: " + listed(fit.reasons));
        if (more_layers == 0 && fit.moved_mids > 0)
            report.fallbacks.push_back(std::to_string(fit.moved_mids) +
                                       " mid-side nodes were off the surface and are new, on it");
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
        Whole whole = mesh_whole(part.brep, options, adopted_sizes,
                                 {foreign.next_node_number, foreign.next_element_number}, context);
        options = std::move(whole.options);
        sizing = std::move(whole.sizing);
        filled = std::move(whole.filled);
    }
    find_cells_of_meshed(part, context, used_seconds(context) - start_of_meshing);
    const double total = seconds_since(start);
    record_mesh(filled->mesh, sizing, options, context, report);
    record_fill(*filled, report);
    node_origin = node_origins(foreign, *filled, node_origin, context);
    tet_origin = extended(without(tet_origin, filled->released), filled->mesh.tets.size());
    auto now = std::make_shared<PartMesh>(PartMesh{std::move(part),
                                                   std::move(document),
                                                   options,
                                                   sizing,
                                                   std::move(filled->mesh),
                                                   std::move(node_origin),
                                                   std::move(tet_origin),
                                                   {},
                                                   {},
                                                   adopted_sizes});
    record_kept(*now, report.kept, report);
    record_run(now->part, now->options, context, total, report);
    result.part_mesh = std::move(now);
    return result;
}

std::shared_ptr<const PartMesh> restore_part(RawDocument document, const MeshOptions& options, Mesh mesh,
                                             RunContext& context, MadeFor made_for,
                                             std::vector<SizeSource> adopted_sizes) {
    PartState part = read_part_unfused(document, context);
    const std::vector<std::string> broken = broken_invariants(mesh, expectation_of(part.brep), context);
    if (!broken.empty()) throw StateError("The saved mesh does not fit the part: " + broken.front() + ".");
    const SizingField sizing = make_sizing(part.brep, options.sizing, adopted_sizes, context);
    const std::size_t nodes = mesh.node_count(), tets = mesh.tets.size();
    return std::make_shared<const PartMesh>(PartMesh{std::move(part),
                                                     std::move(document),
                                                     options,
                                                     sizing,
                                                     std::move(mesh),
                                                     std::vector<std::int32_t>(nodes, -1),
                                                     std::vector<std::int32_t>(tets, -1),
                                                     {},
                                                     std::move(made_for),
                                                     std::move(adopted_sizes)});
}

}  // namespace featuremesh
