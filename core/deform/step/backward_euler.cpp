// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/backward_euler.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/deform/potentials/obstacle_contact.h"
#include "core/deform/potentials/self_contact.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/declined_pieces.h"
#include "core/deform/step/momentum_check.h"

namespace hepatica {
namespace {

constexpr int most_halvings = 4;
constexpr int most_impacts = 3;
constexpr double least_part = 0.05;  // of the rest of a step

// Fills the loads of tools, surfaces and obstacles at the end of a step.
void report_touch(const std::vector<Vec3>& end_mm, double dt_s, const PotentialList& potentials,
                  StepReport& report) {
    report.tool = potentials.tool_load(end_mm, dt_s);
    if (potentials.self()) {
        report.self = load_of(potentials.self()->contacts(end_mm));
        report.self_cost = potentials.self()->pairs().take_cost();
    }
    if (potentials.obstacles()) {
        report.obstacles = potentials.obstacle_load(end_mm);
        report.obstacles.impulse_un_s = dt_s * report.obstacles.force_un;
        report.obstacle_cost = potentials.obstacles()->pairs().take_cost();
    }
}

}  // namespace

BackwardEuler::BackwardEuler(const Body& body, const NewtonSettings& settings,
                             std::unique_ptr<LinearSolver> solver)
    : body_(body),
      settings_(settings),
      potential_(body,
                 settings.iterations > 1 ? small::Tangent::projected : small::Tangent::rotated) {
    make_parts(std::move(solver));
}

void BackwardEuler::make_parts(std::unique_ptr<LinearSolver> solver) {
    newton_.emplace(body_, potential_, std::move(solver));
    books_.emplace(body_, potential_);
    limiter_.emplace(body_, potential_.assembly().plan());
    set_settings(settings_);
}

void BackwardEuler::follow_split(const Body& before, std::span<const int> parents) {
    std::unique_ptr<LinearSolver> solver = newton_->release_solver();
    solver->follow_split(potential_.matrix(), parents);
    potential_.follow_split(before);
    make_parts(std::move(solver));
}

void BackwardEuler::set_settings(const NewtonSettings& settings) {
    settings_ = settings;
    newton_->set_settings(settings);
    forget();
}

void BackwardEuler::freeze(std::span<const std::uint8_t> frozen) {
    potential_.freeze(frozen);
    forces_known_ = false;
}

double BackwardEuler::potential_energy(std::span<const Vec3> positions_mm,
                                       const PotentialList& potentials) const {
    return potential_.assembly().energy(positions_mm) +
           potentials.energy(positions_mm, body_.rest_positions_mm);
}

void BackwardEuler::know_forces(const BodyState& state) {
    if (!energies_known_)
        potential_.evaluate_all_forces(state.positions_mm);
    else if (!forces_known_)
        potential_.evaluate_forces(state.positions_mm);
    energies_known_ = forces_known_ = true;
}

void BackwardEuler::find_stress(const BodyState& state, std::vector<Mat3>& stress_pa,
                                std::vector<double>& energy_nj) {
    know_forces(state);
    potential_.assembly().find_stress(stress_pa, energy_nj);
}

StepReport BackwardEuler::advance(BodyState& state, double dt_s, const PotentialList& potentials,
                                  const std::stop_token& stop) {
    stop_ = stop;
    const int halvings = settings_.line_search ? most_halvings : 0;
    std::optional<StepReport> report;
    double left_s = dt_s;
    int solves_left = settings_.iterations + settings_.extra_solves;
    const bool meets = potentials.tool() || potentials.self() || potentials.obstacles();
    for (int impacts_left = meets ? most_impacts : 0;; --impacts_left) {
        double part_s = left_s;
        if (impacts_left > 0 && solves_left >= 2)
            part_s *= std::max(least_part, share_until_touch(state, left_s, potentials));
        const bool last = part_s >= left_s;
        const StepReport part = advance_in_parts(state, part_s, potentials, halvings,
                                                 last ? solves_left : (solves_left + 1) / 2);
        report = report ? in_sequence(*report, part) : part;
        if (last) return *report;
        solves_left -= part.linear_solves;
        left_s -= part_s;
    }
}

double BackwardEuler::share_until_touch(const BodyState& state, double dt_s,
                                        const PotentialList& potentials) const {
    std::vector<Vec3> ahead(state.positions_mm.size());
    for_each_node(ahead.size(), [&](std::size_t i) {
        ahead[i] = state.positions_mm[i] + dt_s * state.velocities_mm_per_s[i];
    });
    return potentials.share_until_touch(state.positions_mm, ahead);
}

MomentumLost BackwardEuler::limit_energy(const StepUnderway& step, std::vector<Vec3>& velocities,
                                         StepReport& report) {
    const auto outcome = limiter_->limit(step, report.energy, potential_.assembly(),
                                         potential_.live().held(), velocities);
    if (outcome.limited) hepatica::book(outcome, kinetic_energy(body_, velocities), report);
    return outcome.lost;
}

// The line search treats all pieces together, which has two faults: energy lost by some pieces may
// pay for energy that another one gained, more than that one can give back; and where the step is
// shortened for one piece, another one in free flight would lose momentum. Such pieces do not take
// the step, unless they would then meet something. At the end without them others may be pressed
// together, so that it is judged again until nothing is overdrawn there.
bool BackwardEuler::decline(StepUnderway& step, StepReport& report) {
    std::optional<DeclinedPieces> declined;
    for (;;) {
        const auto overdrawn =
            limiter_->overdrawn(step, potential_.assembly(), potential_.live().held());
        if (overdrawn.empty()) return true;
        if (!declined) declined.emplace(body_, *limiter_, step);
        if (!declined->add(overdrawn) || !newton_->replace_velocity(step, declined->velocities()))
            return std::ranges::none_of(overdrawn, &EnergyLimiter::Overdrawn::unpaid);
        limiter_->forget_end();
        report.degraded = true;
        report.message =
            "a piece went on without the step's forces: they would have made energy or "
            "taken its momentum";
    }
}

// Ends the step where it began, which makes no energy.
void BackwardEuler::stand_still(StepUnderway& step, StepReport& report) {
    newton_->replace_velocity(step, std::vector<Vec3>(step.velocity.size(), Vec3::Zero()));
    limiter_->forget_end();
    report.degraded = true;
    report.message = "the body was stopped: no step lowers its energy";
}

// Repeats the step as two halves. `tried` is the report of the attempt at the whole step.
StepReport BackwardEuler::advance_in_halves(BodyState& state, double dt_s,
                                            const PotentialList& potentials, int halvings_left,
                                            int solves_left, const StepReport& tried) {
    // The budget of solves is shared evenly; an odd one goes to the first half.
    const StepReport first =
        advance_in_parts(state, 0.5 * dt_s, potentials, halvings_left - 1, (solves_left + 1) / 2);
    const StepReport second = advance_in_parts(state, 0.5 * dt_s, potentials, halvings_left - 1,
                                               solves_left - first.linear_solves);
    StepReport halves = in_sequence(first, second);
    halves.newton_iterations += tried.newton_iterations;
    halves.linear_solves += tried.linear_solves;
    halves.linear_iterations += tried.linear_iterations;
    halves.dropped_pivots = std::max(halves.dropped_pivots, tried.dropped_pivots);
    halves.degraded = true;
    if (halves.message.empty())
        halves.message = "the step was cut in halves: it would have made energy";
    return halves;
}

StepReport BackwardEuler::advance_in_parts(BodyState& state, double dt_s,
                                           const PotentialList& potentials, int halvings_left,
                                           int most_solves) {
    know_forces(state);
    potentials.begin_step(state, dt_s, potential_.live().held());
    StepReport report;
    report.dt_s = dt_s;
    StepUnderway step{.potentials = potentials,
                      .start = state,
                      .dt_s = dt_s,
                      .before = books_->energies(state, potentials),
                      .velocity = std::vector<Vec3>(state.positions_mm.size(), Vec3::Zero()),
                      .positions = state.positions_mm,
                      .stop = stop_};
    step.value = potential_.value(step);
    if (settings_.line_search) limiter_->begin(step, potential_.assembly());
    const bool stuck = !newton_->find_velocity(step, most_solves, report);
    const int solves_left = most_solves - report.linear_solves;
    const bool may_halve = halvings_left > 0 && solves_left >= 2;
    if (stuck && may_halve)
        return advance_in_halves(state, dt_s, potentials, halvings_left, solves_left, report);
    if (stuck) {
        report.degraded = true;
        report.message = "the body was stopped: no step lowers its energy";
    }
    const auto in_halves = [&] {
        forget();
        return advance_in_halves(state, dt_s, potentials, halvings_left, solves_left, report);
    };
    if (settings_.line_search && !decline(step, report)) {
        if (may_halve) return in_halves();
        stand_still(step, report);
    }
    books_->book(step, *newton_, settings_.audit, report);
    std::vector<Vec3> velocities = std::move(step.velocity);
    if (settings_.line_search) {
        const MomentumLost lost = limit_energy(step, velocities, report);
        // The limiter would destroy the momentum that surfaces exchanged; a shorter step keeps it.
        if (lost == MomentumLost::linear && potentials.self() && may_halve) return in_halves();
    }
    if (potentials.self() || potentials.ties()) {
        const MomentumBalance balance = momentum_balance(body_, step, potential_.live().held(),
                                                         velocities, potential_.elastic_force());
        report.momentum_error_g_mm_per_s = balance.error_g_mm_per_s;
        report.momentum_exchanged_g_mm_per_s = balance.exchanged_g_mm_per_s;
    }
    state.velocities_mm_per_s = std::move(velocities);
    state.positions_mm = std::move(step.positions);
    report_touch(state.positions_mm, dt_s, potentials, report);
    return report;
}

}  // namespace hepatica
