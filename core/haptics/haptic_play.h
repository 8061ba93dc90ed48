// SPDX-License-Identifier: GPL-3.0-or-later
// Connects a device to a session: passes the local model from the thread that steps to the force
// loop, and runs the loop once a period on a thread of its own while a device is attached and a
// tool is in hand; otherwise that thread waits. The hand's motions enter the session's queue as
// commands like those of a mouse, so that recordings replay without a device.
//
//     HapticPlay haptics(session);
//     session.on_frame([&] { haptics.after_step(); });  // beside what else hears of frames
//     haptics.attach(driver);
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "core/haptics/force_loop.h"
#include "core/haptics/patch_feed.h"
#include "core/session/session.h"

namespace hepatica {

class HapticPlay {
  public:
    // The session must outlive it and must no longer call after_step() when it ends.
    explicit HapticPlay(Session& session) : session_(session) {}
    // With other local models than those of a PatchFeed, made as by PatchFeed::fill.
    using Fill = std::function<void(const DeformPart& part, double dt_s, LocalModel& model)>;
    HapticPlay(Session& session, Fill fill) : session_(session), fill_(std::move(fill)) {}
    ~HapticPlay() { detach(); }

    // --- any one thread ------------------------------------------------------------------------
    // Replaces the attached device. The step of the options is the scene's, whatever they say.
    // Throws InputError for traits out of range.
    void attach(std::shared_ptr<HapticDevice> device, const ForceLoopOptions& options = {});
    // Switches the force off and ends the thread, within a period.
    void detach();
    // Empty, or what has happened to the device and what can be done, or why nothing is felt at
    // present.
    std::string message() const;

    // --- the thread that steps -----------------------------------------------------------------
    // To be called after each frame; only whole steps count. Costs nothing without a device.
    // Neither waits nor throws: on an error no force is felt, and the message says why.
    void after_step() noexcept;

    // Called after each tick on the loop's thread, for measurements; set it before attach().
    void on_tick(std::function<void(const Tick&)> see) { see_ = std::move(see); }

  private:
    void run(const std::stop_token& stop, HapticDevice& device, const ForceLoopOptions& options);
    void say(std::string message, bool of_step = false);

    Session& session_;
    PatchFeed feed_;  // of the thread that steps
    Fill fill_ = [this](const DeformPart& part, double dt_s, LocalModel& model) {
        feed_.fill(part, dt_s, model);
    };
    TripleBuffer<LocalModel> models_;  // from there to the loop
    std::function<void(const Tick&)> see_;
    std::atomic<bool> attached_ = false;
    mutable std::mutex mutex_;
    std::condition_variable_any tool_comes_;
    bool tool_ = false;  // a tool is in hand; under mutex_
    std::string message_;
    bool of_step_ = false;  // the message came from after_step(); under mutex_
    std::shared_ptr<HapticDevice> device_;
    std::jthread thread_;
};

}  // namespace hepatica
