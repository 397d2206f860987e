// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/part_mesh.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "cells/cells_without_fuse.h"
#include "core/errors.h"
#include "core/ids.h"
#include "core/message.h"
#include "core/messages.h"
#include "core/numbers_in_words.h"
#include "core/peak_memory.h"
#include "core/run_context.h"
#include "mesh/validation.h"
#include "sizing/girth.h"
#include "sizing/lost_sizes.h"
#include "sizing/zone_notes.h"
#include "surface/merged_entities.h"
#include "update/adopted_sizes.h"
#include "update/fill_part.h"
#include "update/foreign_fit.h"
#include "update/ignored_details.h"
#include "update/keep.h"
#include "update/mend_angles.h"
#include "update/mesh_origin.h"
#include "update/our_errors.h"
#include "update/size_request.h"
#include "update/thin_tets.h"
#include "volume/curved/mid_side_nodes.h"

namespace featuremesh {

namespace {

// How closely the changed boundary is resolved: a third of the edge length wanted there, but no finer than half of the
// smallest edge length or a twentieth of the global size. A detail with tiny elements somewhere is no reason to look
// that closely at everything that changed.
constexpr double resolution_of_changes = 1.0 / 3, finest_resolution_needed = 0.5, coarsest_resolution_needed = 0.05;

/// Blames the refinement without which there would be less than half of so many elements, else the size. All places of
/// one local size are one refinement.
Message say_too_many(const Brep& brep, const MeshOptions& options, double elements, RunContext& context) {
    const auto millions = [](double count) { return count < 1e18 ? std::llround(count / 1e6) : 1'000'000'000'000; };
    const SizingOptions& sizing = options.sizing;
    Message said = say<Code::too_many_elements>(Length{sizing.size}, millions(elements), millions(options.most_tets));
    double least = 0.5 * elements;
    const auto is_much_less = [&](const SizingOptions& others) {
        const double left = estimate_elements(brep, make_sizing(brep, others, {}, context), context);
        if (left >= least) return false;
        least = left;
        return true;
    };
    for (std::size_t i = 0; i < sizing.zones.size(); ++i) {
        SizingOptions others = sizing;
        others.zones.erase(others.zones.begin() + std::ptrdiff_t(i));
        if (is_much_less(others))
            said = say<Code::zone_makes_too_many>(sizing.zones[i].name, Length{sizing.zones[i].inner},
                                                  millions(elements), millions(options.most_tets));
    }
    std::map<double, std::vector<Entity>> places;
    for (const LocalSize& local : sizing.local) places[local.size].push_back(local.entity);
    for (const auto& [size, entities] : places) {
        SizingOptions others = sizing;
        std::erase_if(others.local, [size = size](const LocalSize& local) { return local.size == size; });
        if (is_much_less(others))
            said = say<Code::local_size_makes_too_many>(entities, Length{size}, millions(elements),
                                                        millions(options.most_tets));
    }
    return said;
}

/// What is wrong with so many tets, if there are too many.
Message if_too_many(const Brep& brep, const SizingField& sizing, const MeshOptions& options, RunContext& context) {
    if (brep.dimension() == Dimension::solids && !may_ask_for_more_tets(brep, sizing, options.most_tets)) return {};
    const double tets = estimate_elements(brep, sizing, context, options.most_tets);
    return tets <= options.most_tets ? Message{} : say_too_many(brep, options, tets, context);
}

/// Of the elements that fill the part.
std::size_t element_count(const Mesh& mesh, Dimension dimension) {
    return dimension == Dimension::solids  ? mesh.tets.size()
           : dimension == Dimension::faces ? mesh.triangles.size()
                                           : mesh.segments.size();
}

void record_mesh(const Mesh& mesh, const PartState& part, const SizingField& sizing, const MeshOptions& options,
                 RunContext& context, Report& report) {
    const RunContext::Step step(context, "measure");
    report.nodes = mesh.node_count();
    report.tets = mesh.tets.size();
    report.triangles = mesh.triangles.size();
    report.segments = mesh.segments.size();
    report.dimension = part.brep.dimension();
    report.order = options.order;
    report.size = options.sizing.size;
    report.quality = measure_quality(mesh, context);
    report.lengths = measure_size_conformity(mesh, sizing);
    for (const Message& line : warnings_of_thin_tets(mesh, report.quality)) report.warnings.push_back(line);
}

void record_fill(const Filled& filled, Report& report) {
    report.surface = filled.surface;
    report.volume = filled.volume;
    report.warnings.insert(report.warnings.end(), filled.surface.warnings.begin(), filled.surface.warnings.end());
    report.warnings.insert(report.warnings.end(), filled.volume.warnings.begin(), filled.volume.warnings.end());
}

void record_run(const PartMesh& now, const RunContext& context, double total, Report& report) {
    const SizingOptions& sizing = now.options.sizing;
    for (const Message& line : lost_sizes(now.part.brep, sizing)) report.warnings.push_back(line);
    for (const Message& line : warnings_of_thin_rods(now.part.brep, sizing)) report.warnings.push_back(line);
    for (const Message& line : notes_on_zones(now.part.brep, sizing, now.mesh.points)) report.warnings.push_back(line);
    report.seconds = context.seconds();
    for (const char* step : {"read", "difference", "keep", "surface", "volume", "optimise", "validate", "measure"})
        report.seconds.try_emplace(step, 0.0);
    report.seconds["engine_total"] = total;
    report.peak_memory_mb = peak_memory_mb();
    report.warnings.insert(report.warnings.end(), now.part.tree.notes.begin(), now.part.tree.notes.end());
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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

void check_ignored(const MeshOptions& options) {
    const double below = options.ignore_below, size = options.sizing.size;
    if (below <= 0 || !(size > 0)) return;  // a wrong mesh size is refused where the sizing field is made
    if (std::isfinite(below) && below <= 0.5 * size) return;
    throw InputError(say<Code::ignored_too_large>(Length{options.ignore_below}, Length{options.sizing.size}));
}

/// Why nothing of the old mesh can be kept, if nothing can.
Message reason_for_full_mesh(const PartMesh& old, const MeshOptions& options) {
    if (old.options.order != options.order) return say<Code::order_changed>();
    if (!ignore_the_same(old.part.brep, old.options.ignored_below, options.ignored_below))
        return say<Code::other_details_ignored>();
    if (options.sizing.size != old.options.sizing.size) return say<Code::global_size_changed>();
    if (options.sizing.elements_across_gap >= elements_that_bend &&
        old.options.sizing.elements_across_gap < elements_that_bend)
        return say<Code::walls_not_spanned>();
    return {};
}

FeatureTree interpreted(const RawDocument& document, RunContext& context, const FeatureTree* known,
                        Dimension dimension) {
    const RunContext::Step step(context, "read");
    return interpret(document, context, known, dimension);
}

PartState part_of(FeatureTree tree, Dimension dimension, RunContext& context) {
    const RunContext::Step step(context, "read");
    Brep brep(tree.final_shape, dimension);
    return {std::move(tree), std::move(brep), {}};
}

Resolution resolution(const SizingField& sizing, const MeshOptions& options) {
    const double finest =
        std::max(finest_resolution_needed * sizing.smallest(), coarsest_resolution_needed * options.sizing.size);
    if (sizing.is_uniform()) return finest;
    return {finest, [&sizing](const Vec3& p) { return resolution_of_changes * sizing.at(p); },
            resolution_of_changes * (sizing.growth() - 1)};
}

/// Where sizes change along an interface, the tets that have to change with them need more room.
double margin_of(const MeshOptions& options, const SizingField& sizing) {
    if (options.keep_margin > 0) return options.keep_margin;
    return sizing.is_uniform() ? 0.9 : 1.2;
}

/// The share of the part that is not kept.
double share_to_fill(const Kept& kept, const Mesh& old, Dimension dimension) {
    return 1 - double(element_count(kept.mesh, dimension)) /
                   double(std::max<std::size_t>(1, element_count(old, dimension)));
}

/// Curved tets need more room round a rod than straight ones.
MeshOptions with_pieces_round_rods(MeshOptions options) {
    options.sizing.pieces_round_rod = options.order == 2 ? 8 : 6;
    return options;
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
    record_mesh(old.mesh, old.part, old.sizing, old.options, context, report);
    record_kept(
        *now, {{RigidMotion{}, report.difference.regions[0].features, now->node_origin.size(), now->tet_origin.size()}},
        report);
    record_run(*now, context, seconds_since(start), report);
    result.part_mesh = std::move(now);
    return result;
}

/// Numbers all nodes and elements without gaps, segments last: FreeCAD reads only the others from files.
void number_all(Mesh& mesh, NextNumbers next) {
    for (Number& number : mesh.node_numbers) number = next.node++;
    for (auto* numbers : {&mesh.triangle_numbers, &mesh.tet_numbers, &mesh.segment_numbers})
        for (Number& number : *numbers) number = next.element++;
    mesh.next_node_number = next.node, mesh.next_element_number = next.element;
}

/// The stages of meshing a part, in the order in which they are called; each leaves what the next needs.
class Stages {
  public:
    Stages(RawDocument document, MeshOptions options, RunContext& context)
        : options_(std::move(options)), document_(std::move(document)), context_(context) {
        check_ignored(options_);
    }

    /// `before`: the state before an edit, or none.
    void read(const PartState* before) { part_ = read_part_to_mesh(document_, context_, before, options_.dimension); }

    Dimension dimension() const { return part_->brep.dimension(); }
    bool has_shells() const { return part_->brep.has_free_faces() || part_->brep.has_free_edges(); }

    void make_sizing(std::vector<SizeSource> adopted_sizes) {
        const RunContext::Step step(context_, "surface");
        adopted_sizes_ = std::move(adopted_sizes);
        sizing_ = featuremesh::make_sizing(part_->brep, options_.sizing, adopted_sizes_, context_);
        if (const Message why = if_too_many(part_->brep, *sizing_, options_, context_); !why.empty())
            throw InputError(why);
    }

    /// What the edit did. False where that cannot be told, so that nothing can be kept.
    bool compare_with(const PartState& before) {
        const Message why =
            why_failed([&] { report_.difference = compare(before, *part_, resolution(*sizing_, options_), context_); });
        if (why.empty()) return true;
        context_.check_cancelled();
        report_.fallbacks.push_back(say<Code::full_mesh>(say<Code::changes_not_found>(why)));
        part_ = read_part_to_mesh(document_, context_, nullptr, options_.dimension);
        return false;
    }

    /// Keeps what is clear of the changes; less where that cannot be filled.
    void fill_beside_kept(const PartMesh& old) {
        MeshOptions filling = options_;
        filling.volume.moves_kept_nodes = true;
        double share_tried = 0;  // of the part, by all attempts
        why_nothing_ = say<Code::nothing_kept>();
        const double smallest_margin = margin_of(options_, *sizing_);
        for (const double margin : {smallest_margin, 2 * smallest_margin}) {
            Message why = why_failed([&] {
                kept_ =
                    keep({old.mesh, old.part.brep, part_->brep, report_.difference, old.sizing, *sizing_, old.made_for,
                          margin, compare_asked_sizes(old.options.sizing, options_.sizing), options_.ignored_below},
                         context_);
            });
            context_.check_cancelled();
            if (why.empty()) {
                const double share = share_to_fill(kept_, old.mesh, dimension());
                if (share_tried > 0 && share_tried + share > 1) {
                    why_nothing_ = say<Code::keeping_less_not_worth>();
                    return;
                }
                share_tried += share;
                if (kept_.node_origin.empty()) {
                    why_nothing_ = say<Code::nothing_clear_of_changes>();
                    return;
                }
                if (fill_gaps(old.mesh, filling, margin > smallest_margin, why)) {
                    mend_small_angles(part_->brep, filling, adopted_sizes_, *filled_, &origin_, report_.rounds,
                                      context_);
                    return;
                }
            }
            report_.fallbacks.push_back(say<Code::keeping_failed>(margin, why));
            report_.rounds.push_back({"kept elements", {}, "less is kept", why});
        }
    }

    /// Keeps what of another maker's mesh fits the part; less where that cannot be filled.
    void fill_beside_fitting(const Mesh& foreign) {
        why_nothing_ = say<Code::nothing_kept>();
        for (const int more_layers : {0, 2}) {
            ForeignFit fit = fit_to_shape(part_->brep, foreign, more_layers, context_);
            if (more_layers == 0) tell_misfits(fit, foreign);
            kept_ = std::move(fit.kept);
            Message why;
            if (fill_gaps(foreign, options_, more_layers > 0, why)) return;
            report_.fallbacks.push_back(say<Code::keeping_what_fits_failed>(why));
            report_.rounds.push_back({"kept elements", {}, "less is kept", why});
        }
    }

    void give_up_keeping(Message why) { why_nothing_ = std::move(why); }

    /// A full mesh where nothing has been kept, with numbers that nothing has had. Shorter pieces along narrow faces
    /// are asked for anew.
    void fill_rest(NextNumbers next) {
        if (filled_) return;
        if (!why_nothing_.empty()) report_.fallbacks.push_back(say<Code::full_mesh>(why_nothing_));
        report_.kept.clear();
        for (const bool refines : {true, false}) {
            if (refines && sizing_ && options_.sizing.refines_narrow_faces) break;  // those that were asked for before
            const RunContext::Step step(context_, "surface");
            options_.sizing.refines_narrow_faces = refines;
            sizing_ = featuremesh::make_sizing(part_->brep, options_.sizing, adopted_sizes_, context_);
            const Message why = if_too_many(part_->brep, *sizing_, options_, context_);
            if (why.empty()) break;
            if (!refines) throw InputError(why);
            report_.rounds.push_back({"narrow faces", {}, "the plain size along them", why});
            report_.warnings.push_back(say<Code::narrow_faces_plain>(why));
        }
        auto whole = fill_whole(next);
        if (const auto* refusal = std::get_if<Message>(&whole)) throw MeshError(*refusal);
        take(std::get<Filled>(std::move(whole)));
        number_all(filled_->mesh, next);
        origin_.nodes.assign(filled_->mesh.node_count(), -1);
        origin_.elements.assign(element_count(filled_->mesh, dimension()), -1);
        origin_.made_for = {};
    }

    /// The mesh with all that its next update needs, and the report.
    PartMeshResult finish() {
        Mesh& mesh = filled_->mesh;
        record_mesh(mesh, *part_, *sizing_, options_, context_, report_);
        record_fill(*filled_, report_);
        std::vector<SharedNode> shared = shared_nodes(mesh, part_->brep, *filled_->merged, options_.ignored_below);
        auto now = std::make_shared<PartMesh>(
            PartMesh{std::move(*part_), std::move(document_), options_, std::move(*sizing_), std::move(mesh),
                     std::move(origin_.nodes), std::move(origin_.elements), std::move(filled_->used_active),
                     std::move(origin_.made_for), std::move(adopted_sizes_), std::move(shared)});
        record_kept(*now, report_.kept, report_);
        record_run(*now, context_, seconds_since(start_), report_);
        return {std::move(now), std::move(report_)};
    }

  private:
    /// Without its smallest details, with more of them where it is refused so, then with all, and with thin tets as the
    /// last resort.
    std::variant<Filled, Message> fill_whole(NextNumbers next) {
        std::vector<double> lengths{length_to_ignore(part_->brep, options_)};
        std::vector<Message> refusals;
        for (const bool takes_thin_tets : {false, true})
            for (std::size_t i = 0; i < lengths.size(); ++i) {
                if (takes_thin_tets && !tells_of_thin_tets(refusals[i])) continue;
                if (takes_thin_tets)
                    report_.rounds.push_back({"thin elements", {}, "they stay", refusals[i]});
                else if (i > 0)
                    report_.rounds.push_back({"details", {}, "fewer are ignored", refusals[i - 1]});
                options_.ignored_below = lengths[i];
                std::vector<Round> rounds;  // with other details it is another part: as many may be tried
                auto whole = fill_all(next, takes_thin_tets, rounds);
                report_.rounds.insert(report_.rounds.end(), rounds.begin(), rounds.end());
                const auto* refusal = std::get_if<Message>(&whole);
                if (!refusal) return whole;
                refusals.push_back(*refusal);
                if (takes_thin_tets || options_.ignore_below != 0) continue;
                for (const double less : {0.2 * lengths.front(), 0.0})
                    if (less < lengths.back() && !ignore_the_same(part_->brep, lengths.back(), less)) {
                        lengths.push_back(less);
                        break;
                    }
            }
        return refusals[lengths.size() - 1];
    }

    std::variant<Filled, Message> fill_all(NextNumbers next, bool takes_thin_tets, std::vector<Round>& rounds) {
        MeshOptions options = options_;
        options.volume.takes_thin_tets = takes_thin_tets;
        auto filled = fill_part(part_->brep, *sizing_, nothing_kept(next), options, adopted_sizes_, rounds, context_);
        if (auto* whole = std::get_if<Filled>(&filled))
            mend_small_angles(part_->brep, options, adopted_sizes_, *whole, nullptr, rounds, context_);
        return filled;
    }

    static bool tells_of_thin_tets(const Message& refusal) {
        return refusal.code() == Code::thin_elements_remain || refusal.code() == Code::thin_elements_remain_beside;
    }

    bool fill_gaps(const Mesh& before, const MeshOptions& options, bool all_may_ask, Message& why) {
        MeshOrigin kept{std::move(kept_.node_origin),
                        std::move(dimension() == Dimension::solids  ? kept_.tet_origin
                                  : dimension() == Dimension::faces ? kept_.triangle_origin
                                                                    : kept_.segment_origin),
                        std::move(kept_.made_for)};
        report_.kept = std::move(kept_.by_motion);
        auto filled = fill_part(part_->brep, *sizing_, std::move(kept_), options, adopted_sizes_, report_.rounds,
                                context_, all_may_ask);
        if (auto* refusal = std::get_if<Message>(&filled)) return why = std::move(*refusal), false;
        take(std::get<Filled>(std::move(filled)));
        origin_ = origin_of(*filled_, std::move(kept), before, element_count(filled_->mesh, dimension()), context_);
        return true;
    }

    void take(Filled filled) {
        options_.sizing.refines_narrow_faces = filled.refines_narrow_faces;
        sizing_ = *filled.sizing;
        filled_ = std::move(filled);
    }

    void tell_misfits(const ForeignFit& fit, const Mesh& foreign) {
        if (fit.released_tets > 0)
            report_.fallbacks.push_back(
                say<Code::elements_made_anew>(fit.released_tets, foreign.tets.size(), fit.reasons));
        if (fit.moved_mids > 0) report_.fallbacks.push_back(say<Code::mid_nodes_moved>(fit.moved_mids));
    }

    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    MeshOptions options_;
    RawDocument document_;
    RunContext& context_;
    std::optional<PartState> part_;
    std::vector<SizeSource> adopted_sizes_;
    std::optional<SizingField> sizing_;
    Report report_;
    Kept kept_;
    MeshOrigin origin_;
    Message why_nothing_;  ///< is kept; empty where nothing was to be kept
    std::optional<Filled> filled_;
};

/// Of a saved mesh: the rest is the invariants' business.
void require_known_places(const Mesh& mesh, const Brep& brep, const MadeFor& made_for) {
    const std::array<std::size_t, 4> counts{brep.vertex_count(), brep.edge_count(), brep.face_count(),
                                            brep.solid_count()};
    const auto is_known = [&](const Entity& e) {
        return e.dim >= 0 && e.dim < 4 && e.index >= 0 && std::size_t(e.index) < counts[std::size_t(e.dim)];
    };
    const auto is_node = [&](NodeId n) { return n.is_valid() && n.index() < mesh.node_count(); };
    const auto are_known = [&](const auto& owners) {
        return std::all_of(owners.begin(), owners.end(), [&](const auto& id) { return is_known(entity_of(id)); });
    };
    if (!std::all_of(mesh.entities.begin(), mesh.entities.end(), is_known) || !are_known(mesh.segment_edges) ||
        !are_known(mesh.triangle_faces) || !are_known(mesh.tet_solids) ||
        !std::all_of(made_for.nodes.begin(), made_for.nodes.end(), is_node))
        throw StateError(
            say<Code::damaged_state>("The saved mesh refers to nodes, or to parts of the shape, that there are not."));
}

}  // namespace

PartState read_part(const RawDocument& document, RunContext& context, const FeatureTree* known, Dimension dimension) {
    PartState part = part_of(interpreted(document, context, known, dimension), dimension, context);
    const RunContext::Step step(context, "cells");
    part.cells = build_cells(part.tree, part.brep, context);
    return part;
}

PartState read_part_to_mesh(const RawDocument& document, RunContext& context, const PartState* before,
                            Dimension dimension) {
    PartState part =
        part_of(interpreted(document, context, before ? &before->tree : nullptr, dimension), dimension, context);
    const RunContext::Step step(context, "read");
    part.cells = before ? cells_without_fuse(part.tree, part.brep, CellsBefore{before->tree, before->cells})
                        : cells_without_fuse(part.tree, part.brep);
    return part;
}

double estimate_part(const RawDocument& document, const MeshOptions& options, RunContext& context) {
    const Brep brep(interpret(document, context, nullptr, options.dimension).final_shape, options.dimension);
    return estimate_elements(brep, make_sizing(brep, options.sizing, {}, context));
}

PartMeshResult mesh_part(RawDocument document, const MeshOptions& options, RunContext& context, NextNumbers next) {
    Stages stages(std::move(document), with_pieces_round_rods(options), context);
    stages.read(nullptr);
    stages.fill_rest(next);
    return stages.finish();
}

PartMeshResult update_part(const PartMesh& old, RawDocument document, const MeshOptions& asked, RunContext& context) {
    MeshOptions options = with_pieces_round_rods(asked);
    options.sizing.refines_narrow_faces = old.options.sizing.refines_narrow_faces;
    options.ignored_below = length_to_ignore(old.part.brep, options);
    if (options.ignore_below == 0 && old.options.ignore_below == 0)
        options.ignored_below = std::min(options.ignored_below, old.options.ignored_below);
    if (options == old.options && document == old.document) return unchanged(old, context);
    Message why_full = reason_for_full_mesh(old, options);

    Stages stages(std::move(document), std::move(options), context);
    stages.read(&old.part);
    const bool is_alike = stages.dimension() == old.part.brep.dimension();
    if (!is_alike) why_full = say<Code::dimension_changed>();
    stages.make_sizing(why_full.empty() ? old.adopted_sizes : std::vector<SizeSource>{});
    const bool is_compared = is_alike && stages.compare_with(old.part);
    if (!why_full.empty())
        stages.give_up_keeping(why_full);
    else if (is_compared)
        stages.fill_beside_kept(old);
    stages.fill_rest({old.mesh.next_node_number, old.mesh.next_element_number});
    return stages.finish();
}

PartMeshResult adopt_part(RawDocument document, const MeshOptions& asked, const Mesh& foreign, RunContext& context) {
    if (foreign.tets.empty()) throw InputError(say<Code::no_elements>());
    if (asked.order != foreign.order) throw InputError(say<Code::adopted_of_other_order>());
    MeshOptions options = with_pieces_round_rods(asked);
    options.sizing.refines_narrow_faces = false;
    options.ignored_below = std::max(0.0, options.ignore_below);

    Stages stages(std::move(document), std::move(options), context);
    stages.read(nullptr);
    if (stages.dimension() != Dimension::solids) throw InputError(say<Code::adopted_of_other_dimension>());
    if (stages.has_shells()) throw InputError(say<Code::adopted_beside_shells>());
    stages.make_sizing(local_sizes(foreign, asked.sizing.size));
    stages.fill_beside_fitting(foreign);
    stages.fill_rest({foreign.next_node_number, foreign.next_element_number});
    return stages.finish();
}

std::shared_ptr<const PartMesh> restore_part(RawDocument document, const MeshOptions& asked, Mesh mesh,
                                             RunContext& context, MadeFor made_for,
                                             std::vector<SizeSource> adopted_sizes) {
    const MeshOptions options = with_pieces_round_rods(asked);
    PartState part = read_part_to_mesh(document, context, nullptr, options.dimension);
    require_known_places(mesh, part.brep, made_for);
    const std::vector<Message> broken = broken_invariants(mesh, expectation_of(part.brep), context);
    if (!broken.empty()) throw StateError(say<Code::saved_mesh_misfits>(broken.front()));
    const SizingField sizing = make_sizing(part.brep, options.sizing, adopted_sizes, context);
    const std::size_t nodes = mesh.node_count(), elements = element_count(mesh, part.brep.dimension());
    std::vector<SharedNode> shared =
        shared_nodes(mesh, part.brep, MergedEntities(part.brep, options.ignored_below), options.ignored_below);
    return std::make_shared<const PartMesh>(PartMesh{std::move(part),
                                                     std::move(document),
                                                     options,
                                                     sizing,
                                                     std::move(mesh),
                                                     std::vector<std::int32_t>(nodes, -1),
                                                     std::vector<std::int32_t>(elements, -1),
                                                     {},
                                                     std::move(made_for),
                                                     std::move(adopted_sizes),
                                                     std::move(shared)});
}

}  // namespace featuremesh
