// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/cpu_back_end.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/potentials/self_contact.h"
#include "core/deform/potentials/softening_ties.h"
#include "core/deform/solvers/cholesky_solver.h"
#include "core/deform/step/backward_euler.h"
#include "core/deform/step/inversion_recovery.h"
#include "core/deform/step/step_books.h"
#include "core/mesh/hex_mesh.h"

namespace hepatica {
namespace {

// Called only where the solver may use the skeleton, because it costs a search through the mesh.
CoarseSkeleton skeleton_for(const BodyDescription& description) {
    if (description.skeleton.size() > 0) return description.skeleton;
    TetMesh mesh = description.mesh;
    const auto cut = cut_into_tetrahedra(description.hexahedra);
    mesh.tetrahedra.insert(mesh.tetrahedra.end(), cut.begin(), cut.end());
    return skeleton_of_mesh(mesh);
}

std::unique_ptr<LinearSolver> solver_for(const Body& body, const BodyDescription& description,
                                         const StepperOptions& options) {
    if (options.solver == LinearSolverKind::block_jacobi) return make_block_jacobi_solver();
    if (description.tear) {
        if (options.solver == LinearSolverKind::skeleton)
            throw InputError("cannot follow a tear", "the solver \"skeleton\"",
                             "Choose cholesky, automatic or block-jacobi");
        return std::make_unique<CholeskySolver>();
    }
    return make_linear_solver(options.solver, skeleton_for(description), body.rest_positions_mm);
}

NewtonSettings newton_of(const StepperOptions& options) {
    return {.iterations = options.newton_iterations,
            .tolerance = options.newton_tolerance,
            .line_search = !options.published,
            .tension = options.tension && !options.published,
            .velocity_error = options.velocity_error,
            .linear = options.linear,
            .audit = options.audit};
}

// Copied in parallel, because one core cannot use the whole memory bandwidth.
void copy_state(const BodyState& from, BodyState& to) {
    constexpr std::size_t nodes_at_once = 8192;
    const std::size_t nodes = from.positions_mm.size();
    to.positions_mm.resize(nodes);
    to.velocities_mm_per_s.resize(nodes);
    parallel_blocks(nodes, nodes_at_once, [&](std::size_t begin, std::size_t end) {
        std::copy(from.positions_mm.begin() + static_cast<long>(begin),
                  from.positions_mm.begin() + static_cast<long>(end),
                  to.positions_mm.begin() + static_cast<long>(begin));
        std::copy(from.velocities_mm_per_s.begin() + static_cast<long>(begin),
                  from.velocities_mm_per_s.begin() + static_cast<long>(end),
                  to.velocities_mm_per_s.begin() + static_cast<long>(begin));
    });
}

class OwnCpuBackEnd final : public CpuBackEnd {
  public:
    OwnCpuBackEnd(const BodyDescription& description, const StepperOptions& options)
        : options_(options),
          body_(build_body(description, options.model, options.order)),
          recovery_(std::in_place, body_) {
        potentials_.emplace(body_);
        integrator_.emplace(body_, newton_of(options), solver_for(body_, description, options));
        state_.positions_mm = body_.rest_positions_mm;
        state_.velocities_mm_per_s.assign(body_.node_count(), Vec3::Zero());
    }

    const Body& body() const override { return body_; }
    void set_grabs(std::span<const Grab> grabs) override { potentials_->set_grabs(grabs); }
    void set_gravity(const Vec3& gravity_mm_per_s2) override {
        potentials_->set_gravity(gravity_mm_per_s2);
    }

    void set_tool(const std::optional<Tool>& tool) override { potentials_->set_tool(tool); }
    const std::optional<Tool>& tool() const override { return potentials_->tool(); }
    void lead_tool(double share, double dt_s) override {
        potentials_->lead_tool(state_.positions_mm, share, dt_s);
    }
    std::vector<int> vertices_near_tool() const override {
        return potentials_->vertices_near_tool(state_.positions_mm);
    }
    bool free_of_tool(std::span<const Vec3> positions_mm) const override {
        return potentials_->free_of_tool(positions_mm);
    }
    bool tool_in_obstacle() const override { return potentials_->tool_in_obstacle(); }
    ToolLoad tool_load() const override { return potentials_->tool_load(state_.positions_mm); }

