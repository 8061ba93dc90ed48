// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/newton_step.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/deform/solvers/node_loops.h"
#include "core/deform/stepper/stepper_input.h"

namespace hepatica {
namespace {

constexpr double armijo = 1e-4;  // of the predicted decrease must come true
constexpr double shortest_step_length = 1e-3;
constexpr double at_rest = 1e-9;    // a move in mean edges that is rounding errors alone
constexpr double rounding = 1e-13;  // relative size of a change of energy that means nothing
// Iterates added to a linearly implicit step that had to be shortened, until one is taken whole.
constexpr int rescue_iterates = 8;

bool all_finite(const std::vector<Vec3>& a) {
    return std::ranges::all_of(a, [](const Vec3& x) { return x.allFinite(); });
}

std::vector<Vec3> times(double factor, const std::vector<Vec3>& a) {
    std::vector<Vec3> product(a.size());
    for_each_node(a.size(), [&](std::size_t i) { product[i] = factor * a[i]; });
    return product;
}

}  // namespace

NewtonStep::NewtonStep(const Body& body, IncrementalPotential& potential,
                       std::unique_ptr<LinearSolver> solver)
    : body_(body),
      potential_(potential),
      solver_(std::move(solver)),
      change_(body.node_count()),
      product_(body.node_count()) {}

void NewtonStep::set_settings(const NewtonSettings& settings) {
    settings_ = settings;
    velocity_error_.set(settings.velocity_error);
}

void NewtonStep::keep_damping(const StepUnderway& step) {
    if (body_.damping.beta_s > 0.0)
        potential_.keep_damping(step, velocity_error_.any() ? &velocity_error_.matrix() : nullptr);
}

void NewtonStep::solve(const StepUnderway& step, StepReport& report) {
    solver_->prepare(potential_.matrix(), step.positions);
    // The first system is solved for the change of velocity, whose relative error means something
    // for a body in flight, too.
    if (step.iterate == 0) {
        multiply(potential_.matrix(), step.start.velocities_mm_per_s, product_);
        for_each_node(residual_.size(), [&](std::size_t i) {
            if (!body_.fixed[i]) residual_[i] -= product_[i];
        });
    }
    std::ranges::fill(change_, Vec3::Zero());
    const SolveReport solved = solver_->solve(residual_, change_, settings_.linear);
    if (solver_->made_from_latest()) made_from_ = origin_of(step);
    ++report.linear_solves;
    report.linear_iterations += solved.iterations;
    report.linear_residual = solved.relative_residual;
    report.linear_energy_error = solved.energy_error;
    report.dropped_pivots = std::max(report.dropped_pivots, solved.dropped_pivots);
    // One that has used up its iterations has done what it was told.
    const bool broke_down =
        !solved.converged && solved.iterations < settings_.linear.max_iterations;
    if (!broke_down && solved.dropped_pivots == 0) return;
    report.degraded = true;
    report.message = solved.dropped_pivots > 0
                         ? "the system of the step was not positive definite: " +
                               std::to_string(solved.dropped_pivots) + " pivots were dropped"
                         : "the system of the step could not be solved";
}

MatrixOrigin NewtonStep::origin_of(const StepUnderway& step) const {
    return {.dt_s = step.dt_s,
            .start_mm = step.start.positions_mm,
            .iterate_mm = step.iterate > 0 ? step.positions : std::vector<Vec3>{},
            .grabs = step.potentials.grabs(),
            .velocity_error = settings_.velocity_error};
}

// Assembles the potential's matrix as the step that `origin` is of did.
void NewtonStep::assemble_again(const MatrixOrigin& origin) {
    validate_time_step(origin.dt_s);
    const std::size_t nodes = body_.rest_positions_mm.size();
    validate_state(origin.start_mm, origin.start_mm, nodes);
    const bool first = origin.iterate_mm.empty();
    if (!first) validate_state(origin.iterate_mm, origin.iterate_mm, nodes);
    PotentialList potentials(body_);
    potentials.set_grabs(origin.grabs);
    VelocityError error;
    error.set(origin.velocity_error);
    const BodyState start{origin.start_mm, std::vector<Vec3>(nodes, Vec3::Zero())};
    StepUnderway step{.potentials = potentials,
                      .start = start,
                      .dt_s = origin.dt_s,
                      .before = {},
                      .velocity = {},
                      .positions = origin.start_mm};
    potential_.evaluate(step.positions);
    potential_.assemble(step);
    residual_.assign(nodes, Vec3::Zero());
    if (error.any()) error.add_to(potential_, body_, step, residual_);
    if (first) return;
    if (body_.damping.beta_s > 0.0)
        potential_.keep_damping(step, error.any() ? &error.matrix() : nullptr);
    step.iterate = 1;
    step.positions = origin.iterate_mm;
    potential_.evaluate(step.positions);
    potential_.assemble(step);
}

void NewtonStep::restore(const SolverCheckpoint& checkpoint) {
    const std::optional<MatrixOrigin>& origin = checkpoint.made_from;
    if (origin) assemble_again(*origin);
    const std::vector<Vec3> none;
    const bool first = !origin || origin->iterate_mm.empty();
    solver_->restore(origin ? &potential_.matrix() : nullptr,
                     !origin ? none : (first ? origin->start_mm : origin->iterate_mm),
                     checkpoint.memory);
    made_from_ = origin;
}

// While the slots are those of the start.
void NewtonStep::keep_linearised_work(StepUnderway& step) {
    const std::vector<Vec3> dx = times(step.dt_s, direction_);
    const double elastic_form = potential_.assembly().quadratic_form(dx);
    const double external_form =
        step.potentials.quadratic_form(step.positions, dx, potential_.matrix());
    step.linearised.start_force = dot(dx, step.start_force);
    step.linearised.curvature = elastic_form + external_form;
    direction_form_ = body_.damping.beta_s * elastic_form / (step.dt_s * step.dt_s);
    multiply(potential_.matrix(), change_, product_);
    step.linearised.residual = dot(direction_, product_) - dot(direction_, residual_);
    if (!velocity_error_.any()) return;
    multiply(velocity_error_.matrix(), change_, product_);
    step.linearised.residual -= dot(direction_, product_);
}

bool NewtonStep::try_step_length(StepUnderway& step, double step_length, double slope) {
    const std::vector<Vec3> before = step.velocity;
    const double form_before = step.damping_form;
    for_each_node(step.velocity.size(), [&](std::size_t i) {
        step.velocity[i] += step_length * direction_[i];
        step.positions[i] = step.start.positions_mm[i] + step.dt_s * step.velocity[i];
    });
    if (all_finite(step.positions)) {
        if (body_.damping.beta_s > 0.0)
            step.damping_form = step.iterate == 0 ? step_length * step_length * direction_form_
                                                  : potential_.damping_form(step.velocity);
        potential_.evaluate(step.positions);
        const double value = potential_.value(step);
        const double noise = rounding * (std::abs(value) + std::abs(step.value));
        if (std::isfinite(value) && value <= step.value + armijo * step_length * slope + noise) {
            step.value = std::min(value, step.value);
            return true;
        }
        if (!settings_.line_search && std::isfinite(value)) return true;
    }
    step.velocity = before;
    step.damping_form = form_before;
    return false;
}

// False where no step length along the direction lowers the potential; the iterate is then as
// before.
bool NewtonStep::search_line(StepUnderway& step) {
    const double slope = -dot(steepest_, direction_);  // of the potential, along the direction
    for (double length = 1.0; length > shortest_step_length; length *= 0.5)
        if (try_step_length(step, length, slope)) {
            step.step_length = length;
            step.whole = step.iterate == 0 && length == 1.0;
            return true;
        }
    for (std::size_t i = 0; i < step.positions.size(); ++i)
        step.positions[i] = step.start.positions_mm[i] + step.dt_s * step.velocity[i];
    potential_.evaluate(step.positions);
    return false;
}

bool NewtonStep::iterate(StepUnderway& step, StepReport& report) {
    if (step.iterate == 1) keep_damping(step);
    potential_.descent(step, residual_);
    if (step.iterate == 0) step.start_force = potential_.force();
    potential_.assemble(step);
    steepest_ = residual_;
    if (step.iterate == 0 && velocity_error_.any())
        velocity_error_.add_to(potential_, body_, step, residual_);
    solve(step, report);
    ++report.newton_iterations;
    direction_ = change_;
    if (step.iterate == 0) {
        for_each_node(change_.size(),
                      [&](std::size_t i) { direction_[i] += step.start.velocities_mm_per_s[i]; });
        keep_linearised_work(step);
    }
    return search_line(step);
}

double NewtonStep::longest_move_mm(const StepUnderway& step) const {
    double squared = 0.0;
    for (const Vec3& d : direction_) {
        if (!d.allFinite()) return INFINITY;
        squared = std::max(squared, d.squaredNorm());
    }
    return step.dt_s * std::sqrt(squared);
}

bool NewtonStep::find_velocity(StepUnderway& step, int most_solves, StepReport& report) {
    int most = std::min(settings_.iterations, most_solves);
    for (;; ++step.iterate) {
        const bool lower = iterate(step, report);
        const double longest = longest_move_mm(step);
        if (!lower) {
            // At rest the potential is rounding errors, and no direction lowers it for certain.
            // Where it overflows there is no direction at all.
            if (step.iterate == 0)
                return std::isfinite(step.value) && longest <= at_rest * body_.mean_edge_mm;
            break;
        }
        if (longest <= settings_.tolerance * body_.mean_edge_mm) return true;
        if (settings_.iterations == 1)
            most = step.step_length < 1.0 ? std::min(1 + rescue_iterates, most_solves) : 1;
        if (step.iterate + 1 >= most) break;
    }
    if (step.step_length < 1.0) {
        report.degraded = true;
        report.message = "the step was shortened: it would have made energy";
    }
    return true;
}

}  // namespace hepatica
