// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/cuda_back_end.h"

#include <set>
#include <utility>

#include "core/deform/stepper/cpu_back_end.h"
#include "gpu/machine/device_error.h"
#include "gpu/step/device_body.h"
#include "gpu/step/thinned_skeleton.h"

namespace hepatica::gpu {
namespace {

// With one diameter between nodes, solves take no more iterations than with half of one
// (docs/gpu.md).
constexpr double spacing_diameters = 1.0;
// A node adds 12 unknowns to the coarse space. With at least 16 vertices, which have 48 unknowns,
// the coarse space is much smaller than the body.
constexpr int least_vertices = 16;

// Empty for block-jacobi. A body with kernels has tetrahedra alone, so its mesh can replace a
// missing skeleton.
CoarseSkeleton skeleton_for(const BodyDescription& description, const StepperOptions& options) {
    if (options.solver == LinearSolverKind::block_jacobi) return {};
    return thinned(description.skeleton.size() > 0
                       ? description.skeleton
                       : skeleton_of_mesh(description.mesh, spacing_diameters),
                   description.mesh.vertices_mm, least_vertices);
}

// Whether the processor's steps of such a body contain core/deform/step/tension_stiffness.h.
bool would_have_tension(const StepperOptions& options) {
    return options.tension && options.model == ElementModel::corotated &&
           options.order == ElementOrder::linear;
}

class CudaBackEnd final : public StepBackEnd {
  public:
    CudaBackEnd(const BodyDescription& description, const StepperOptions& options,
                std::shared_ptr<Machine> machine, CudaOptions cuda)
        : options_(options),
          cuda_(std::move(cuda)),
          machine_(std::move(machine)),
          cpu_(make_cpu_back_end(description, options)) {
        if (why_not_on_device(cpu_->body(), options_)) return;
        guarded([&] {
            device_ = make_device_step(*machine_, cpu_->body(), cpu_->potentials(),
                                       skeleton_for(description, options), cuda_.precision);
        });
    }

    const Body& body() const override { return cpu_->body(); }
    bool on_device() const override { return device_ != nullptr; }
    void set_grabs(std::span<const Grab> grabs) override {
        cpu_->set_grabs(grabs);
        on_device([&] { device_->set_grabs(grabs); });
    }
    void set_gravity(const Vec3& gravity_mm_per_s2) override {
        cpu_->set_gravity(gravity_mm_per_s2);
        on_device([&] { device_->set_gravity(gravity_mm_per_s2); });
    }

    void set_tool(const std::optional<Tool>& tool) override { cpu_->set_tool(tool); }
    const std::optional<Tool>& tool() const override { return cpu_->tool(); }
    void lead_tool(double share, double dt_s) override { cpu_->lead_tool(share, dt_s); }
    std::vector<int> vertices_near_tool() const override { return cpu_->vertices_near_tool(); }
    bool free_of_tool(std::span<const Vec3> positions_mm) const override {
        return cpu_->free_of_tool(positions_mm);
    }
    bool tool_in_obstacle() const override { return cpu_->tool_in_obstacle(); }
    ToolLoad tool_load() const override { return cpu_->tool_load(); }
    SurfacesKept overlaps() const override { return cpu_->overlaps(); }
    void set_overlaps(const SurfacesKept& kept) override { cpu_->set_overlaps(kept); }
    std::vector<std::array<int, 2>> touching_nodes() const override {
        return cpu_->touching_nodes();
    }

    bool set_options(const StepperOptions& options) override {
        // These options decide whether the device has a body. Where that would change, a new back
        // end is needed; not where the device has failed, because another would fail, too.
        const bool here = lost_.empty() && !why_not_on_device(cpu_->body(), options);
        if (here == (device_ == nullptr) || !cpu_->set_options(options)) return false;
        options_ = options;
        return true;
    }

    void freeze(std::span<const std::uint8_t> frozen) override {
        cpu_->freeze(frozen);
        std::vector<std::uint8_t> held = body().fixed;
        for (std::size_t i = 0; i < held.size(); ++i)
            if (frozen[i] != 0) held[i] = 1;
        on_device([&] { device_->set_held(held); });
    }
    int live_elements() const override { return cpu_->live_elements(); }

    StepReport advance(double dt_s, const std::stop_token& stop) override;

    bool recover_from_inversion(StepReport& report) override {
        if (!cpu_->recover_from_inversion(report)) return false;
        follow_cpu();
        return true;
    }