    SurfacesKept overlaps() const override { return potentials_->surfaces().kept_overlaps(); }
    void set_overlaps(const SurfacesKept& kept) override {
        potentials_->surfaces().set_overlaps(kept);
    }
    std::vector<std::array<int, 2>> touching_nodes() const override;

    bool set_options(const StepperOptions& options) override {
        if (options.model != options_.model || options.order != options_.order ||
            options.solver != options_.solver ||
            (options.newton_iterations > 1) != (options_.newton_iterations > 1))
            return false;
        options_ = options;
        integrator_->set_settings(newton_of(options));
        return true;
    }

    void freeze(std::span<const std::uint8_t> frozen) override { integrator_->freeze(frozen); }
    int live_elements() const override { return integrator_->live().live_elements(); }

    StepReport advance(double dt_s, const std::stop_token& stop) override {
        StepReport report = integrator_->advance(state_, dt_s, *potentials_, stop);
        end_step(report);
        return report;
    }
    PotentialList& potentials() override { return *potentials_; }
    void follow(const BodyState& state, StepReport& report) override {
        copy_state(state, state_);
        integrator_->forget();
        end_step(report);
    }

    bool recover_from_inversion(StepReport& report) override;

    void find_stress(std::vector<Mat3>& stress_pa, std::vector<double>& energy_nj) override {
        integrator_->find_stress(state_, stress_pa, energy_nj);
    }
    void tear(const BodyDescription& whole, const TornBody& tear) override;
    std::span<const SofteningTie> ties() const override {
        if (!potentials_->ties()) return {};
        return potentials_->ties()->all();
    }

    const BodyState& state() const override { return state_; }
    void set_state(const BodyState& state) override {
        state_ = state;
        potentials_->surfaces().find_overlaps(state_.positions_mm);
        if (potentials_->ties()) potentials_->ties()->turn(state_.positions_mm);
        integrator_->forget();
    }
    void set_velocities(const std::vector<Vec3>& velocities_mm_per_s) override {
        state_.velocities_mm_per_s = velocities_mm_per_s;
    }

    EnergyLedger energies() const override {
        EnergyLedger now = outside_energies();
        now.kinetic = kinetic_energy();
        now.elastic = integrator_->elastic_energy(state_.positions_mm);
        return now;
    }
    double grab_energy() const override { return potentials_->grab_energy(state_.positions_mm); }
    double contact_energy() const override { return outside_energies().contact; }
    double cohesion_energy() const override {
        return potentials_->ties() ? outside_energies().cohesion : 0.0;
    }
    double kinetic_energy() const override {
        return hepatica::kinetic_energy(body_, state_.velocities_mm_per_s);
    }

    SolverCheckpoint checkpoint() const override { return integrator_->checkpoint(); }
    void restore(const SolverCheckpoint& checkpoint) override { integrator_->restore(checkpoint); }

  private:
    void end_step(StepReport& report) {
        potentials_->end_step();
        report.energy.tear_loss = 0.0;
        follow_positions(report.energy);
    }
    // What the potentials remember of the past follows new positions.
    void follow_positions(EnergyLedger& ledger) {
        if (potentials_->ties()) {
            const double loss = potentials_->ties()->settle(state_.positions_mm);
            ledger.tear_loss += loss;
            ledger.cohesion -= loss;
        }
        const double pressed = self_energy();
        potentials_->surfaces().let_go(state_.positions_mm);
        const double lost = pressed - self_energy();
        ledger.contact -= lost;
        ledger.tear_loss += lost;
    }
    // What slips into a piece that was torn off is left out from then on, with the energy of its
    // pads.
    double self_energy() const {
        const SelfContact* self = potentials_->self();
        return self ? self->energy(state_.positions_mm, state_.positions_mm) : 0.0;
    }
    // The terms of the potentials.
    EnergyLedger outside_energies() const {
        EnergyLedger now;
        potentials_->book(state_.positions_mm, state_.positions_mm, now);
        return now;
    }

