// SPDX-License-Identifier: GPL-3.0-or-later
// What other threads hand over to the thread that steps a session: commands, another dial, another
// recording. The stepping thread takes them between steps and sleeps here while there are none.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/deform/stepper/quality_dial.h"
#include "core/session/command.h"
#include "core/session/recording.h"

namespace hepatica {

class SessionInbox {
  public:
    using Keep = std::function<void(RecordedStep)>;
    using BeginRecording = std::function<Keep(const Recording& start)>;

    // --- any thread -----------------------------------------------------------------------------
    // Of several consecutive MoveGrab only the newest is kept, and likewise of consecutive MoveTool
    // with share 1. Returns the command's number: 1, 2 and so on.
    std::uint64_t post(Command command);
    // The newest dial and the newest recording replace earlier ones that were not taken yet.
    void hand_over(QualityDial dial);
    void hand_over(BeginRecording begin);
    // Whether the stepping thread sleeps in wait() and nothing is there to wake it.
    bool waited_for() const;

    // --- the thread that steps -------------------------------------------------------------------
    // The command is applied before all that are queued.
    void post_first(Command command);
    std::vector<Command> take_commands();
    // Number of the newest command that was taken, or replaced by one that was; 0: none.
    std::uint64_t commands_taken() const { return taken_; }
    std::optional<QualityDial> take_dial();
    std::optional<BeginRecording> take_recording();
    // Sleeps until something is handed over or a stop is requested.
    void wait(const std::stop_token& stop);
    // Sleeps until that time or a stop request; what is handed over does not wake it.
    void sleep_until(std::chrono::steady_clock::time_point due, const std::stop_token& stop);

  private:
    // Call it under mutex_.
    bool empty() const { return commands_.empty() && !dial_ && !recording_; }

    mutable std::mutex mutex_;
    std::condition_variable_any arrival_;
    std::vector<Command> commands_;
    std::optional<QualityDial> dial_;
    std::optional<BeginRecording> recording_;
    std::uint64_t posted_ = 0;  // commands so far
    std::uint64_t taken_ = 0;   // of the thread that steps
    bool waiting_ = false;
};

}  // namespace hepatica
