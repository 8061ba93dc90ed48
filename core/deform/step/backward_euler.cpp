// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/backward_euler.h"

#include <algorithm>
#include <cmath>

#include "core/deform/step/node_loops.h"
#include "core/deform/stepper/stepper_input.h"

namespace hepatica {
namespace {

constexpr double armijo = 1e-4;          // share of the predicted decrease that must come true
constexpr double shortest_share = 1e-3;  // of a Newton step before the search gives up
constexpr double at_rest = 1e-9;         // a move in mean edges that is rounding errors alone
constexpr double rounding = 1e-13;       // relative size of a change of energy that means nothing
constexpr int most_halvings = 4;
// Iterates added to a linearly implicit step that had to be shortened, until one is taken whole.
constexpr int rescue_iterates = 8;

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return sum_over_nodes(a.size(), [&](std::size_t i) { return a[i].dot(b[i]); });
}

double gravity_work(const Body& body, const Vec3& gravity, const std::vector<Vec3>& d) {
    return sum_over_nodes(d.size(),
                          [&](std::size_t i) { return body.mass_g[i] * gravity.dot(d[i]); });
}

bool all_finite(const std::vector<Vec3>& a) {
    return std::ranges::all_of(a, [](const Vec3& x) { return x.allFinite(); });
}

std::vector<Vec3> times(double factor, const std::vector<Vec3>& a) {
    std::vector<Vec3> product(a.size());
    for_each_node(a.size(), [&](std::size_t i) { product[i] = factor * a[i]; });
    return product;
}

// E may be negative, but a tenth of inertia and of stiffness stay in the matrix.
RayleighDamping bounded_below(const RayleighDamping& error, const RayleighDamping& damping,
                              double dt_s) {
    constexpr double least = 0.1;
    return {std::max(error.alpha_per_s, (least - 1.0) / dt_s - damping.alpha_per_s),
            std::max(error.beta_s, (least - 1.0) * dt_s - damping.beta_s)};
}

}  // namespace

double kinetic_energy(const Body& body, const std::vector<Vec3>& velocities_mm_per_s) {
    return sum_over_nodes(velocities_mm_per_s.size(), [&](std::size_t i) {
        return 0.5 * body.mass_g[i] * velocities_mm_per_s[i].squaredNorm();
    });
}

// The step in the making. Its unknown is the velocity w: positions are x_n + dt w.
struct BackwardEuler::Step {
    const ExternalForces& forces;
    const BodyState& start;
    double dt_s;
    double start_kinetic = 0.0, start_elastic = 0.0, start_external = 0.0;
    std::vector<Vec3> w = {};          // accepted so far; 0 at first
    std::vector<Vec3> x;               // x_n + dt w
    std::vector<Vec3> direction = {};  // of w
    double value = 0.0;                // of the potential at w
    double damping_form = 0.0;         // w^T K_n w beta
    double direction_form = 0.0;       // the same of the first direction
    int iterate = 0;
    double share = 1.0;  // of the last direction that was taken
    bool whole = false;  // one iterate, taken whole: the linearised equations hold
    // What the linearised step did, from the slots of its start.
    double linear_elastic_work = 0.0, linear_external_work = 0.0, residual_work = 0.0;
    double velocity_scale = 1.0;
};

BackwardEuler::BackwardEuler(const Body& body, const NewtonSettings& settings,
                             std::unique_ptr<LinearSolver> solver)
    : body_(body),
      solver_(std::move(solver)),
      assembly_(body,
                settings.iterations > 1 ? small::Tangent::projected : small::Tangent::rotated),
      elastic_force_(body.node_count()),
      force_(body.node_count()),
      residual_(body.node_count()),
      change_(body.node_count()),
      product_(body.node_count()) {
    set_settings(settings);
    const BlockMatrix& pattern = assembly_.pattern();
    for (int i = 0; i < pattern.rows(); ++i)
        for (int k = pattern.row_begin[i]; k < pattern.row_begin[i + 1]; ++k) {
            const int j = pattern.column[k];
            if (i != j && (body.fixed[i] || body.fixed[j])) cut_blocks_.push_back(k);
        }
}

void BackwardEuler::set_settings(const NewtonSettings& settings) {
    settings_ = settings;
    has_error_ =
        settings.velocity_error.alpha_per_s != 0.0 || settings.velocity_error.beta_s != 0.0;
    forget();
}

