// SPDX-License-Identifier: GPL-3.0-or-later
// What a body's steps compute, and when, for any back end: substeps, sleep, the live region near
// the tools and where something moves (see live_region.h), recovery from inversion. Frozen nodes
// stay exactly where they are and live ones go on from where they were, so nothing jumps when the
// region changes.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/deform/stepper/live_region.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/step_back_end.h"

namespace hepatica {

class GovernedStepper final : public LiveStepper {
  public:
    using MakeBackEnd =
        std::function<std::unique_ptr<StepBackEnd>(const BodyDescription&, const StepperOptions&)>;

    // Without a region everything is computed until all of it sleeps. Throws InputError where body
    // or options are not valid.
    GovernedStepper(const BodyDescription& body, const StepperOptions& options,
                    const std::optional<LiveRegionOptions>& region, MakeBackEnd make);

    void set_grabs(std::span<const Grab> grabs) override;
    void set_gravity(const Vec3& gravity_mm_per_s2) override;
    bool set_options(const StepperOptions& options) override;
    StepReport step(double dt_s) override;
    std::span<const Vec3> positions_mm() const override;
    std::span<const Vec3> velocities_mm_per_s() const override;
    EnergyLedger energies() const override;
    BodyState state() const override { return back_end_->state(); }
    void set_state(std::span<const Vec3> positions_mm,
                   std::span<const Vec3> velocities_mm_per_s) override;
    StepperCheckpoint checkpoint() const override;
    void restore(const StepperCheckpoint& checkpoint) override;
    Extent extent() const override;

  private:
    bool asleep() const;
    void wake();
    std::vector<std::uint8_t> frozen_nodes() const;
    void change_region();
    void watch(double dt_s, StepReport& report);
    void look_for_inversion(double dt_s, StepReport& report);
    std::size_t nodes() const { return back_end_->body().rest_positions_mm.size(); }

    BodyDescription description_;
    StepperOptions options_;
    MakeBackEnd make_;
    std::unique_ptr<StepBackEnd> back_end_;
    std::optional<LiveRegion> region_;
    std::vector<Grab> grabs_;
    Vec3 gravity_mm_per_s2_ = Vec3::Zero();
    double tool_work_ = 0.0;  // since the last step
    double lost_ = 0.0;       // of motion, by freezing, since the last step
    double still_s_ = 0.0;    // for how long nothing has moved
    double settled_s_ = 0.0;  // for how long nothing has moved much
    EnergyLedger resting_;    // the energies at the end of the last step
};

}  // namespace hepatica
