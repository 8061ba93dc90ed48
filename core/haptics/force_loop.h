// SPDX-License-Identifier: GPL-3.0-or-later
// The haptic loop: from one sample of the device to the force in response, a thousand times a
// second, and from its pose to commands, once per step of the simulation. A tick reads the device
// and the newest local model and otherwise depends only on its own state: no clock, no lock except
// for posting a command, and no allocation except to take a new model and to post, once per step.
//
//   device pose ─► local model in series with the coupling ─► limits ─► passivity ─► device force
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/haptics/haptic_device.h"
#include "core/haptics/local_model.h"
#include "core/haptics/passivity_controller.h"
#include "core/session/command.h"
#include "core/session/triple_buffer.h"

namespace hepatica {

struct ForceLoopOptions {
    double step_s = 1.0 / 60.0;  // of the simulation; HapticPlay takes its scene's instead
    // For measurements of their effects. By default the coupling is the stiffest that the device's
    // traits allow.
    std::optional<double> coupling_un_per_mm{}, turn_coupling_un_mm{};
    bool controlled = true;  // by the passivity controller
};

// What one tick did.
struct Tick {
    bool lost = false;                 // the device is lost; nothing is written to it any more
    bool tool = false;                 // a tool is in hand
    int contacts = 0;                  // of the local model
    HapticForce force{};               // as written
    double damping_un_s_per_mm = 0.0;  // added by the passivity controller
};

// Use it on one thread. Device and models must outlive it.
class ForceLoop {
  public:
    // Takes a command that leads the tool and returns its number, as Session::post does.
    using Post = std::function<std::uint64_t(Command)>;
    // A tool that comes into hand is led from its position by the displacement of the handle since
    // then, so that taking another tool brings the hand back to the middle of its workspace.
    ForceLoop(HapticDevice& device, TripleBuffer<LocalModel>& models, Post post,
              const ForceLoopOptions& options = {});

    Tick tick();
    const PassivityController& passivity() const { return passivity_; }

  private:
    void take(const LocalModel& model, const HapticPose& handle);
    Vec6 way_to(const HapticPose& handle) const;
    Vec3 place_of(const HapticPose& handle) const;
    HapticForce within_limits(const Vec6& both) const;
    HapticForce faded() const;
    void lead(const HapticPose& handle);

    HapticDevice& device_;
    TripleBuffer<LocalModel>& models_;
    Post post_;
    ForceLoopOptions options_;
    LocalForce local_;
    PassivityController passivity_;

    // A tool in hand: it was at tool_mm when the handle was at `handle`.
    struct Grip {
        HapticPose handle;
        Vec3 tool_mm;
    };
    std::optional<Grip> grip_;
    Vec3 centre_mm_ = Vec3::Zero();  // as in the model
    // A turn that was posted, but is not in the model yet.
    struct PostedTurn {
        std::uint64_t command;
        Vec3 by_rad;
    };
    std::vector<PostedTurn> posted_turns_;
    Vec3 left_rad_ = Vec3::Zero();  // that the tool of the model will turn by all commands so far
    HapticPose led_;                // pose of the last commands
    Vec6 fading_ = Vec6::Zero();    // force of the last model minus that of this one
    int ticks_in_step_ = 1, since_model_ = 0, since_lead_ = 0;  // ticks
    std::uint64_t number_ = 0;
    std::uint64_t tool_number_ = 0;  // of the tool in hand
    int silent_ = 0;                 // ticks without a new sample
    bool lost_ = false;
};

}  // namespace hepatica