    // Stress and the choice of the joints that part are computed on the processor; the device
    // follows the torn body.
    void find_stress(std::vector<Mat3>& stress_pa, std::vector<double>& energy_nj) override {
        cpu_->find_stress(stress_pa, energy_nj);
    }
    void tear(const BodyDescription& whole, const TornBody& torn) override {
        cpu_->tear(whole, torn);
        on_device([&] { device_->follow_tear(); });
        follow_cpu();
    }
    std::span<const SofteningTie> ties() const override { return cpu_->ties(); }

    const BodyState& state() const override { return cpu_->state(); }
    void set_state(const BodyState& state) override {
        cpu_->set_state(state);
        follow_cpu();
    }
    void set_velocities(const std::vector<Vec3>& velocities_mm_per_s) override {
        cpu_->set_velocities(velocities_mm_per_s);
        follow_cpu();
    }

    EnergyLedger energies() const override { return cpu_->energies(); }
    double grab_energy() const override { return cpu_->grab_energy(); }
    double contact_energy() const override { return cpu_->contact_energy(); }
    double cohesion_energy() const override { return cpu_->cohesion_energy(); }
    double kinetic_energy() const override { return cpu_->kinetic_energy(); }

    // The CPU's solver memory, with the device's appended at the end.
    SolverCheckpoint checkpoint() const override {
        SolverCheckpoint kept = cpu_->checkpoint();
        kept.memory.push_back(device_ ? device_->solver_memory() : 0.0);
        return kept;
    }
    void restore(const SolverCheckpoint& checkpoint) override {
        require_memory(!checkpoint.memory.empty() && checkpoint.memory.back() >= 0.0);
        SolverCheckpoint own = checkpoint;
        own.memory.pop_back();
        cpu_->restore(own);
        on_device([&] { device_->set_solver_memory(checkpoint.memory.back()); });
    }

  private:
    // If the device fails, the processor continues alone.
    template <class Work>
    void guarded(const Work& work) {
        try {
            work();
        } catch (const DeviceError& error) {
            device_.reset();
            lost_ = error.what();
        }
    }
    template <class Work>
    void on_device(const Work& work) {
        if (device_) guarded(work);
    }
    void follow_cpu() {
        on_device([&] { device_->set_state(cpu_->state()); });
    }
    std::optional<std::string> why_on_cpu() const;
    void say_once(const std::string& words);

    StepperOptions options_;
    CudaOptions cuda_;
    std::shared_ptr<Machine> machine_;
    std::unique_ptr<CpuBackEnd> cpu_;
    std::unique_ptr<DeviceStep> device_;
    std::string lost_;
    std::set<std::string> said_;
};

std::optional<std::string> CudaBackEnd::why_on_cpu() const {
    if (!lost_.empty()) return "the device failed (" + lost_ + ")";
    if (const auto reason = why_not_on_device(body(), options_)) return reason;
    return std::nullopt;
}

void CudaBackEnd::say_once(const std::string& words) {
    if (said_.insert(words).second) cuda_.say(words);
}

StepReport CudaBackEnd::advance(double dt_s, const std::stop_token& stop) {
    std::optional<std::string> reason = why_on_cpu();
    StepReport report;
    bool made = false;
    if (!reason) {
        on_device([&] { made = device_->advance(dt_s, options_.linear, report, stop); });
        reason = why_on_cpu();  // the device may have failed
    }
    if (reason) say_once("The processor makes the steps: " + *reason);
    if (made && device_) {
        ++cuda_.share->device;
        cuda_.share->solves += device_->solve_cost();
        cpu_->follow(device_->state(), report);
        if (would_have_tension(options_))
            say_once(
                "The device's steps leave out tension, by which taut vessels resist being turned: "
                "they err more where a vessel is pulled");
        return report;
    }
    if (device_ && !reason && !device_->left_because().empty())
        say_once("The processor makes single steps: " + device_->left_because());
    ++cuda_.share->processor;
    report = cpu_->advance(dt_s, stop);
    follow_cpu();
    return report;
}

}  // namespace

std::optional<std::string> why_not_on_device(const Body& body, const StepperOptions& options) {
    if (!has_kernels(body)) return "its elements have no kernels yet";
    if (options.newton_iterations > 1) return "Newton's method has no kernels yet";
    if (options.solver == LinearSolverKind::cholesky) return "the solver cholesky has no kernels";
    if (options.published || options.audit || options.velocity_error.alpha_per_s != 0.0 ||
        options.velocity_error.beta_s != 0.0)
        return "the published step, E of eq. (11) and audits have no kernels";
    return std::nullopt;
}

std::unique_ptr<StepBackEnd> make_cuda_back_end(const BodyDescription& body,
                                                const StepperOptions& options,
                                                std::shared_ptr<Machine> machine,
                                                const CudaOptions& cuda) {
    return std::make_unique<CudaBackEnd>(body, options, std::move(machine), cuda);
}

}  // namespace hepatica::gpu
