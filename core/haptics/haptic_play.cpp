// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/haptics/haptic_play.h"

#include <chrono>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/scene/world.h"

namespace hepatica {
namespace {

using Clock = std::chrono::steady_clock;

void require_traits(const HapticTraits& traits) {
    const auto require = [&](double value, bool good, const char* what) {
        if (!good)
            throw InputError("says that its " + std::string(what) + " is " + number_text(value),
                             traits.name, "Correct the traits in its driver: docs/haptics.md");
    };
    require(traits.period_s, traits.period_s >= 1e-4 && traits.period_s <= 1e-2, "period [s]");
    require(traits.latency_s, traits.latency_s >= 0.0 && traits.latency_s <= 0.1, "latency [s]");
    require(traits.resolution_mm, traits.resolution_mm >= 0.0 && traits.resolution_mm <= 10.0,
            "resolution [mm]");
    for (const auto& [value, what] : {std::pair(traits.damping_un_s_per_mm, "damping"),
                                      std::pair(traits.turn_damping_un_mm_s, "damping of turns"),
                                      std::pair(traits.force_limit_un, "limit of force"),
                                      std::pair(traits.torque_limit_un_mm, "limit of torque")})
        require(value, value > 0.0 && value <= 1e12, what);
}

}  // namespace

void HapticPlay::attach(std::shared_ptr<HapticDevice> device, const ForceLoopOptions& options) {
    require_traits(device->traits());
    detach();
    say("");
    device_ = std::move(device);
    {
        // An after_step() that began before detach() may still write it.
        const std::scoped_lock lock(mutex_);
        tool_ = false;
    }
    attached_ = true;
    ForceLoopOptions of_scene = options;
    of_scene.step_s = session_.world().spec().dt_s;
    // A resting session makes no frame, from which the loop would learn of the tool, without a
    // command.
    if (session_.world().deform() != nullptr) session_.post(ShiftTool{});
    thread_ = std::jthread(
        [this, of_scene](const std::stop_token& stop) { run(stop, *device_, of_scene); });
}

void HapticPlay::detach() {
    attached_ = false;
    thread_ = {};  // requests a stop and waits for it
    device_.reset();
    const std::scoped_lock lock(mutex_);
    if (std::exchange(of_step_, false)) message_.clear();
}

std::string HapticPlay::message() const {
    const std::scoped_lock lock(mutex_);
    return message_;
}

void HapticPlay::say(std::string message, bool of_step) {
    const std::scoped_lock lock(mutex_);
    if (of_step && !attached_) return;  // a device that was lost is told of
    message_ = std::move(message);
    of_step_ = of_step;
}

void HapticPlay::after_step() noexcept {
    if (!attached_ || session_.within_step()) return;
    LocalModel& model = models_.back();
    bool filled = true;
    try {
        model.tool = false;
        const World& world = session_.world();
        if (world.deform() != nullptr) fill_(*world.deform(), world.spec().dt_s, model);
    } catch (const std::exception& error) {
        filled = false;
        model = {};
        say(std::string("Nothing is felt: ") + error.what(), true);
    }
    model.commands_taken = session_.commands_taken();
    const bool tool = model.tool;
    models_.publish();
    const std::scoped_lock lock(mutex_);
    if (filled && std::exchange(of_step_, false)) message_.clear();
    if (std::exchange(tool_, tool) != tool) tool_comes_.notify_one();
}

void HapticPlay::run(const std::stop_token& stop, HapticDevice& device,
                     const ForceLoopOptions& options) {
    ForceLoop loop(
        device, models_, [this](Command c) { return session_.post(std::move(c)); }, options);
    const auto period = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(device.traits().period_s));
    while (!stop.stop_requested()) {
        {
            std::unique_lock lock(mutex_);
            if (!tool_comes_.wait(lock, stop, [this] { return tool_; })) break;
        }
        Tick tick;
        Clock::time_point due = Clock::now();
        do {
            tick = loop.tick();
            if (see_) see_(tick);
            due = std::max(due + period, Clock::now());  // lost time is not caught up
            std::this_thread::sleep_until(due);
        } while (tick.tool && !tick.lost && !stop.stop_requested());
        if (tick.lost) {
            const std::scoped_lock lock(mutex_);
            attached_ = of_step_ = false;
            message_ = "The " + device.traits().name +
                       " no longer answers: its force is off and the play goes on. Check its cable "
                       "and its power, then attach it again";
            return;
        }
    }
    device.write({});
}

}  // namespace hepatica
