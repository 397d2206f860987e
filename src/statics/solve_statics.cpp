// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/solve_statics.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/messages.h"
#include "statics/coarse_level.h"
#include "statics/earlier_nodes.h"
#include "statics/new_nodes.h"
#include "statics/rigid_balance.h"
#include "statics/same_rows.h"

namespace featuremesh {

namespace {

/// More new nodes are not factored by themselves: a new preconditioner is cheaper. Of all nodes, and times the root of
/// their number: factoring takes work like the square of the new ones, a set-up like all nodes.
constexpr double most_new_share = 0.08, most_new_root = 10;
/// With more new nodes than that a start from the last displacements saves less than balancing the new ones costs.
constexpr double most_fresh_share = 0.2;
/// New nodes are balanced with a layer of those round them, and with up to so many while all are fewer than this share.
constexpr int balanced_layers = 4;
constexpr double balanced_share = 0.05;
/// A kept preconditioner may take this many times the iterations of its own matrix, and then some.
constexpr int patience = 3, more_iterations = 10;
/// Iterations go on to this share of the tolerance, since the residual is computed again by other sums.
constexpr double nearer = 0.95;
/// A start whose error has less than this share of the energy norm of all says well enough what that is.
constexpr double good_start = 0.1;
/// Of the energy norm with displaced supports and all else at rest: the least that errors are measured by.
constexpr double least_scale = 1e-5;
/// A start that is best when scaled by this much was found under other loads; one that is best with less than this
/// share of itself is of another problem.
constexpr double other_loads = 0.01, other_problem = 0.1;
/// Aggregation that takes more is given up for a factor, where that is to be had. That of 4-node tets costs more than
/// hundreds of iterations; that of 10-node tets is of an eighth of the unknowns.
constexpr int slow_linear = 350, slow_quadratic = 50;

double most_new_nodes(std::size_t all) {
    return std::min(most_new_share * double(all), most_new_root * std::sqrt(double(all)));
}

bool are_same(const std::vector<Material>& a, const std::vector<Material>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Material& x, const Material& y) {
        return x.young == y.young && x.poisson == y.poisson;
    });
}

/// Forces out of balance, zero on held components.
std::vector<double> residual_of(const StaticsModel& model, std::span<const double> resisting) {
    std::vector<double> residual(resisting.size());
    for (std::size_t i = 0; i < residual.size(); ++i)
        residual[i] = model.is_held[i] ? 0 : model.loads[i] - resisting[i];
    return residual;
}

double product(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

double norm(std::span<const double> values) { return std::sqrt(product(values, values)); }

/// The energy norm of the displacements. Supports that are displaced with all else at rest have a far larger one, which
/// is no scale for an error. Where they move the part as a whole, what they leave is nothing but rounding: then a share
/// of that.
double scale_of(std::span<const double> displacements, std::span<const double> resisting, double at_rest) {
    return std::max(std::sqrt(std::max(0.0, product(displacements, resisting))), least_scale * at_rest);
}

}  // namespace

void check(const StaticsModel& model) {
    const std::size_t n = 3 * model.mesh.node_count();
    if (model.mesh.tets.empty()) throw InputError(say<Code::no_elements>());
    if (model.loads.size() != n || model.is_held.size() != n || model.given.size() != n ||
        model.tet_materials.size() != model.mesh.tets.size())
        throw InputError(say<Code::model_misfits>());
    for (const std::int32_t material : model.tet_materials)
        if (material < 0 || std::size_t(material) >= model.materials.size()) throw InputError(say<Code::no_material>());
    for (const Material& material : model.materials)
        if (!(material.young > 0) || !(material.poisson > -1) || !(material.poisson < 0.5) ||
            !std::isfinite(material.young) || !std::isfinite(material.density))
            throw InputError(say<Code::impossible_material>());
    const auto is_finite = [](double value) { return std::isfinite(value); };
    if (!std::all_of(model.loads.begin(), model.loads.end(), is_finite) ||
        !std::all_of(model.given.begin(), model.given.end(), is_finite))
        throw InputError(say<Code::loads_not_finite>());
}

StaticsSolution StaticsSolver::solve(const StaticsModel& model, RunContext& context) {
    check(model);
    if (!solver_) solver_ = make_linear_solver();
    solver_->use_threads(context.threads);
    const auto ordered = std::make_shared<const OrderedModel>(model);
    StaticsSolution solution = solve_ordered(ordered, context);
    solution.displacements = ordered->as_given(solution.displacements);
    solution.reactions = ordered->as_given(solution.reactions);
    solution.stresses = ordered->as_given(solution.stresses);
    return solution;
}

