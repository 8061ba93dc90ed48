// SPDX-License-Identifier: GPL-3.0-or-later
// What the window needs of a running simulation: somewhere to send commands, and the newest frame.
// The real one is SimulationThread; tests put their own in its place.
#pragma once

#include <functional>

#include "core/deform/stepper/quality_dial.h"
#include "core/scene/frame.h"
#include "core/session/command.h"
#include "core/session/recording.h"

namespace hepatica {

class Simulation {
  public:
    virtual ~Simulation() = default;

    // Never waits. Any thread.
    virtual void post(Command command) = 0;
    // What drawing a picture takes: the simulation leaves it that much of the frame.
    virtual void set_drawing_ms(double) {}
    // Another dial of the same body, see Session::use_dial(). Any thread.
    virtual void use_dial(const QualityDial&) {}
    // Records from now on, or ends that; see Session::record_from_now(). Any thread.
    using Keep = std::function<void(RecordedStep)>;
    virtual void record_from_now(std::function<Keep(const Recording& start)> /*begin*/) {}
    // UI thread: `tell` is called on any thread whenever a newer frame is there, and must not wait.
    // Frames that came before are not told of. A simulation at rest makes no frames.
    virtual void on_frame(std::function<void()> tell) = 0;
    // UI thread: true where a newer frame is there; frame() stays as it is until the next call.
    virtual bool update_frame() = 0;
    virtual const Frame& frame() const = 0;
};

}  // namespace hepatica