void BackwardEuler::evaluate(const std::vector<Vec3>& positions_mm) {
    elastic_ = assembly_.evaluate(positions_mm);
    assembly_.gather_forces(elastic_force_);
}

// A = (1 + dt alpha) M + dt beta K_n + dt^2 K + dt^2 K_external, with K at the present iterate and
// K_n at the start.
void BackwardEuler::assemble(const Step& step) {
    const double dt = step.dt_s, beta = body_.damping.beta_s;
    assembly_.gather_stiffness(step.iterate == 0 ? dt * dt + dt * beta : dt * dt, matrix_);
    if (step.iterate > 0 && beta > 0.0)
        for_each_node(matrix_.block.size(),
                      [&](std::size_t k) { matrix_.block[k] += dt * damping_.block[k]; });
    const double inertia = 1.0 + dt * body_.damping.alpha_per_s;
    for_each_node(step.x.size(), [&](std::size_t i) {
        matrix_.block[matrix_.diagonal[i]].diagonal().array() += inertia * body_.mass_g[i];
    });
    step.forces.add_stiffness(step.x, dt * dt, matrix_);
    // Fixed vertices are cut out of the system: their change is 0 and nobody feels it.
    for (const int k : cut_blocks_) matrix_.block[k].setZero();
    for (int i = 0; i < matrix_.rows(); ++i)
        if (body_.fixed[i]) {
            Mat3& block = matrix_.block[matrix_.diagonal[i]];
            block = (block.trace() / 3.0) * Mat3::Identity();
        }
}

// Puts dt E into the first iterate's matrix and dt E v_n on the right hand side, so that E meets
// the change of velocity alone.
void BackwardEuler::add_velocity_error(const Step& step) {
    const RayleighDamping error = bounded_below(settings_.velocity_error, body_.damping, step.dt_s);
    assembly_.gather_stiffness(step.dt_s * error.beta_s, error_matrix_);
    for (int i = 0; i < error_matrix_.rows(); ++i)
        error_matrix_.block[error_matrix_.diagonal[i]].diagonal().array() +=
            step.dt_s * error.alpha_per_s * body_.mass_g[i];
    for (const int k : cut_blocks_) error_matrix_.block[k].setZero();
    for (std::size_t k = 0; k < matrix_.block.size(); ++k)
        matrix_.block[k] += error_matrix_.block[k];
    multiply(error_matrix_, step.start.velocities_mm_per_s, product_);
    for (std::size_t i = 0; i < residual_.size(); ++i)
        if (!body_.fixed[i]) residual_[i] += product_[i];
}

// Takes beta K_n back out of the first iterate's matrix, before that is overwritten. Fixed vertices
// do not move, so that it does not matter that they were cut out of it.
void BackwardEuler::keep_damping(const Step& step) {
    const double dt = step.dt_s, beta = body_.damping.beta_s;
    damping_ = matrix_;
    for (std::size_t k = 0; has_error_ && k < damping_.block.size(); ++k)
        damping_.block[k] -= error_matrix_.block[k];
    const double inertia = 1.0 + dt * body_.damping.alpha_per_s;
    for_each_node(body_.mass_g.size(), [&](std::size_t i) {
        damping_.block[damping_.diagonal[i]].diagonal().array() -= inertia * body_.mass_g[i];
    });
    step.forces.add_stiffness(step.start.positions_mm, -dt * dt, damping_);
    const double scale = beta / (dt * dt + dt * beta);
    for_each_node(damping_.block.size(), [&](std::size_t k) { damping_.block[k] *= scale; });
}

// -dt times the gradient of the potential at the present iterate:
// M (v_n - w) + dt f(x) - dt B w.
void BackwardEuler::right_hand_side(const Step& step) {
    const double dt = step.dt_s, alpha = body_.damping.alpha_per_s;
    force_ = elastic_force_;
    step.forces.add_forces(step.x, force_);
    const bool damped = step.iterate > 0 && body_.damping.beta_s > 0.0;
    if (damped) multiply(damping_, step.w, product_);
    for_each_node(residual_.size(), [&](std::size_t i) {
        residual_[i] =
            body_.mass_g[i] * (step.start.velocities_mm_per_s[i] - (1.0 + dt * alpha) * step.w[i]) +
            dt * force_[i];
        if (damped) residual_[i] -= dt * product_[i];
        if (body_.fixed[i]) residual_[i].setZero();
    });
}

