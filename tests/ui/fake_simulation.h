// SPDX-License-Identifier: GPL-3.0-or-later
// A simulation without physics for tests of the window: what is held goes where it is pulled, its
// surroundings follow less, every command is kept, and each update_frame() is one step. Sixty times
// a second it says that a frame is there: it never rests.
#pragma once

#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "ui/patient_loader.h"
#include "ui/simulation.h"

namespace hepatica::testing {

// UI thread only.
class FakeSimulation : public Simulation {
  public:
    explicit FakeSimulation(Frame rest);

    void post(Command command) override;
    void on_frame(std::function<void()> tell) override;
    bool update_frame() override;
    const Frame& frame() const override { return frame_; }

    const std::vector<Command>& commands() const { return commands_; }

    // As a session does whose body diverged: it stops of its own accord at its next step and says
    // why.
    void diverge() { diverges_ = true; }

    // As a solver says it of a degraded step; empty: of none.
    void say_of_step(const std::string& words);

    // From the next frame on.
    void show_tear(const std::optional<TearView>& tear) { tear_ = tear; }

  private:
    void apply(const Command& command);
    void stop();
    void go_on();
    void pull_to(const Vec3& target_mm);
    void add_tool(const AddTool& tool);
    void lead_tool(const Vec3& by_mm);

    Frame rest_;  // when the present pull began
    Frame frame_;
    std::vector<float> at_rest_;
    std::vector<Command> commands_;
    std::vector<Command> waiting_;
    std::unique_ptr<QTimer> timer_;
    double drug_speed_ = 1.0;
    bool diverges_ = false;
    std::optional<TearView> tear_;
};

// The fake tree (tests/render/fake_frame.h) as a patient whose simulation is fake; `simulation`
// receives a pointer to it, valid as long as the patient is.
LoadedPatient fake_patient(FakeSimulation** simulation = nullptr);

}  // namespace hepatica::testing
