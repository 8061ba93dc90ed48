// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded play in place of a simulation: the window shows its frames as if they were computed
// now. Commands do not change it.
#pragma once

#include <functional>
#include <memory>

#include "core/lesson/review_tape.h"
#include "ui/simulation.h"

namespace hepatica {

// Shared by the window's simulation and the review's controls. UI thread only.
struct ReviewScreen {
    std::shared_ptr<const ReviewTape> tape;
    std::shared_ptr<const Frame> wanted;  // the next frame for the window; not null
    std::function<void()> tell;           // announces it
    std::function<void()> hold;           // the user stops or starts the clock
    std::function<void()> touched;        // the user tries to play
    std::function<void()> gone;           // the window shows something else now

    // Chooses the frame of that moment.
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
