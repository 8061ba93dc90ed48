// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/cpu_stepper.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/step/backward_euler.h"
#include "core/deform/step/energy_ledger.h"
#include "core/deform/step/inversion_recovery.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/deform/stepper/stepper_input.h"
#include "core/mesh/hex_mesh.h"

namespace hepatica {
namespace {

constexpr double sleep_speed_edges_per_s = 1e-5;
constexpr double sleep_after_s = 0.5;
// A body slower than this for as long has settled, and is searched for inverted elements.
constexpr double settled_speed_edges_per_s = 2e-2;
constexpr double settled_after_s = 0.25;

StepperOptions validated(const StepperOptions& options) {
    validate(options);
    return options;
}

std::unique_ptr<LinearSolver> solver_for(const Body& body, const BodyDescription& description,
                                         const StepperOptions& options) {
    if (options.solver == LinearSolverKind::block_jacobi) return make_block_jacobi_solver();
    if (!description.skeleton.positions_mm.empty())
        return make_linear_solver(options.solver, description.skeleton, body.rest_positions_mm);
    TetMesh mesh = description.mesh;
    const auto cut = cut_into_tetrahedra(description.hexahedra);
    mesh.tetrahedra.insert(mesh.tetrahedra.end(), cut.begin(), cut.end());
    return make_linear_solver(options.solver, skeleton_of_mesh(mesh), body.rest_positions_mm);
}

// Speed of the fastest node, mm/s.
double fastest(const BodyState& state) {
    double squared = 0.0;
    for (const Vec3& v : state.velocities_mm_per_s) squared = std::max(squared, v.squaredNorm());
    return std::sqrt(squared);
}

NewtonSettings newton_of(const StepperOptions& options) {
    return {.iterations = options.newton_iterations,
            .tolerance = options.newton_tolerance,
            .line_search = !options.published,
            .velocity_error = options.velocity_error,
            .linear = options.linear,
            .audit = options.audit};
}

class CpuStepper final : public Stepper {
  public:
    CpuStepper(const BodyDescription& description, const StepperOptions& options)
        : options_(validated(options)),
          body_(build_body(description, options.model, options.order)),
          potentials_(body_),
          recovery_(body_),
          integrator_(body_, newton_of(options), solver_for(body_, description, options)) {
        state_.positions_mm = body_.rest_positions_mm;
        state_.velocities_mm_per_s.assign(body_.node_count(), Vec3::Zero());
    }

    void set_grabs(std::span<const Grab> grabs) override {
        const std::vector<Vec3>& x = state_.positions_mm;
        const double before = potentials_.energy(x, x);
        potentials_.set_grabs(grabs);
        tool_work_ += potentials_.energy(x, x) - before;
        wake();
    }

    void set_gravity(const Vec3& gravity_mm_per_s2) override {
        potentials_.set_gravity(gravity_mm_per_s2);
        wake();
    }

    bool set_options(const StepperOptions& options) override {
        const StepperOptions now = validated(options);
        if (now.model != options_.model || now.order != options_.order ||
            now.solver != options_.solver ||
            (now.newton_iterations > 1) != (options_.newton_iterations > 1))
            return false;
        options_ = now;
        integrator_.set_settings(newton_of(options_));
        return true;
    }

    StepReport step(double dt_s) override;

    std::span<const Vec3> positions_mm() const override {
        return std::span(state_.positions_mm).first(body_.vertex_count);
    }
    std::span<const Vec3> velocities_mm_per_s() const override {
        return std::span(state_.velocities_mm_per_s).first(body_.vertex_count);
    }

    EnergyLedger energies() const override {
        EnergyLedger now;
        now.kinetic = kinetic_energy(body_, state_.velocities_mm_per_s);
        now.elastic = integrator_.elastic_energy(state_.positions_mm);
        potentials_.book(state_.positions_mm, state_.positions_mm, now);
        now.tool_work = tool_work_;
        return now;
    }
    BodyState state() const override { return state_; }
    void set_state(std::span<const Vec3> positions_mm,
                   std::span<const Vec3> velocities_mm_per_s) override;
    StepperCheckpoint checkpoint() const override;
    void restore(const StepperCheckpoint& checkpoint) override;

  private:
    void wake() {
        still_s_ = 0.0;
        settled_s_ = 0.0;
    }
    void watch_for_sleep(double dt_s);
    void recover_from_inversion(double dt_s, StepReport& report);