    StepperOptions options_;
    Body body_;
    std::optional<PotentialList> potentials_;    // always set
    std::optional<InversionRecovery> recovery_;  // always set
    std::optional<BackwardEuler> integrator_;    // always set
    BodyState state_;
};

std::vector<std::array<int, 2>> OwnCpuBackEnd::touching_nodes() const {
    std::vector<std::array<int, 2>> touching;
    if (!potentials_->self()) return touching;
    for (const SurfaceContact& contact : potentials_->self()->contacts(state_.positions_mm))
        for (int a = 0; a < contact.at.in_first; ++a)
            for (int b = contact.at.in_first; b < 4; ++b)
                touching.push_back({contact.at.nodes[a], contact.at.nodes[b]});
    return touching;
}

void OwnCpuBackEnd::tear(const BodyDescription& whole, const TornBody& tear) {
    std::vector<Grab> grabs = potentials_->grabs();
    const Vec3 gravity = potentials_->gravity_mm_per_s2();
    const std::optional<Tool> tool = potentials_->tool();
    const SurfacesBeforeTear surfaces = potentials_->surfaces().before_tear(state_.positions_mm);
    const Body before =
        std::exchange(body_, build_body(torn(whole, tear), options_.model, options_.order));
    body_.parted_pairs = tear.parted_pairs;
    // Some may hold nodes of a tear that is taken back; the caller sets the others again.
    std::erase_if(grabs, [&](const Grab& grab) { return holds_beyond(grab, body_.node_count()); });
    inherit(tear.parents, state_.positions_mm);
    inherit(tear.parents, state_.velocities_mm_per_s);
    recovery_.emplace(body_);
    potentials_.emplace(body_);
    potentials_->set_grabs(grabs);
    potentials_->set_gravity(gravity);
    potentials_->set_tool(tool);
    potentials_->ties()->set(tear.law, tear.ties, state_.positions_mm);
    potentials_->surfaces().follow_split(surfaces, tear.parents, state_.positions_mm);
    integrator_->follow_split(before, tear.parents);
}

bool OwnCpuBackEnd::recover_from_inversion(StepReport& report) {
    const auto energy = [&](std::span<const Vec3> x) {
        return integrator_->potential_energy(x, *potentials_);
    };
    const auto recovered = recovery_->recover(state_.positions_mm, energy);
    if (!recovered || potentials_->free_share(state_.positions_mm, *recovered) < 1.0) return false;
    EnergyLedger& ledger = report.energy;
    ledger.inversion_recovery_loss =
        ledger.kinetic + energy(state_.positions_mm) - energy(*recovered);
    EnergyLedger after;
    potentials_->book(*recovered, state_.positions_mm, after);
    ledger.gravity_work += after.gravity_work;
    ledger.grab = after.grab;
    ledger.tether = after.tether;
    ledger.contact = after.contact;
    ledger.cohesion = after.cohesion;
    state_.positions_mm = *recovered;
    follow_positions(ledger);
    std::ranges::fill(state_.velocities_mm_per_s, Vec3::Zero());
    ledger.kinetic = 0.0;
    ledger.elastic = integrator_->elastic_energy(state_.positions_mm);
    integrator_->forget();
    report.degraded = true;
    report.message = "elements that had turned inside out were put right";
    return true;
}

}  // namespace

std::unique_ptr<CpuBackEnd> make_cpu_back_end(const BodyDescription& body,
                                              const StepperOptions& options) {
    return std::make_unique<OwnCpuBackEnd>(body, options);
}

}  // namespace hepatica