StaticsSolution StaticsSolver::solve_ordered(const Ordered& ordered, RunContext& context) {
    const StaticsModel& model = ordered->model();
    const TetsOfNodes& around = ordered->around();
    StaticsSolution solution;
    solution.kept_preconditioner = prepare(ordered, context);
    Resistance resistance{std::vector<double>(model.given.size(), 0.0), {}};
    {
        RunContext::Step step(context, "solve");
        solution.displacements = model.given;
        if (norm(model.given) > 0) resistance = resistance_to(solution.displacements, model, around, context);
        const std::vector<double> unbalanced = residual_of(model, resistance.forces);
        if (norm(unbalanced) > 0) {
            const Start start = start_from_last(model, unbalanced, solution, context);
            balance(ordered, unbalanced, start, solution, resistance, context);
        }
    }
    RunContext::Step step(context, "stresses");
    if (resistance.inside.empty()) resistance = resistance_to(solution.displacements, model, around, context);
    const std::vector<double>& resisting = resistance.forces;
    solution.reactions.assign(resisting.size(), 0.0);
    for (std::size_t i = 0; i < resisting.size(); ++i)
        if (model.is_held[i]) solution.reactions[i] = resisting[i] - model.loads[i];
    // The second product takes out what the first is wrong by in the first order of the error.
    solution.strain_energy =
        product(resisting, solution.displacements) / 2 + product(residual_of(model, resisting), solution.displacements);
    solution.stresses = nodal_stresses(model, resistance.inside, around, context);
    solution.discretisation_error =
        discretisation_error(model, resistance.inside, solution.stresses, around, context).whole;
    last_ = {model.mesh.node_numbers, solution.displacements};
    return solution;
}

/// Iterates, with better and better preconditioners, until what is left of the unbalanced forces is within the
/// tolerance. `resistance` is that to the displacements, before and after.
void StaticsSolver::balance(const Ordered& ordered, std::span<const double> unbalanced, const Start& start,
                            StaticsSolution& solution, Resistance& resistance, RunContext& context) {
    const StaticsModel& model = ordered->model();
    enum { carried, aggregated, linear_factor, final } by = solution.kept_preconditioner ? carried : aggregated;
    double whole = start.least_energy_norm;
    int spent = 0;  // iterations with the present preconditioner
    std::vector<double> residual = start.residual;
    bool is_of_elements = false;
    const bool is_displaced = norm(model.given) > 0;
    for (int rounds_left = 4;;) {
        const double left = solver_->energy_norm(residual);
        if (whole == 0 || left > good_start * whole) whole = whole_energy_norm(unbalanced);
        const double scale = is_displaced && is_of_elements
                                 ? std::min(whole, scale_of(solution.displacements, resistance.forces, whole))
                                 : whole;
        solution.residual = norm(residual) / norm(unbalanced);
        solution.energy_error = left / scale;
        solution.preconditioned_by = setup_.by;
        if (solution.energy_error <= tolerance && is_of_elements) return;
        const int most = by == carried      ? patience * setup_.iterations + more_iterations
                         : by == aggregated ? (model.mesh.order == 1 ? slow_linear : slow_quadratic)
                                            : most_iterations;
        const LinearSolver::Aim aim{nearer * tolerance * scale, most, by != linear_factor};
        const auto [done, is_within] = rounds_left-- > 0
                                           ? move_by(model, residual, aim, solution.displacements, context)
                                           : LinearSolver::Solved{0, false};
        resistance = {};  // two at a time would take twice the memory
        resistance = resistance_to(solution.displacements, model, ordered->around(), context);
        residual = residual_of(model, resistance.forces);
        is_of_elements = true;
        solution.iterations += done;
        spent += done;
        if (by != carried) setup_.iterations = spent;
        if (is_within) continue;
        if (by == final) throw KernelError(say<Code::not_converged>());
        rounds_left = 4;
        spent = 0;
        if (by == carried) {
            setup_ = {};
            solution.kept_preconditioner = prepare(ordered, context);
            by = aggregated;
        } else {
            by = by == aggregated && model.mesh.order == 2 ? linear_factor : final;
            put_factor(by == linear_factor ? PreconditionedBy::linear_factor : PreconditionedBy::factor, model,
                       context);
        }
        whole = 0;
    }
}