void BackwardEuler::solve(const Step& step, StepReport& report) {
    solver_->prepare(matrix_, step.x);
    // The first system is solved for the change of velocity, whose relative error means something
    // for a body in flight, too.
    if (step.iterate == 0) {
        multiply(matrix_, step.start.velocities_mm_per_s, product_);
        for_each_node(residual_.size(), [&](std::size_t i) {
            if (!body_.fixed[i]) residual_[i] -= product_[i];
        });
    }
    std::ranges::fill(change_, Vec3::Zero());
    const SolveReport solved = solver_->solve(residual_, change_, settings_.linear);
    if (solver_->made_from_latest()) made_from_ = origin_of(step);
    report.linear_iterations += solved.iterations;
    report.linear_residual = solved.relative_residual;
    report.linear_energy_error = solved.energy_error;
}

MatrixOrigin BackwardEuler::origin_of(const Step& step) const {
    return {.dt_s = step.dt_s,
            .start_mm = step.start.positions_mm,
            .iterate_mm = step.iterate > 0 ? step.x : std::vector<Vec3>{},
            .grabs = step.forces.grabs(),
            .velocity_error = settings_.velocity_error};
}

// Assembles matrix_ as the step that `origin` is of did.
void BackwardEuler::assemble_again(const MatrixOrigin& origin) {
    validate_time_step(origin.dt_s);
    const std::size_t nodes = body_.rest_positions_mm.size();
    validate_state(origin.start_mm, origin.start_mm, nodes);
    const bool first = origin.iterate_mm.empty();
    if (!first) validate_state(origin.iterate_mm, origin.iterate_mm, nodes);
    ExternalForces forces(body_);
    forces.set_grabs(origin.grabs);
    const NewtonSettings now = settings_;
    settings_.velocity_error = origin.velocity_error;
    set_settings(settings_);
    const BodyState start{origin.start_mm, std::vector<Vec3>(nodes, Vec3::Zero())};
    Step step{.forces = forces, .start = start, .dt_s = origin.dt_s, .x = origin.start_mm};
    evaluate(step.x);
    assemble(step);
    if (has_error_) add_velocity_error(step);
    if (!first) {
        if (body_.damping.beta_s > 0.0) keep_damping(step);
        step.iterate = 1;
        step.x = origin.iterate_mm;
        evaluate(step.x);
        assemble(step);
    }
    set_settings(now);
}

void BackwardEuler::restore(const SolverCheckpoint& checkpoint) {
    const std::optional<MatrixOrigin>& origin = checkpoint.made_from;
    if (origin) assemble_again(*origin);
    forget();
    const std::vector<Vec3> none;
    const bool first = !origin || origin->iterate_mm.empty();
    solver_->restore(origin ? &matrix_ : nullptr,
                     !origin ? none : (first ? origin->start_mm : origin->iterate_mm),
                     checkpoint.memory);
    made_from_ = origin;
}

double BackwardEuler::potential(const Step& step) const {
    const double dt = step.dt_s, alpha = body_.damping.alpha_per_s;
    const double inertia = sum_over_nodes(step.w.size(), [&](std::size_t i) {
        const Vec3 change = step.w[i] - step.start.velocities_mm_per_s[i];
        return 0.5 * body_.mass_g[i] *
               (change.squaredNorm() + dt * alpha * step.w[i].squaredNorm());
    });
    return inertia + 0.5 * dt * step.damping_form + elastic_ + step.forces.energy(step.x) -
           dt * gravity_work(body_, step.forces.gravity_mm_per_s2(), step.w);
}

double BackwardEuler::potential_energy(std::span<const Vec3> positions_mm,
                                       const ExternalForces& forces) const {
    const double weight = sum_over_nodes(positions_mm.size(), [&](std::size_t i) {
        return body_.mass_g[i] *
               forces.gravity_mm_per_s2().dot(positions_mm[i] - body_.rest_positions_mm[i]);
    });
    return assembly_.energy(positions_mm) + forces.energy(positions_mm) - weight;
}

