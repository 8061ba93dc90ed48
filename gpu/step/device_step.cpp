// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/small_matrix_eigen.h"
#include "core/deform/potentials/self_contact.h"
#include "core/deform/step/energy_limiter.h"
#include "core/deform/step/step_books.h"
#include "gpu/machine/downloads_under_way.h"
#include "gpu/machine/pinned_vectors.h"
#include "gpu/step/contact_guard.h"
#include "gpu/step/device_body.h"
#include "gpu/step/device_grabs.h"
#include "gpu/step/device_touches.h"
#include "gpu/step/partition.h"
#include "gpu/step/state_copies.h"
#include "gpu/step/step_balance.h"

namespace hepatica::gpu {
namespace {

constexpr int most_impacts = 3;      // per step, as in BackwardEuler
constexpr double least_part = 0.05;  // least share of the remaining time
constexpr double armijo =
    1e-4;  // share of the predicted decrease that must be reached, as in NewtonStep

// A change of energy below this share of the energies involved is rounding.
constexpr double energy_rounding = 1e-13;
template <class Real>
class Step final : public DeviceStep {
  public:
    Step(Machine& machine, const Body& body, PotentialList& potentials,
         const CoarseSkeleton& skeleton)
        : machine_(machine),
          body_(body),
          plan_(plan_assembly(body_, small::Tangent::rotated)),
          potentials_(potentials),
          guard_(body_, potentials),
          whole_skeleton_(skeleton),
          energy_floor_(energy_of_rounding(body_)),
          elements_(machine, body_, plan_),
          grabs_(machine),
          touches_(machine, potentials.obstacles_mm()),
          all_(machine),
          pieces_(machine),
          solver_(machine, all_),
          mass_(machine),
          tether_(machine),
          device_held_(machine),
          rest_(machine),
          start_(machine),
          before_(machine),
          position_(machine),
          velocity_(machine),
          start_force_(machine),
          steepest_(machine),
          rhs_(machine),
          damping_(machine),
          pinned_(machine) {
        set_nodes();
        set_state({body_.rest_positions_mm, std::vector<Vec3>(nodes_, Vec3::Zero())});
    }
    void follow_tear() override {
        plan_ = plan_assembly(body_, small::Tangent::rotated);
        elements_.follow(body_, plan_);
        set_nodes();
    }

    void set_grabs(std::span<const Grab> grabs) override { grabs_.set(grabs, plan_); }
    void set_gravity(const Vec3& gravity) override { gravity_ = small::from_eigen(gravity); }
    void set_held(std::span<const std::uint8_t> held) override {
        held_.assign(held.begin(), held.end());
        device_held_.set(held_);
    }
    void set_state(const BodyState& state) override {
        state_ = state;
        copy_in(machine_, state.positions_mm, start_);
        copy_in(machine_, state.velocities_mm_per_s, before_);
        evaluated_ = false;
    }
    const BodyState& state() const override { return state_; }

    bool advance(double dt_s, const SolveLimits& limits, StepReport& report,
                 const std::stop_token& stop) override;
    const std::string& left_because() const override { return left_because_; }

    const SolveCost& solve_cost() const override { return solve_cost_; }
    double solver_memory() const override { return solver_.smallest_ritz(); }
    void set_solver_memory(double memory) override { solver_.remember(memory); }

  private:
    void set_nodes();
    double inertia(double dt) const { return 1.0 + dt * body_.damping.alpha_per_s; }
    double beta() const { return body_.damping.beta_s; }
    NodeViews nodes_at(const GrowingArray<Vector3<double>>& x,
                       const GrowingArray<Vector3<double>>& w) const;
    SystemView<Real> system(const SystemFactors& factors) const;
    SystemView<Real> step_matrix(double dt) const {
        return system({inertia(dt), dt * dt, dt * dt + dt * beta(), dt * dt, dt * dt});
    }
    double product(const SystemView<Real>& system, const GrowingArray<Vector3<double>>& w,
                   GrowingArray<Vector3<double>>& y);
    void place(double dt, double share, View<const Vector3<double>> change);
    void evaluate(bool with_stiffness);
    Descent descent(double dt, bool damped, GrowingArray<Vector3<double>>& result) const;
    double value_of(const Balance& now, double dt, double damping_form) const;
    Balance balance() { return {pieces_.read(Energies{nodes_at(position_, velocity_)})}; }

