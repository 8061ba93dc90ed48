// SPDX-License-Identifier: GPL-3.0-or-later
// Interface of a running simulation for the window: it takes commands and provides the newest
// frame. Implemented by SimulationThread and ReviewPlay, and by tests.
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

    // Never blocks. Any thread.
    virtual void post(Command command) = 0;
    // Time that drawing a picture takes [ms], which the simulation leaves free in each frame.
    virtual void set_drawing_ms(double) {}
    // Another dial of the same body, see Session::use_dial(). Any thread.
    virtual void use_dial(const QualityDial&) {}
    // Starts recording, or ends it if `begin` is empty; see Session::record_from_now(). Any thread.
    using Keep = std::function<void(RecordedStep)>;
    virtual void record_from_now(std::function<Keep(const Recording& start)> /*begin*/) {}
    // UI thread. `tell` is called on any thread when a newer frame exists, and must not block; it
    // is not called for earlier frames. A simulation at rest makes no frames.
    virtual void on_frame(std::function<void()> tell) = 0;
    // UI thread. Takes over a newer frame and returns whether there was one; frame() is valid until
    // the next call.
    virtual bool update_frame() = 0;
    virtual const Frame& frame() const = 0;
};

}  // namespace hepatica