/// Puts a factor in place of the preconditioner that was too slow. Where that would take too long iterations go on as
/// before.
void StaticsSolver::put_factor(PreconditionedBy wanted, const StaticsModel& model, RunContext& context) {
    RunContext::Step step(context, "setup");
    const bool is_of_all = wanted == PreconditionedBy::factor && model.mesh.order == 2;
    if (!(is_of_all ? solver_->factor_finest() : solver_->factor())) return;
    setup_.by = wanted;
    if (is_of_all) remember_nodes(model);
}

/// Adds to the displacements what balances the residual to the target, and as a whole to the last digits.
LinearSolver::Solved StaticsSolver::move_by(const StaticsModel& model, std::span<const double> residual,
                                            const LinearSolver::Aim& aim, std::vector<double>& displacements,
                                            RunContext& context) {
    std::vector<double> moved(residual.size(), 0.0);
    const LinearSolver::Solved done = solver_->solve(residual, moved, aim, context);
    RigidBalance(model, solver_->matrix(), context).correct(residual, moved);
    for (std::size_t i = 0; i < moved.size(); ++i)  // the aggregates' motions move held components, too, if hardly
        if (!model.is_held[i]) displacements[i] += moved[i];
    return done;
}

double StaticsSolver::whole_energy_norm(std::span<const double> unbalanced) {
    const double whole = solver_->energy_norm(unbalanced);
    if (!(whole > 0)) throw KernelError(say<Code::not_converged>());
    return whole;
}

/// Gives the solver the model's matrix. Returns whether the earlier preconditioner serves it.
bool StaticsSolver::prepare(const Ordered& ordered, RunContext& context) {
    const StaticsModel& model = ordered->model();
    const TetsOfNodes& around = ordered->around();
    std::vector<std::int32_t> origin = origins(model);
    const auto fresh = std::count(origin.begin(), origin.end(), -1);
    if (double(fresh) <= most_new_nodes(origin.size())) {
        carry_over(ordered, std::move(origin), context);
        return true;
    }
    BlockMatrix matrix = [&] {
        RunContext::Step step(context, "assemble");
        const SameRows same = same_rows_of(*ordered, context);
        const EarlierRows earlier{solver_->matrix(), same};
        return assemble_stiffness(model, around, context, &earlier);
    }();
    assembled_.reset();  // until the solver has the matrix
    RunContext::Step step(context, "setup");
    std::optional<CoarseLevel> coarse;
    if (model.mesh.order == 2) coarse = coarse_level(model, around, context);
    solver_->set_up(std::move(matrix), model.mesh.points, std::move(coarse));
    assembled_ = ordered;
    setup_ = {};
    setup_.materials = model.materials;
    remember_nodes(model);
    return false;
}

/// Are the nodes that the preconditioner knows the corners of the tets only?
bool StaticsSolver::goes_by_corners(const StaticsModel& model) const {
    return model.mesh.order == 2 && setup_.by != PreconditionedBy::factor;
}

void StaticsSolver::remember_nodes(const StaticsModel& model) {
    const auto count = std::ptrdiff_t(goes_by_corners(model) ? model.mesh.corner_count : model.mesh.node_count());
    setup_.nodes.assign(model.mesh.node_numbers.begin(), model.mesh.node_numbers.begin() + count);
    setup_.is_held.assign(model.is_held.begin(), model.is_held.begin() + 3 * count);
}

/// Which rows of the model's matrix the solver's has.
SameRows StaticsSolver::same_rows_of(const OrderedModel& ordered, RunContext& context) const {
    if (assembled_)
        return same_rows(ordered.model(), ordered.around(), assembled_->model(), assembled_->around(), context);
    return {std::vector<std::int32_t>(ordered.model().mesh.node_count(), -1), {}};
}