    void begin(Underway& step);
    bool predict(Underway& step);
    void stand(Underway& step);
    bool solve(Underway& step, const SolveLimits& limits, StepReport& report,
               const std::stop_token& stop);
    bool accepted(Underway& step);
    void book(Underway& step, StepReport& report);
    bool accept(const Underway& step, StepReport& report);
    bool make(double dt_s, const SolveLimits& limits, StepReport& report,
              const std::stop_token& stop);

    void look_along(const Underway& step) {
        touches_.set(potentials_.touches_along(step.from_mm, step.to_mm));
    }
    bool passes_nothing(Underway& step);
    std::vector<Vec3> elastic_force() const;
    bool leave(const char* because) {
        left_because_ = because;
        return false;
    }

    Machine& machine_;
    const Body& body_;
    AssemblyPlan plan_;
    PotentialList& potentials_;
    ContactGuard guard_;
    CoarseSkeleton whole_skeleton_;         // of the body before it tore
    std::optional<EnergyLimiter> limiter_;  // always engaged after construction
    std::vector<std::uint8_t> held_;
    double energy_floor_;
    std::size_t nodes_ = 0;
    DeviceBody<Real> elements_;
    DeviceGrabs grabs_;
    DeviceTouches touches_;
    WholeSum all_;
    Partition pieces_;
    DeviceSolver<Real> solver_;
    std::unique_ptr<DeviceSkeleton<Real>> skeleton_;  // null: none
    GrowingArray<double> mass_, tether_;
    GrowingArray<std::uint8_t> device_held_;
    GrowingArray<Vector3<double>> rest_, start_, before_, position_, velocity_, start_force_;
    GrowingArray<Vector3<double>> steepest_, rhs_, damping_;
    Vector3<double> gravity_{{0.0, 0.0, 0.0}};
    bool evaluated_ = false;  // elastic forces and energies are those at start_
    BodyState state_, end_;   // end_: memory for the state at the end of a step
    PinnedVectors pinned_;    // the vectors of both
    std::string left_because_;
    SolveCost solve_cost_;  // of the step
};

// Sets all arrays with one entry per node of the present body.
template <class Real>
void Step<Real>::set_nodes() {
    nodes_ = body_.rest_positions_mm.size();
    pinned_.resize({&state_.positions_mm, &state_.velocities_mm_per_s, &end_.positions_mm,
                    &end_.velocities_mm_per_s},
                   nodes_);
    held_ = body_.fixed;
    limiter_.emplace(body_, plan_);
    grabs_.follow_tear(potentials_.grabs(), plan_);
    touches_.set_nodes(nodes_);
    all_.resize(nodes_, elements_.row_chunks().chunks());
    pieces_.set(limiter_->piece_of_node());
    solver_.resize(nodes_);
    mass_.set(body_.mass_g);
    tether_.set(body_.tether_un_per_mm);
    device_held_.set(held_);
    std::vector<Vector3<double>> rest;
    for (const Vec3& x : body_.rest_positions_mm) rest.push_back(small::from_eigen(x));
    rest_.set(std::move(rest));
    for (auto* vector :
         {&start_, &before_, &position_, &velocity_, &start_force_, &steepest_, &rhs_, &damping_})
        vector->resize(nodes_);
    if (whole_skeleton_.size() > 0)
        skeleton_ = std::make_unique<DeviceSkeleton<Real>>(machine_, whole_skeleton_,
                                                           body_.rest_positions_mm, plan_);
}

template <class Real>
NodeViews Step<Real>::nodes_at(const GrowingArray<Vector3<double>>& x,
                               const GrowingArray<Vector3<double>>& w) const {
    return {start_.read(),
            before_.read(),
            x.read(),
            w.read(),
            rest_.read(),
            elements_.elastic_force(),
            elements_.elastic_energy(),
            mass_.read(),
            tether_.read(),
            device_held_.read(),
            grabs_.view(),
            touches_.view(),
            gravity_};
}

template <class Real>
SystemView<Real> Step<Real>::system(const SystemFactors& factors) const {
    return {elements_.row_begin(),  elements_.column(),
            elements_.row_chunks(), elements_.block(),
            mass_.read(),           tether_.read(),
            device_held_.read(),    grabs_.view(),
            touches_.view(),        factors};
}

// y = A w; returns w . y.
template <class Real>
double Step<Real>::product(const SystemView<Real>& system, const GrowingArray<Vector3<double>>& w,
                           GrowingArray<Vector3<double>>& y) {
    return all_.read_rows(system, w.read(), KeepProduct<double>{y.view()})[0];
}

// Moves the nodes to w = share v_n + change.
template <class Real>
void Step<Real>::place(double dt, double share, View<const Vector3<double>> change) {
    machine_.for_each(PlaceNodes{start_.read(), before_.read(), change, share, dt, position_.view(),
                                 velocity_.view()});
}

// Computes forces and energies at position_.
template <class Real>
void Step<Real>::evaluate(bool with_stiffness) {
    grabs_.pull(position_.read());
    touches_.press(position_.read());
    elements_.evaluate(position_.read(), with_stiffness);
}

template <class Real>
Descent Step<Real>::descent(double dt, bool damped, GrowingArray<Vector3<double>>& result) const {
    View<const Vector3<double>> damping;
    if (damped) damping = damping_.read();
    return {nodes_at(position_, velocity_), damping, dt, inertia(dt), result.view()};
}

// Value of the incremental potential, see incremental_potential.h.
template <class Real>
double Step<Real>::value_of(const Balance& now, double dt, double damping_form) const {
    return now.sum(Energies::inertial) +
           dt * body_.damping.alpha_per_s * now.sum(Energies::kinetic) + 0.5 * dt * damping_form +
           now.potential();
}

// Computes forces and energies at the start.
template <class Real>
void Step<Real>::begin(Underway& step) {
    if (guard_.any()) {
        step.start = state_;
        step.from_mm = state_.positions_mm;
        step.to_mm = places_ahead(state_, step.dt_s);
        look_along(step);
    } else {
        touches_.set({});  // a tool that was taken away presses no longer
    }
    grabs_.pull(start_.read());
    touches_.press(start_.read());
    if (!evaluated_) elements_.evaluate(start_.read(), false);
    const NodeViews at_start = nodes_at(start_, before_);
    machine_.for_each(KeepForces{at_start, start_force_.view()});
    step.before = {pieces_.read(Energies{at_start})};
    step.standing = step.before.sum(Energies::kinetic) + step.before.potential();
}

// Tries to begin the iterate at the positions without a change of velocity. False where standing
// still has a lower potential.
template <class Real>
bool Step<Real>::predict(Underway& step) {
    if (!(step.before.sum(Energies::kinetic) > 0.0)) return false;
    const double dt = step.dt_s;
    if (guard_.any() && potentials_.free_share(step.from_mm, step.to_mm) < 1.0) return false;
    place(dt, 1.0, {});
    evaluate(true);
    const Balance there = balance();
    if (!(value_of(there, dt, 0.0) <= step.standing)) return false;
    elements_.assemble();
    touches_.foresee(nodes_at(position_, velocity_));
    const bool damped = beta() > 0.0;
    const double form = damped ? product(system({.stiffness = beta()}), velocity_, damping_) : 0.0;
    step.value = value_of(there, dt, form);
    if (!(step.value <= step.standing)) return false;
    step.predicted = true;
    if (guard_.any()) step.from_mm = step.to_mm;
    machine_.for_each(descent(dt, damped, steepest_));
    return true;
}

// Begins the iterate at w = 0; the unknown is the change of velocity nonetheless.
template <class Real>
void Step<Real>::stand(Underway& step) {
    const double dt = step.dt_s;
    place(dt, 0.0, {});
    evaluate(true);
    elements_.assemble();
    touches_.foresee(nodes_at(position_, velocity_));
    step.value = step.standing;
    machine_.for_each(descent(dt, false, steepest_));
    machine_.for_each(descent(dt, false, rhs_));
    product(step_matrix(dt), before_, damping_);
    machine_.for_each(Subtract{rhs_.view(), damping_.read()});
}

// Solves for the direction and applies it. False where the solver broke down.
template <class Real>
bool Step<Real>::solve(Underway& step, const SolveLimits& limits, StepReport& report,
                       const std::stop_token& stop) {
    const double dt = step.dt_s;
    if (skeleton_) skeleton_->prepare(step_matrix(dt), start_.read());
    const SolveReport solved =
        solver_.solve(step_matrix(dt), step.predicted ? steepest_.read() : rhs_.read(),
                      skeleton_.get(), limits, stop);
    solve_cost_ += solver_.cost();
    report.linear_solves = report.newton_iterations = 1;
    report.linear_iterations = solved.iterations;
    report.linear_residual = solved.relative_residual;
    report.linear_energy_error = solved.energy_error;
    if (!solved.converged && solved.iterations < limits.max_iterations) return false;
    const std::array<double, 2> along =
        all_.read(AlongDirection{steepest_.read(), solver_.residual(), solver_.solution(),
                                 before_.read(), step.predicted ? 0.0 : 1.0});
    step.slope = -along[0];
    step.residual_work = -along[1];
    place(dt, 1.0, solver_.solution());
    begin_copy_out(machine_, position_, end_.positions_mm);
    begin_copy_out(machine_, velocity_, end_.velocities_mm_per_s);
    // The stiffness is still the one at the beginning of the iterate.
    if (!step.predicted)
        step.curvature =
            dt * dt *
            product(system({.tether = 1.0, .stiffness = 1.0, .grab = 1.0, .touch = 1.0}), velocity_,
                    damping_);
    if (beta() > 0.0)
        step.damping_form = product(system({.stiffness = beta()}), velocity_, damping_);
    return true;
}

// Whether the full direction decreases the incremental potential sufficiently (Armijo).
template <class Real>
bool Step<Real>::accepted(Underway& step) {
    const double dt = step.dt_s;
    if (guard_.any() && !passes_nothing(step)) return false;
    evaluate(false);
    step.after = balance();
    const double value = value_of(step.after, dt, step.damping_form);
    const double noise = energy_rounding * (std::abs(value) + std::abs(step.value)) + energy_floor_;
    return std::isfinite(value) && value <= step.value + armijo * step.slope + noise;
}

// Fills the energy ledger, as StepBooks does.
template <class Real>
void Step<Real>::book(Underway& step, StepReport& report) {
    const double dt = step.dt_s;
    const std::array<double, 3> works =
        all_.read(Works{descent(dt, beta() > 0.0, rhs_), start_force_.read()});
    const double start_work = works[0];
    double end_work = start_work - step.curvature, solver_work = step.residual_work;
    if (step.predicted) {
        end_work = works[1];
        solver_work = -works[2];
    }
    const EnergyLedger before = step.before.ledger();
    EnergyLedger& ledger = report.energy = step.after.ledger();
    ledger.damping_loss =
        dt * (2.0 * body_.damping.alpha_per_s * ledger.kinetic + step.damping_form);
    ledger.solver_work = solver_work;
    ledger.integrator_loss = step.after.sum(Energies::inertial) + 0.5 * (start_work - end_work);
    const double gained = stored_energy(ledger) - stored_energy(before);
    ledger.tool_work = before.friction_loss;
    const double path_work = ledger.gravity_work - (ledger.friction_loss - before.friction_loss) -
                             (gained - (ledger.kinetic - before.kinetic));
    ledger.nonlinear_loss = path_work - 0.5 * (start_work + end_work);
    ledger.imbalance = gained - explained_change(ledger);
}

// Makes the end of the step the new state, unless the energy limiter demands that the CPU make the
// step; may limit its velocities.
template <class Real>
bool Step<Real>::accept(const Underway& step, StepReport& report) {
    if (guard_.any() && guard_.overdrawn(*limiter_, step, end_.velocities_mm_per_s, held_))
        return leave("a piece would pay for energy or momentum of others");
    const auto pieces_before = step.before.by_piece(), pieces_after = step.after.by_piece();
    const EnergyLimiter::Outcome outcome =
        limiter_->limit({.before = pieces_before, .after = pieces_after, .least_nj = energy_floor_},
                        potentials_, end_.positions_mm, held_, end_.velocities_mm_per_s);
    if (outcome.lost == MomentumLost::linear && potentials_.self())
        return leave("what its surfaces exchanged would be lost");
    std::swap(start_, position_);
    std::swap(before_, velocity_);
    evaluated_ = true;
    std::swap(state_, end_);
    if (!outcome.limited) return true;
    copy_in(machine_, state_.velocities_mm_per_s, before_);
    hepatica::book(outcome, kinetic_energy(body_, state_.velocities_mm_per_s), report);
    return true;
}

// Makes one step of eq. (12), or a part of one.
template <class Real>
bool Step<Real>::make(double dt_s, const SolveLimits& limits, StepReport& report,
                      const std::stop_token& stop) {
    Underway step{.dt_s = dt_s};
    report = {};
    report.dt_s = dt_s;
    if (guard_.any()) potentials_.begin_step(state_, dt_s, held_);
    begin(step);
    if (!predict(step)) {
        if (guard_.flies_into_itself(step, held_))
            return leave("a free body is about to meet itself");
        stand(step);
    }
    evaluated_ = false;
    DownloadsUnderWay downloads(machine_);
    const bool made = solve(step, limits, report, stop) && accepted(step);
    downloads.finish();
    if (!made) return false;
    report.predicted = step.predicted;
    book(step, report);
    if (!accept(step, report)) return false;
    if (guard_.any())
        guard_.report(
            step, state_.velocities_mm_per_s, held_, [&] { return elastic_force(); }, report);
    return true;
}

// Where the body is about to hit something, the step is split at the impact, as in BackwardEuler.
template <class Real>
bool Step<Real>::advance(double dt_s, const SolveLimits& limits, StepReport& report,
                         const std::stop_token& stop) {
    left_because_.clear();
    solve_cost_ = {};
    const BodyState began = guard_.any() ? state_ : BodyState{};
    std::optional<StepReport> made;
    double left_s = dt_s;
    for (int impacts_left = guard_.any() ? most_impacts : 0;; --impacts_left) {
        double part_s = left_s;
        if (impacts_left > 0)
            part_s *= std::max(least_part, guard_.share_until_touch(state_, left_s));
        const bool last = part_s >= left_s;
        StepReport part;
        if (!make(part_s, limits, part, stop)) {
            if (made) set_state(began);
            return false;
        }
        made = made ? in_sequence(*made, part) : part;
        if (last) break;
        left_s -= part_s;
    }
    report = *made;
    return true;
}

// Whether nothing passes through anything along the full direction; also searches for contacts at
// its end.
template <class Real>
bool Step<Real>::passes_nothing(Underway& step) {
    if (step.predicted && limiter_->pieces() > 1 && potentials_.self())
        potentials_.self()->note_meeting(step.from_mm);
    copy_out(machine_, position_, step.to_mm);
    if (!std::ranges::all_of(step.to_mm, [](const Vec3& x) { return x.allFinite(); })) return false;
    if (potentials_.free_share(step.from_mm, step.to_mm) < 1.0)
        return leave("a step has to be shortened, lest something pass through");
    look_along(step);
    return true;
}

template <class Real>
std::vector<Vec3> Step<Real>::elastic_force() const {
    std::vector<Vec3> force(nodes_);
    machine_.download(force.data(), elements_.elastic_force().data, nodes_ * sizeof(Vec3));
    return force;
}

}  // namespace

std::unique_ptr<DeviceStep> make_device_step(Machine& machine, const Body& body,
                                             PotentialList& potentials,
                                             const CoarseSkeleton& skeleton, Precision precision) {
    if (precision == Precision::double_precision)
        return std::make_unique<Step<double>>(machine, body, potentials, skeleton);
    return std::make_unique<Step<float>>(machine, body, potentials, skeleton);
}

}  // namespace hepatica::gpu
