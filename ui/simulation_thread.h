// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a Session on a thread of its own until it is destroyed.
#pragma once

#include <memory>
#include <thread>
#include <utility>

#include "core/session/session.h"
#include "ui/simulation.h"

namespace hepatica {

// Starts at once; the destructor waits for the step under way.
class SimulationThread : public Simulation {
  public:
    explicit SimulationThread(std::unique_ptr<Session> session);
    ~SimulationThread() override;

    void post(Command command) override;
    void set_drawing_ms(double ms) override { session_->set_drawing_ms(ms); }
    void use_dial(const QualityDial& dial) override { session_->use_dial(dial); }
    void record_from_now(std::function<Keep(const Recording& start)> begin) override {
        session_->record_from_now(std::move(begin));
    }
    void on_frame(std::function<void()> tell) override { session_->on_frame(std::move(tell)); }
    bool update_frame() override { return session_->update_frame(); }
    const Frame& frame() const override { return session_->frame(); }

  private:
    std::unique_ptr<Session> session_;
    std::jthread thread_;
};

}  // namespace hepatica
