// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/newton_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/stop.h"
#include "core/deform/solvers/finite_answer.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/rigid_motion.h"

namespace hepatica {
namespace {

constexpr double armijo = 1e-4;  // required share of the predicted decrease
constexpr double shortest_step_length = 1e-3;
// The shortest step length where a pad may be met: a resting contact is compressed by far less than
// a step's fall, so that the direction from just above the pad overshoots it by far.
constexpr double shortest_onto_pad = 1e-7;
// In mean edges: where no step even of this size lowers the potential, the body is at rest up to
// rounding errors or at a kink of the potential, and shorter steps would not move it either.
constexpr double at_rest = 1e-4;
constexpr double no_move = 8.0 * std::numeric_limits<double>::epsilon();  // of the coordinates
// In mean edges: a body that moves less than this in a step keeps its tension during the step.
constexpr double calm_move = 0.1;
constexpr double rounding = 1e-13;  // relative changes of energy below this are noise

// Iterates added to a linearly implicit step from rest that was shortened, until one is taken
// whole: taking only a share of the motion from rest would brake the whole body.
constexpr int rescue_iterates = 2;

// Norm of the longest vector; infinite where any is not finite.
double longest_of(const std::vector<Vec3>& vectors) {
    std::vector<double> squared(vectors.size() / nodes_per_block + 1, 0.0);
    parallel_blocks(vectors.size(), nodes_per_block, [&](std::size_t begin, std::size_t end) {
        double& longest = squared[begin / nodes_per_block];
        for (std::size_t i = begin; i < end; ++i)
            longest =
                vectors[i].allFinite() ? std::max(longest, vectors[i].squaredNorm()) : INFINITY;
    });
    return std::sqrt(*std::ranges::max_element(squared));
}

}  // namespace

NewtonStep::NewtonStep(const Body& body, IncrementalPotential& potential,
                       std::unique_ptr<LinearSolver> solver)
    : body_(body),
      potential_(potential),
      system_(body, potential, std::move(solver)),
      damping_(body, potential),
      change_(body.node_count()),
      product_(body.node_count()) {}

void NewtonStep::set_settings(const NewtonSettings& settings) {
    settings_ = settings;
    velocity_error_.set(settings.velocity_error);
    potential_.count_collapse(settings.tension);
    if (settings.tension) potential_.plan_tension();
}

// product_ = matrix * change_.
void NewtonStep::find_product_of_change() {
    if (const std::vector<Vec3>* known = system_.product())
        copy_nodes(*known, product_);
    else
        multiply(potential_.matrix(), change_, product_);
}

// Adds factor * matrix * x to the residual of the nodes that are not held.
void NewtonStep::add_to_free(double factor, const BlockMatrix& matrix, const std::vector<Vec3>& x) {
    multiply(matrix, x, product_);
    for_each_node(residual_.size(), [&](std::size_t i) {
        if (!potential_.held(i)) residual_[i] += factor * product_[i];
    });
}

void NewtonStep::add_coupling(const StepUnderway& step, std::span<const Vec3> d,
                              std::span<Vec3> product) const {
    step.potentials.add_coupling(step.positions, step.dt_s * step.dt_s, d, product);
}

void NewtonStep::solve(const StepUnderway& step, StepReport& report) {
    CouplingBlocks coupling;
    step.potentials.append_coupling(step.positions, step.dt_s * step.dt_s, coupling);
    // The first system is solved for the change of velocity, because its relative error is also
    // meaningful for a body in flight.
    if (step.iterate == 0 && !step.predicted) {
        add_to_free(-1.0, potential_.matrix(), step.start.velocities_mm_per_s);
        if (!coupling.empty()) {
            product_.assign(residual_.size(), Vec3::Zero());
            add_coupling(step, step.start.velocities_mm_per_s, product_);
            for_each_node(residual_.size(), [&](std::size_t i) { residual_[i] -= product_[i]; });
        }
        if (velocity_error_.any())
            add_to_free(1.0, velocity_error_.matrix(), step.start.velocities_mm_per_s);
    }
    const double share = velocity_error_.any() ? VelocityError::least_share
                                               : 1.0 + step.dt_s * body_.damping.alpha_per_s;
    const SolveReport solved =
        system_.solve(step, coupling, share, residual_, change_, settings_.linear);
    if (system_.factor_is_latest()) system_.keep_origin(origin_of(step));
    ++report.linear_solves;
    report.linear_iterations += solved.iterations;
    report.linear_residual = solved.relative_residual;
    report.linear_energy_error = solved.energy_error;
    report.dropped_pivots = std::max(report.dropped_pivots, solved.dropped_pivots);
    // Reaching the limit of iterations is no breakdown: a fixed number may be the setting.
    const bool broke_down =
        !solved.converged && solved.iterations < settings_.linear.max_iterations;
    if (!broke_down && solved.dropped_pivots == 0) return;
    report.degraded = true;
    report.message = solved.dropped_pivots > 0
                         ? "the system of the step was not positive definite: " +
                               std::to_string(solved.dropped_pivots) + " pivots were dropped"
                         : "the system of the step could not be solved";
}

// The inputs of the current system, for a checkpoint.
SolverCheckpoint NewtonStep::origin_of(const StepUnderway& step) const {
    SolverCheckpoint origin{
        .made_from =
            MatrixOrigin{.dt_s = step.dt_s,
                         .first_mm = damping_.first_mm(),
                         .iterate_mm = step.iterate > 0 ? step.positions : std::vector<Vec3>{},
                         .taut_mm = taut(step) ? step.start.positions_mm : std::vector<Vec3>{},
                         .collapse = potential_.collapse_counts(),
                         .held = potential_.live().held(),
                         .grabs = step.potentials.grabs(),
                         .gravity_mm_per_s2 = step.potentials.gravity_mm_per_s2(),
                         .velocity_error = settings_.velocity_error},
        .overlaps = step.potentials.surfaces().kept_overlaps()};
    if (step.potentials.tool())
        origin.tool = ToolOrigin{*step.potentials.tool(), step.start.positions_mm};
    if (step.potentials.obstacles() || step.potentials.self_friction())
        origin.began_mm = step.start.positions_mm;
    return origin;
}

// To be called while the assembly's slots hold the start of the step.
void NewtonStep::keep_linearised_work(StepUnderway& step) {
    std::vector<Vec3> dx(direction_.size());
    for_each_node(dx.size(), [&](std::size_t i) { dx[i] = step.dt_s * direction_[i]; });
    const double elastic_form = potential_.assembly().quadratic_form(dx);
    product_.assign(dx.size(), Vec3::Zero());
    step.potentials.add_product(step.positions, 1.0, dx, potential_.matrix(), product_);
    step.potentials.add_coupling(step.positions, 1.0, dx, product_);
    step.linearised.start_force = dot(dx, step.start_force);
    step.linearised.curvature = elastic_form + dot(dx, product_);
    damping_.take_from_rest(step, elastic_form);
    find_product_of_change();
    add_coupling(step, change_, product_);
    step.linearised.residual = dot(direction_, product_) - dot(direction_, residual_);
    if (!velocity_error_.any()) return;
    multiply(velocity_error_.matrix(), change_, product_);
    step.linearised.residual -= dot(direction_, product_);
}

bool NewtonStep::try_step_length(StepUnderway& step, double step_length, double slope) {
    copy_nodes(step.velocity, velocity_before_);
    // Where another iterate will follow, the stiffness is evaluated together with the forces, which
    // is cheaper than evaluating all elements again later.
    const int iterates_on = !step.predicted ? rescue_iterates : taut(step) ? 1 : 0;
    const bool goes_on =
        step_length < 1.0 && settings_.iterations == 1 && step.iterate < iterates_on;
    for_each_node(step.velocity.size(), [&](std::size_t i) {
        step.velocity[i] += step_length * direction_[i];
        step.positions[i] = step.start.positions_mm[i] + step.dt_s * step.velocity[i];
    });
    if (all_finite(step.positions)) {
        damping_.advance(step, step_length);
        if (goes_on)
            potential_.evaluate(step.positions);
        else
            potential_.evaluate_forces(step.positions);
        const double value = potential_.value(step);
        const double noise = rounding * (std::abs(value) + std::abs(step.value));
        if (std::isfinite(value) && value <= step.value + armijo * step_length * slope + noise) {
            step.value = std::min(value, step.value);
            return true;
        }
        if (!settings_.line_search && std::isfinite(value)) return true;
    }
    copy_nodes(velocity_before_, step.velocity);
    damping_.release(step);
    return false;
}

// Whether there is contact, or the last direction was shortened to prevent passing through.
bool NewtonStep::meets_pads(const StepUnderway& step) const {
    return step.free < 1.0 || step.potentials.touches(step.positions);
}

// The share of the direction that can be taken without passing through anything.
double NewtonStep::free_length(const StepUnderway& step) const {
    std::vector<Vec3> whole(step.positions.size());
    for_each_node(whole.size(),
                  [&](std::size_t i) { whole[i] = step.positions[i] + step.dt_s * direction_[i]; });
    return all_finite(whole) ? step.potentials.free_share(step.positions, whole) : 1.0;
}

// False where no step length along the direction lowers the potential; the iterate is then
// unchanged.
bool NewtonStep::search_line(StepUnderway& step) {
    const double slope = -dot(steepest_, direction_);  // of the potential, along the direction
    damping_.hold(step);
    step.free = free_length(step);
    const double shortest = meets_pads(step) ? shortest_onto_pad : shortest_step_length;
    for (double length = step.free; length > shortest; length *= 0.5) {
        throw_if_stopped(step.stop);
        if (!try_step_length(step, length, slope)) continue;
        step.step_length = length;
        step.whole = step.iterate == 0 && !step.predicted && length == 1.0 &&
                     !potential_.collapsed() && !taut(step);
        return true;
    }
    for (std::size_t i = 0; i < step.positions.size(); ++i)
        step.positions[i] = step.start.positions_mm[i] + step.dt_s * step.velocity[i];
    potential_.evaluate_forces(step.positions);
    return false;
}

bool NewtonStep::iterate(StepUnderway& step, StepReport& report) {
    throw_if_stopped(step.stop);
    if (step.iterate == 0) damping_.begin(step.positions);
    if (step.iterate == 1) damping_.keep(step, velocity_error());
    potential_.descent(step, residual_);
    potential_.assemble(step);
    if (step.iterate == 0 && step.predicted) {
        damping_.add_at_start(step, residual_);
        // With damping counted, the predicted velocity may be worse than rest.
        if (step.value > step.standing) {
            stay_at_start(step);
            return iterate(step, report);
        }
    }
    copy_nodes(residual_, steepest_);
    if (step.iterate == 0 && taut(step)) potential_.add_tension(step.dt_s);
    if (step.iterate == 0 && velocity_error_.any())
        velocity_error_.add_to(potential_, body_, step.dt_s);
    solve(step, report);
    ++report.newton_iterations;
    copy_nodes(change_, direction_);
    if (step.iterate == 0 && step.predicted) {
        if (damping_.any()) {
            find_product_of_change();
            damping_.take(step, direction_, product_, velocity_error());
        }
    } else if (step.iterate == 0) {
        for_each_node(change_.size(),
                      [&](std::size_t i) { direction_[i] += step.start.velocities_mm_per_s[i]; });
        keep_linearised_work(step);
    }
    return still(step) || search_line(step);
}

bool NewtonStep::calm(const StepUnderway& step) const {
    return step.dt_s * longest_of(step.start.velocities_mm_per_s) < calm_move * body_.mean_edge_mm;
}

// From rest to rest: no position would change, so no step length need be tried.
bool NewtonStep::still(const StepUnderway& step) const {
    return settings_.line_search && step.iterate == 0 && !step.predicted &&
           std::isfinite(step.value) &&
           step.dt_s * longest_of(direction_) <= no_move * longest_of(step.start.positions_mm);
}

// Takes the present velocity as the initial guess, unless the body is at rest or the incremental
// potential is higher there than at velocity 0.
void NewtonStep::predict(StepUnderway& step) {
    const std::vector<Vec3>& velocity = step.start.velocities_mm_per_s;
    if (std::ranges::all_of(velocity, [](const Vec3& v) { return v.isZero(0.0); })) return;
    if (begin_at(step, velocity)) return;
    const bool meets = all_finite(step.positions) && step.potentials.self() &&
                       !step.potentials.tool() &&
                       (step.potentials.coupled(step.positions) ||
                        step.potentials.free_share(step.start.positions_mm, step.positions) < 1.0);
    if (meets)
        if (const auto common = common_velocity(body_.mass_g, potential_.live().held(), velocity);
            common && begin_at(step, *common)) {
            step.together = true;
            return;
        }
    stay_at_start(step);
}

// False where contact blocks that motion, or the potential is higher than at rest.
bool NewtonStep::begin_at(StepUnderway& step, const std::vector<Vec3>& velocity) {
    for_each_node(velocity.size(), [&](std::size_t i) {
        step.velocity[i] = velocity[i];
        step.positions[i] = step.start.positions_mm[i] + step.dt_s * velocity[i];
    });
    step.predicted = true;
    if (!all_finite(step.positions) ||
        step.potentials.free_share(step.start.positions_mm, step.positions) < 1.0)
        return false;
    potential_.evaluate(step.positions);
    step.value = potential_.value(step);
    return step.value <= step.standing;
}

void NewtonStep::stay_at_start(StepUnderway& step) {
    step.predicted = step.together = false;
    step.value = step.standing;
    step.iterate = 0;
    step.step_length = 1.0;
    std::ranges::fill(step.velocity, Vec3::Zero());
    step.positions = step.start.positions_mm;
    step.damping_force.clear();
    step.damping_form = 0.0;
    potential_.evaluate(step.positions);
}

bool NewtonStep::find_velocity(StepUnderway& step, int most_solves, StepReport& report) {
    system_.heed(step.stop);
    step.start_force = potential_.elastic_force();
    step.potentials.add_forces(step.positions, step.start_force);
    step.standing = step.value;
    if (settings_.tension) potential_.find_tension();
    if (settings_.line_search) predict(step);
    if (iterate_from_here(step, most_solves, report)) {
        report.predicted = step.predicted;
        return true;
    }
    if (step.predicted) stay_at_start(step);
    return false;
}

bool NewtonStep::replace_velocity(StepUnderway& step, const std::vector<Vec3>& velocity) {
    std::vector<Vec3> positions(velocity.size());
    for_each_node(velocity.size(), [&](std::size_t i) {
        positions[i] = step.start.positions_mm[i] + step.dt_s * velocity[i];
    });
    if (step.potentials.free_share(step.start.positions_mm, positions) < 1.0) return false;
    step.velocity = velocity;
    step.positions = std::move(positions);
    step.whole = false;
    damping_.find_again(step, velocity_error());
    potential_.evaluate_forces(step.positions);
    step.value = potential_.value(step);
    return true;
}

// How many iterates may follow a single one that was shortened.
int NewtonStep::iterates_after_cut(const StepUnderway& step) const {
    if (!step.predicted || meets_pads(step)) return rescue_iterates;
    return taut(step) ? 1 : 0;
}

// False where no step length lowers the potential along the first direction.
bool NewtonStep::iterate_from_here(StepUnderway& step, int most_solves, StepReport& report) {
    int most = std::min(settings_.iterations, most_solves);
    for (;; ++step.iterate) {
        const bool lower = iterate(step, report);
        const double longest = step.dt_s * longest_of(direction_);
        if (!lower) {
            // Where the potential overflows, the direction is meaningless.
            if (step.iterate == 0)
                return std::isfinite(step.value) && longest <= at_rest * body_.mean_edge_mm;
            break;
        }
        if (longest <= settings_.tolerance * body_.mean_edge_mm) return true;
        if (settings_.iterations == 1)
            most = step.step_length < 1.0 ? std::min(1 + iterates_after_cut(step), most_solves) : 1;
        if (step.iterate + 1 >= most) break;
    }
    if (step.step_length < 1.0) {
        report.degraded = report.shortened = true;
        report.message = "the step was shortened: it would have made energy";
    }
    return true;
}

}  // namespace hepatica