/// Changes the solver's matrices in place and keeps its preconditioner.
void StaticsSolver::carry_over(const Ordered& ordered, std::vector<std::int32_t> origin, RunContext& context) {
    const StaticsModel& model = ordered->model();
    const TetsOfNodes& around = ordered->around();
    LinearSolver::Matrices given;
    SameRows same;
    {
        RunContext::Step step(context, "assemble");
        same = same_rows_of(*ordered, context);
        assembled_.reset();  // until the solver has the next matrices
        given = solver_->give_matrices();
        given.finest = changed_stiffness(std::move(given.finest), same, model, around, context);
    }
    RunContext::Step step(context, "setup");
    std::optional<CoarseLevel> coarse;
    if (goes_by_corners(model)) coarse = coarse_level(model, around, context, std::move(given.coarse), &same);
    solver_->carry_over(std::move(given.finest), std::move(coarse), std::move(origin));
    assembled_ = ordered;
}

/// By node that the preconditioner knows that of the last set-up, -1 where it was not there or was held otherwise; all
/// -1 when nothing can be kept.
std::vector<std::int32_t> StaticsSolver::origins(const StaticsModel& model) const {
    const std::span<const Number> numbers = model.mesh.node_numbers;
    const std::size_t count = goes_by_corners(model) ? model.mesh.corner_count : numbers.size();
    if (!are_same(setup_.materials, model.materials)) return std::vector<std::int32_t>(count, -1);
    std::vector<std::int32_t> origin = earlier_nodes(numbers.first(count), setup_.nodes);
    leave_alike_held(origin, model.is_held, setup_.is_held);
    return origin;
}

/// Gives kept nodes their last displacements, and new ones such that they and the nodes round them are balanced among
/// the others: at rest they would be farther off than if nothing had moved.
StaticsSolver::Start StaticsSolver::start_from_last(const StaticsModel& model, const std::vector<double>& unbalanced,
                                                    StaticsSolution& solution, RunContext& context) const {
    const std::size_t count = model.mesh.node_count();
    std::vector<std::int32_t> fresh;
    std::vector<double> moved(3 * count, 0.0);
    const std::vector<std::int32_t> earlier = earlier_nodes(model.mesh.node_numbers, last_.nodes);
    for (std::size_t node = 0; node < count; ++node)
        if (earlier[node] < 0)
            fresh.push_back(std::int32_t(node));
        else
            for (std::size_t i = 3 * node, c = 0; c < 3; ++i, ++c)
                if (!model.is_held[i])
                    moved[i] = last_.displacements[3 * std::size_t(earlier[node]) + c] - model.given[i];
    if (double(fresh.size()) > most_fresh_share * double(count)) return {unbalanced, 0};
    move_with_kept(model, solver_->matrix(), fresh, moved);
    const std::vector<std::int32_t> balanced =
        with_neighbours(fresh, solver_->matrix(), balanced_layers, std::size_t(balanced_share * double(count)));
    solver_->balance_within(balanced, unbalanced, moved);
    Start start = start_at(moved, unbalanced, context);
    for (std::size_t i = 0; i < moved.size(); ++i) solution.displacements[i] += moved[i];
    if (start.least_energy_norm > 0) solution.kept_start_share = 1 - double(fresh.size()) / double(count);
    return start;
}

/// What `moved`, scaled to the loads as they are such that the error's energy is least, leaves of the unbalanced
/// forces.
StaticsSolver::Start StaticsSolver::start_at(std::vector<double>& moved, const std::vector<double>& unbalanced,
                                             RunContext& context) const {
    std::vector<double> resisting(moved.size());
    multiply(solver_->matrix(), moved.data(), resisting.data(), context);
    const double work = product(unbalanced, moved), energy = product(resisting, moved);
    double scale = work / energy;
    if (std::abs(scale - 1) < other_loads) scale = 1;
    if (!std::isfinite(scale) || std::abs(scale) < other_problem) {
        std::fill(moved.begin(), moved.end(), 0.0);
        return {unbalanced, 0};
    }
    std::vector<double> residual(moved.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[i] *= scale;
        residual[i] = unbalanced[i] - scale * resisting[i];
    }
    return {std::move(residual), energy > 0 ? std::abs(work) / std::sqrt(energy) : 0};
}

void StaticsSolver::start_from(std::span<const Number> numbers, std::span<const double> displacements) {
    if (displacements.size() != 3 * numbers.size()) throw InputError(say<Code::model_misfits>());
    if (!last_.nodes.empty()) return;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::span<const double> u = displacements.subspan(3 * i, 3);
        if (!std::isfinite(u[0] + u[1] + u[2])) continue;
        last_.nodes.push_back(numbers[i]);
        last_.displacements.insert(last_.displacements.end(), u.begin(), u.end());
    }
}

}  // namespace featuremesh
