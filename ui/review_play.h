// SPDX-License-Identifier: GPL-3.0-or-later
// A tape of a play in the place of a simulation: the window shows its frames as if they were
// simulated now. Nothing can be done to them.
#pragma once

#include <functional>
#include <memory>

#include "core/lesson/review_tape.h"
#include "ui/simulation.h"

namespace hepatica {

// What the window's simulation and the controls of the review share. UI thread.
struct ReviewScreen {
    std::shared_ptr<const ReviewTape> tape;
    std::shared_ptr<const Frame> wanted;  // the next that the window takes over; not null
    std::function<void()> tell;           // that there is one
    std::function<void()> hold;           // the user stops the clock, or lets it run
    std::function<void()> touched;        // the user wants to play himself
    std::function<void()> gone;           // the window shows something else now

    // The frame of that moment.
    void show_at(double at_s);
};

class ReviewPlay : public Simulation {
  public:
    explicit ReviewPlay(std::shared_ptr<ReviewScreen> screen);
    ~ReviewPlay() override;

    void post(Command command) override;
    void on_frame(std::function<void()> tell) override { screen_->tell = std::move(tell); }
    bool update_frame() override;
    const Frame& frame() const override { return *shown_; }

  private:
    std::shared_ptr<ReviewScreen> screen_;
    std::shared_ptr<const Frame> shown_;
};

}  // namespace hepatica