    StepperOptions options_;
    Body body_;
    PotentialList potentials_;
    InversionRecovery recovery_;
    BackwardEuler integrator_;
    BodyState state_;
    double tool_work_ = 0.0;
    double still_s_ = 0.0;    // for how long nothing has moved
    double settled_s_ = 0.0;  // for how long nothing has moved much
    EnergyLedger resting_;    // the energies of the last step made
};

StepReport CpuStepper::step(double dt_s) {
    validate_time_step(dt_s);
    StepReport report;
    if (options_.sleeping && still_s_ >= sleep_after_s) {
        report.dt_s = dt_s;
        report.asleep = true;
        report.energy.kinetic = resting_.kinetic;
        report.energy.elastic = resting_.elastic;
        report.energy.grab = resting_.grab;
        report.energy.tether = resting_.tether;
        return report;
    }
    for (int s = 0; s < options_.substeps; ++s) {
        const StepReport part = integrator_.advance(state_, dt_s / options_.substeps, potentials_);
        report = s == 0 ? part : in_sequence(report, part);
    }
    report.energy.tool_work = tool_work_;
    tool_work_ = 0.0;
    recover_from_inversion(dt_s, report);
    resting_ = report.energy;
    watch_for_sleep(dt_s);
    return report;
}

void CpuStepper::watch_for_sleep(double dt_s) {
    still_s_ =
        fastest(state_) < sleep_speed_edges_per_s * body_.mean_edge_mm ? still_s_ + dt_s : 0.0;
}

// Looks once each time the body has settled.
void CpuStepper::recover_from_inversion(double dt_s, StepReport& report) {
    if (options_.published) return;
    const bool settled = fastest(state_) < settled_speed_edges_per_s * body_.mean_edge_mm;
    const double before = settled_s_;
    settled_s_ = settled ? settled_s_ + dt_s : 0.0;
    if (before >= settled_after_s || settled_s_ < settled_after_s) return;
    const auto energy = [&](std::span<const Vec3> x) {
        return integrator_.potential_energy(x, potentials_);
    };
    const auto recovered = recovery_.recover(state_.positions_mm, energy);
    if (!recovered) return;
    EnergyLedger& ledger = report.energy;
    ledger.inversion_recovery_loss =
        ledger.kinetic + energy(state_.positions_mm) - energy(*recovered);
    EnergyLedger after;
    potentials_.book(*recovered, state_.positions_mm, after);
    ledger.gravity_work += after.gravity_work;
    ledger.grab = after.grab;
    ledger.tether = after.tether;
    state_.positions_mm = *recovered;
    std::ranges::fill(state_.velocities_mm_per_s, Vec3::Zero());
    ledger.kinetic = 0.0;
    ledger.elastic = integrator_.elastic_energy(state_.positions_mm);
    integrator_.forget();
    report.degraded = true;
    report.message = "elements that had turned inside out were put right";
    wake();
}

void CpuStepper::set_state(std::span<const Vec3> positions_mm,
                           std::span<const Vec3> velocities_mm_per_s) {
    const bool whole = positions_mm.size() == state_.positions_mm.size();
    const std::size_t expected = whole ? state_.positions_mm.size() : body_.vertex_count;
    validate_state(positions_mm, velocities_mm_per_s, expected);
    std::ranges::copy(positions_mm, state_.positions_mm.begin());
    std::ranges::copy(velocities_mm_per_s, state_.velocities_mm_per_s.begin());
    for (std::size_t m = 0; !whole && m < body_.edge_of_middle_node.size(); ++m) {
        const auto& [a, b] = body_.edge_of_middle_node[m];
        const std::size_t i = body_.vertex_count + m;
        state_.positions_mm[i] = 0.5 * (positions_mm[a] + positions_mm[b]);
        state_.velocities_mm_per_s[i] = 0.5 * (velocities_mm_per_s[a] + velocities_mm_per_s[b]);
    }
    for (int i = 0; i < body_.node_count(); ++i)
        if (body_.fixed[i]) state_.velocities_mm_per_s[i].setZero();
    integrator_.forget();
    tool_work_ = 0.0;
    wake();
}

StepperCheckpoint CpuStepper::checkpoint() const {
    return {.nodes = state_,
            .grabs = potentials_.grabs(),
            .gravity_mm_per_s2 = potentials_.gravity_mm_per_s2(),
            .unreported_tool_work = tool_work_,
            .still_s = still_s_,
            .settled_s = settled_s_,
            .last_kinetic = resting_.kinetic,
            .last_elastic = resting_.elastic,
            .last_grab = resting_.grab,
            .last_tether = resting_.tether,
            .solver = integrator_.checkpoint(),
            .region = {},
            .part = {}};
}

void CpuStepper::restore(const StepperCheckpoint& checkpoint) {
    validate_checkpoint(checkpoint, state_.positions_mm.size());
    if (checkpoint.region)
        throw InputError("is of a stepper that computes a part", "the checkpoint of a body",
                         "Make a stepper of that kind");
    integrator_.restore(checkpoint.solver);
    state_ = checkpoint.nodes;
    potentials_.set_grabs(checkpoint.grabs);
    potentials_.set_gravity(checkpoint.gravity_mm_per_s2);
    tool_work_ = checkpoint.unreported_tool_work;
    still_s_ = checkpoint.still_s;
    settled_s_ = checkpoint.settled_s;
    resting_ = {};
    resting_.kinetic = checkpoint.last_kinetic;
    resting_.elastic = checkpoint.last_elastic;
    resting_.grab = checkpoint.last_grab;
    resting_.tether = checkpoint.last_tether;
}

}  // namespace

std::unique_ptr<Stepper> make_cpu_stepper(const BodyDescription& body,
                                          const StepperOptions& options) {
    return std::make_unique<CpuStepper>(body, options);
}

}  // namespace hepatica
