// SPDX-License-Identifier: GPL-3.0-or-later
// A back end that passes every call to another one: the base of those that watch what passes, or
// change it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/deform/stepper/step_back_end.h"

namespace hepatica {

class ForwardingBackEnd : public StepBackEnd {
  public:
    explicit ForwardingBackEnd(std::unique_ptr<StepBackEnd> to) : to_(std::move(to)) {}

    const Body& body() const override { return to_->body(); }
    bool on_device() const override { return to_->on_device(); }
    void set_grabs(std::span<const Grab> grabs) override { to_->set_grabs(grabs); }
    void set_gravity(const Vec3& gravity_mm_per_s2) override {
        to_->set_gravity(gravity_mm_per_s2);
    }
    void set_tool(const std::optional<Tool>& tool) override { to_->set_tool(tool); }
    const std::optional<Tool>& tool() const override { return to_->tool(); }
    void lead_tool(double share, double dt_s) override { to_->lead_tool(share, dt_s); }
    std::vector<int> vertices_near_tool() const override { return to_->vertices_near_tool(); }
    bool free_of_tool(std::span<const Vec3> positions_mm) const override {
        return to_->free_of_tool(positions_mm);
    }
    bool tool_in_obstacle() const override { return to_->tool_in_obstacle(); }
    ToolLoad tool_load() const override { return to_->tool_load(); }
    SurfacesKept overlaps() const override { return to_->overlaps(); }
    void set_overlaps(const SurfacesKept& kept) override { to_->set_overlaps(kept); }
    std::vector<std::array<int, 2>> touching_nodes() const override {
        return to_->touching_nodes();
    }
    bool set_options(const StepperOptions& options) override { return to_->set_options(options); }
    void freeze(std::span<const std::uint8_t> frozen) override { to_->freeze(frozen); }
    int live_elements() const override { return to_->live_elements(); }
    StepReport advance(double dt_s, const std::stop_token& stop) override {
        return to_->advance(dt_s, stop);
    }
    bool recover_from_inversion(StepReport& report) override {
        return to_->recover_from_inversion(report);
    }
    void find_stress(std::vector<Mat3>& stress_pa, std::vector<double>& energy_nj) override {
        to_->find_stress(stress_pa, energy_nj);
    }
    void tear(const BodyDescription& whole, const TornBody& tear) override {
        to_->tear(whole, tear);
    }
    std::span<const SofteningTie> ties() const override { return to_->ties(); }
    const BodyState& state() const override { return to_->state(); }
    void set_state(const BodyState& state) override { to_->set_state(state); }
    void set_velocities(const std::vector<Vec3>& velocities_mm_per_s) override {
        to_->set_velocities(velocities_mm_per_s);
    }
    EnergyLedger energies() const override { return to_->energies(); }
    double grab_energy() const override { return to_->grab_energy(); }
    double contact_energy() const override { return to_->contact_energy(); }
    double cohesion_energy() const override { return to_->cohesion_energy(); }
    double kinetic_energy() const override { return to_->kinetic_energy(); }
    SolverCheckpoint checkpoint() const override { return to_->checkpoint(); }
    void restore(const SolverCheckpoint& checkpoint) override { to_->restore(checkpoint); }

  private:
    std::unique_ptr<StepBackEnd> to_;
};

}  // namespace hepatica
