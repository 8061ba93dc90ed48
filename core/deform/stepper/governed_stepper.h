// SPDX-License-Identifier: GPL-3.0-or-later
// Decides what each step computes, for any back end: the number of substeps, whether the body
// sleeps, which part is live (near the tools and where something moves, see live_region.h), when
// inverted elements are repaired, and what tears (core/tear/tearing.h). A change of the live part
// moves no node, so that nothing jumps.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/deform/stepper/live_region.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/step_back_end.h"
#include "core/deform/stepper/swing_substeps.h"
#include "core/tear/tearing.h"

namespace hepatica {

class GovernedStepper final : public LiveStepper {
  public:
    using MakeBackEnd =
        std::function<std::unique_ptr<StepBackEnd>(const BodyDescription&, const StepperOptions&)>;

    // Without a region the whole body is computed until it sleeps. Throws InputError where body or
    // options are not valid.
    GovernedStepper(const BodyDescription& body, const StepperOptions& options,
                    const std::optional<LiveRegionOptions>& region, MakeBackEnd make);

    void set_grabs(std::span<const Grab> grabs) override;
    void set_gravity(const Vec3& gravity_mm_per_s2) override;
    void set_tool(const std::optional<Tool>& tool) override;
    void lead_tool(const Vec3& target_mm) override;
    void turn_tool(const Vec3& by_rad) override;
    void open_tool(double opening_mm) override;
    const std::optional<Tool>& tool() const override { return back_end_->tool(); }
    const ToolLoad& tool_load() const override { return tool_load_; }
    bool set_options(const StepperOptions& options) override;
    StepReport step(double dt_s, const std::stop_token& stop = {},
                    const PartDone& part_done = {}) override;
    bool on_device() const override { return back_end_->on_device(); }
    std::span<const Vec3> positions_mm() const override;
    std::span<const Vec3> velocities_mm_per_s() const override;
    EnergyLedger energies() const override;
    BodyState state() const override { return back_end_->state(); }
    void set_state(std::span<const Vec3> positions_mm,
                   std::span<const Vec3> velocities_mm_per_s) override;
    StepperCheckpoint checkpoint() const override;
    void restore(const StepperCheckpoint& checkpoint) override;
    Extent extent() const override;
    const Tearing* tearing() const override { return tearing_ ? &*tearing_ : nullptr; }
    void weaken(std::span<const int> joints, double factor) override;
    void cut(const Vec3& corner_mm, const Vec3& first_edge_mm, const Vec3& second_edge_mm) override;
    void set_tear(const TearState& state) override;

  private:
    bool asleep() const;
    void find_resting_energies();
    void wake();
    std::vector<std::uint8_t> frozen_nodes() const;
    LiveRegion new_region(const LiveRegionOptions& options) const;
    void change_region();
    double slow_mm_per_s() const;
    template <class Change>
    void change_tool_goal(const Change& change);
    void wake_near_tool();
    void wake_displaced();
    void wake_touched();
    void lead_tool_for(double dt_s, double share);
    StepReport advance(double dt_s, const std::stop_token& stop, const PartDone& part_done);
    bool free() const { return grabs_.empty() && !tool_led_; }
    void watch(double dt_s, StepReport& report);
    void look_for_inversion(double dt_s, StepReport& report);
    TearLoads tear_loads();
    void tear(StepReport& report);
    // Parts of restore(): throws InputError for another kind of stepper; restores solver and tear,
    // or changes nothing where it throws; restores the rest.
    void require_same_kind(const StepperCheckpoint& checkpoint) const;
    void restore_solver(const StepperCheckpoint& checkpoint, std::optional<Tearing> tearing);
    void restore_motion(const StepperCheckpoint& checkpoint);
    void follow_tear(StepBackEnd& back_end) const;
    void follow_tear();
    std::size_t nodes() const { return back_end_->body().rest_positions_mm.size(); }

    BodyDescription description_;
    StepperOptions options_;
    MakeBackEnd make_;
    std::unique_ptr<StepBackEnd> back_end_;
    std::optional<LiveRegion> region_;
    std::optional<Tearing> tearing_;
    SwingSubsteps swing_;
    std::vector<Mat3> stress_pa_;    // of each tetrahedron, after the last step
    std::vector<double> energy_nj_;  // the same
    std::vector<Grab> grabs_;
    Vec3 gravity_mm_per_s2_ = Vec3::Zero();
    bool tool_led_ = false;       // the tool is moving
    ToolLoad tool_load_;          // of the last step
    SelfLoad self_load_;          // of the last step
    ObstacleLoad obstacle_load_;  // of the last step
    double tool_work_ = 0.0;      // of grabs, tool and blade since the last step [nJ]
    double lost_ = 0.0;           // kinetic energy of nodes frozen since the last step [nJ]
    double still_s_ = 0.0;    // time for which every node has been slower than the sleep threshold
    double settled_s_ = 0.0;  // the same for the threshold of the search for inverted elements
    EnergyLedger resting_;    // energies at the end of the last step, reported during sleep
};

}  // namespace hepatica