// Moves by a share of the direction; true if the potential fell enough.
bool BackwardEuler::try_share(Step& step, double share, double slope) {
    const std::vector<Vec3> before = step.w;
    const double form_before = step.damping_form;
    for_each_node(step.w.size(), [&](std::size_t i) {
        step.w[i] += share * step.direction[i];
        step.x[i] = step.start.positions_mm[i] + step.dt_s * step.w[i];
    });
    if (all_finite(step.x)) {
        if (body_.damping.beta_s > 0.0) {
            if (step.iterate == 0) {
                step.damping_form = share * share * step.direction_form;
            } else {
                multiply(damping_, step.w, product_);
                step.damping_form = dot(step.w, product_);
            }
        }
        evaluate(step.x);
        const double value = potential(step);
        const double noise = rounding * (std::abs(value) + std::abs(step.value));
        if (std::isfinite(value) && value <= step.value + armijo * share * slope + noise) {
            step.value = std::min(value, step.value);
            return true;
        }
        if (!settings_.line_search && std::isfinite(value)) return true;
    }
    step.w = before;
    step.damping_form = form_before;
    return false;
}

// False where no share of the direction lowers the potential; the iterate is then as before.
bool BackwardEuler::search_line(Step& step) {
    const double slope = -dot(steepest_, step.direction);  // of the potential, along the direction
    double share = 1.0;
    while (share > shortest_share) {
        if (try_share(step, share, slope)) {
            step.share = share;
            step.whole = step.iterate == 0 && share == 1.0;
            return true;
        }
        share *= 0.5;
    }
    for (std::size_t i = 0; i < step.x.size(); ++i)
        step.x[i] = step.start.positions_mm[i] + step.dt_s * step.w[i];
    evaluate(step.x);
    return false;
}

// A linearised step may create energy where elements turn far. What nobody put in is taken out of
// the velocities again.
void BackwardEuler::limit_energy(Step& step, StepReport& report) const {
    if (!settings_.line_search) return;
    const double before = step.start_kinetic + step.start_elastic + step.start_external;
    const double work = step.dt_s * gravity_work(body_, step.forces.gravity_mm_per_s2(), step.w);
    const double stored = elastic_ + step.forces.energy(step.x),
                 moving = kinetic_energy(body_, step.w);
    const double excess = stored + moving - before - work;
    // At rest the energies are rounding errors, of either sign.
    const double size = std::abs(before) + std::abs(work) + std::abs(stored) + moving;
    if (!(moving > 0.0) || !(excess > 1e-9 * size)) return;
    step.velocity_scale = std::sqrt(std::max(0.0, moving - excess) / moving);
    report.degraded = true;
    report.message = "the body was slowed down: the step would have made energy";
}

// Keeps, while the slots are those of the start, what the whole linearised step would do.
void BackwardEuler::book_linearised(Step& step) {
    const std::vector<Vec3> dx = times(step.dt_s, step.direction);
    const double elastic_form = assembly_.quadratic_form(dx);
    const double external_form = step.forces.quadratic_form(step.x, dx, matrix_);
    const double gravity = gravity_work(body_, step.forces.gravity_mm_per_s2(), dx);
    const double elastic = dot(dx, elastic_force_);
    step.linear_elastic_work = elastic - elastic_form;
    step.linear_external_work = dot(dx, force_) - elastic - gravity - external_form;
    step.direction_form = body_.damping.beta_s * elastic_form / (step.dt_s * step.dt_s);
    multiply(matrix_, change_, product_);
    step.residual_work = dot(step.direction, product_) - dot(step.direction, residual_);
    if (!has_error_) return;
    multiply(error_matrix_, change_, product_);
    step.residual_work -= dot(step.direction, product_);
}

void BackwardEuler::book(const Step& step, StepReport& report) {
    const double dt = step.dt_s;
    EnergyLedger& ledger = report.energy;
    const std::vector<Vec3> dx = times(dt, step.w);
    const double inertial_loss = sum_over_nodes(dx.size(), [&](std::size_t i) {
        return 0.5 * body_.mass_g[i] *
               (step.w[i] - step.start.velocities_mm_per_s[i]).squaredNorm();
    });
    double elastic_work = step.linear_elastic_work, external_work = step.linear_external_work;
    double residual_work = step.residual_work;
    const double gravity = gravity_work(body_, step.forces.gravity_mm_per_s2(), dx);
    if (!step.whole) {
        if (step.iterate == 0 && body_.damping.beta_s > 0.0) keep_damping(step);
        Step end = step;
        end.iterate = 1;
        right_hand_side(end);
        residual_work = -dot(step.w, residual_);
        elastic_work = dot(dx, elastic_force_);
        external_work = dot(dx, force_) - elastic_work - gravity;
    }
    const double moving = kinetic_energy(body_, step.w);
    ledger.kinetic = step.velocity_scale * step.velocity_scale * moving;
    ledger.elastic = elastic_;
    ledger.grab = step.forces.energy(step.x);
    ledger.gravity_work = gravity;
    ledger.damping_loss = dt * (2.0 * body_.damping.alpha_per_s * moving + step.damping_form);
    ledger.solver_work = residual_work;
    ledger.integrator_loss = inertial_loss + (moving - ledger.kinetic) +
                             (step.start_elastic - elastic_ - elastic_work) +
                             (step.start_external - ledger.grab - external_work);
    const double gained = ledger.kinetic + ledger.elastic + ledger.grab - step.start_kinetic -
                          step.start_elastic - step.start_external;
    ledger.imbalance = gained - (ledger.gravity_work - ledger.damping_loss -
                                 ledger.integrator_loss + ledger.solver_work);
}

