// SPDX-License-Identifier: GPL-3.0-or-later
// A back end that fails when it is told to, in the ways in which a real one may: the reference with
// a fault before each of its calls.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/scene/deform_back_end.h"

namespace hepatica::test {

// Called with the name of what is about to be done: "make", "begin step", "step" (has been made),
// "set_gravity", "positions", "restore".
// What it throws is what goes wrong.
using Fault = std::function<void(const std::string& call)>;

class FailingStepper final : public Stepper {
  public:
    // What `words` holds every step says of itself, as degraded ones do; null or empty: none.
    FailingStepper(std::unique_ptr<Stepper> stepper, std::shared_ptr<Fault> fault,
                   std::shared_ptr<const std::string> words = nullptr)
        : stepper_(std::move(stepper)), fault_(std::move(fault)), words_(std::move(words)) {}

    void set_grabs(std::span<const Grab> grabs) override { stepper_->set_grabs(grabs); }
    void set_gravity(const Vec3& gravity_mm_per_s2) override {
        meet("set_gravity");
        stepper_->set_gravity(gravity_mm_per_s2);
    }
    void set_tool(const std::optional<Tool>& tool) override { stepper_->set_tool(tool); }
    void lead_tool(const Vec3& target_mm) override { stepper_->lead_tool(target_mm); }
    void turn_tool(const Vec3& by_rad) override { stepper_->turn_tool(by_rad); }
    void open_tool(double opening_mm) override { stepper_->open_tool(opening_mm); }
    const std::optional<Tool>& tool() const override { return stepper_->tool(); }
    const ToolLoad& tool_load() const override { return stepper_->tool_load(); }
    bool set_options(const StepperOptions& options) override {
        return stepper_->set_options(options);
    }
    StepReport step(double dt_s, const std::stop_token& stop = {},
                    const PartDone& part_done = {}) override {
        meet("begin step");
        StepReport report = stepper_->step(dt_s, stop, part_done);
        meet("step");  // with the state changed already
        if (words_ && !words_->empty()) {
            report.degraded = true;
            report.message = *words_;
        }
        return report;
    }
    bool on_device() const override { return stepper_->on_device(); }
    std::span<const Vec3> positions_mm() const override {
        meet("positions");
        return stepper_->positions_mm();
    }
    std::span<const Vec3> velocities_mm_per_s() const override {
        return stepper_->velocities_mm_per_s();
    }
    EnergyLedger energies() const override { return stepper_->energies(); }
    BodyState state() const override { return stepper_->state(); }
    void set_state(std::span<const Vec3> positions_mm,
                   std::span<const Vec3> velocities_mm_per_s) override {
        stepper_->set_state(positions_mm, velocities_mm_per_s);
    }
    StepperCheckpoint checkpoint() const override { return stepper_->checkpoint(); }
    void restore(const StepperCheckpoint& checkpoint) override {
        meet("restore");
        stepper_->restore(checkpoint);
    }

  private:
    void meet(const char* call) const {
        if (*fault_) (*fault_)(call);
    }

    std::unique_ptr<Stepper> stepper_;
    std::shared_ptr<Fault> fault_;
    std::shared_ptr<const std::string> words_;
};

inline DeformBackEnd failing_back_end(const std::shared_ptr<Fault>& fault,
                                      const std::shared_ptr<const std::string>& words = nullptr) {
    DeformBackEnd back_end = cpu_back_end();
    back_end.make = [make = back_end.make, fault, words](const BodyDescription& body,
                                                         const StepperOptions& options,
                                                         const LiveRegionOptions& region) {
        if (*fault) (*fault)("make");
        return std::make_unique<FailingStepper>(make(body, options, region), fault, words);
    };
    return back_end;
}

}  // namespace hepatica::test