StepReport BackwardEuler::advance(BodyState& state, double dt_s, const ExternalForces& forces) {
    return advance_in_parts(state, dt_s, forces, settings_.line_search ? most_halvings : 0);
}

bool BackwardEuler::iterate(Step& step, StepReport& report) {
    if (step.iterate == 1 && body_.damping.beta_s > 0.0) keep_damping(step);
    right_hand_side(step);
    assemble(step);
    steepest_ = residual_;
    if (step.iterate == 0 && has_error_) add_velocity_error(step);
    solve(step, report);
    ++report.newton_iterations;
    step.direction = change_;
    if (step.iterate == 0) {
        for_each_node(change_.size(), [&](std::size_t i) {
            step.direction[i] += step.start.velocities_mm_per_s[i];
        });
        book_linearised(step);
    }
    return search_line(step);
}

// Iterates as settings say, and further where a single iterate had to be shortened. False where not
// even the first could lower the potential.
bool BackwardEuler::find_velocity(Step& step, StepReport& report) {
    int most = settings_.iterations;
    for (;; ++step.iterate) {
        const bool lower = iterate(step, report);
        double longest_squared = 0.0;
        for (const Vec3& d : step.direction)
            longest_squared = std::max(longest_squared, d.squaredNorm());
        const double longest = step.dt_s * std::sqrt(longest_squared);
        if (!lower) {
            // At rest the potential is rounding errors, and no direction lowers it for certain.
            if (step.iterate == 0) return longest <= at_rest * body_.mean_edge_mm;
            break;
        }
        if (longest <= settings_.tolerance * body_.mean_edge_mm) return true;
        if (settings_.iterations == 1) most = step.share < 1.0 ? 1 + rescue_iterates : 1;
        if (step.iterate + 1 >= most) break;
    }
    if (step.share < 1.0) {
        report.degraded = true;
        report.message = "the step was shortened: it would have made energy";
    }
    return true;
}

StepReport BackwardEuler::advance_in_parts(BodyState& state, double dt_s,
                                           const ExternalForces& forces, int halvings_left) {
    if (!current_) evaluate(state.positions_mm);
    current_ = true;
    StepReport report;
    report.dt_s = dt_s;
    Step step{.forces = forces,
              .start = state,
              .dt_s = dt_s,
              .start_kinetic = kinetic_energy(body_, state.velocities_mm_per_s),
              .start_elastic = elastic_,
              .start_external = forces.energy(state.positions_mm),
              .w = std::vector<Vec3>(state.positions_mm.size(), Vec3::Zero()),
              .x = state.positions_mm,
              .direction = {}};
    step.value = potential(step);
    const bool stuck = !find_velocity(step, report);
    if (stuck && halvings_left > 0) {
        const StepReport first = advance_in_parts(state, 0.5 * dt_s, forces, halvings_left - 1);
        report = in_sequence(first, advance_in_parts(state, 0.5 * dt_s, forces, halvings_left - 1));
        report.degraded = true;
        report.message = "the step was cut in halves: it would have made energy";
        return report;
    }
    if (stuck) {
        report.degraded = true;
        report.message = "the body was stopped: no step lowers its energy";
    }
    limit_energy(step, report);
    book(step, report);
    for_each_node(step.x.size(), [&](std::size_t i) {
        state.velocities_mm_per_s[i] = step.velocity_scale * step.w[i];
    });
    state.positions_mm = std::move(step.x);
    return report;
}

}  // namespace hepatica
