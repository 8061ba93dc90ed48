// SPDX-License-Identifier: GPL-3.0-or-later
// The play: owns the world, takes commands, advances the clock at 60 Hz and publishes a Frame per
// step. Where nothing moves and no clock runs, it rests and costs nothing until the next command.
// The UI's simulation thread does nothing but run(); a script calls step() as fast as it can.
// No error of a command or a step ends the program: the session stops, says what happened, and goes
// back to its last good state.
//
//     UI thread                               simulation thread
//     session.post(GrabPoint{p});             session.run(stop);      // or step() in a loop
//     if (session.update_frame())
//         view.show(session.frame());
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/deform/stepper/quality_dial.h"
#include "core/deform/stepper/stepper.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/frame.h"
#include "core/scene/scene_spec.h"
#include "core/session/command.h"
#include "core/session/quality_governor.h"
#include "core/session/recording.h"
#include "core/session/triple_buffer.h"

namespace hepatica {

class World;

// What one step did, for scripts and measurements.
struct SessionStep {
    std::uint64_t step = 0;        // number of this step, from 1
    double step_ms = 0.0;          // wall time of commands, world, recording and frame
    std::uint64_t state_hash = 0;  // of the world; 0 unless a recording is kept
    bool paused = false;           // the world stood still
    StepReport deform;             // of the deforming body, where there is one
};

class Session {
  public:
    // Builds the world's parts and publishes a first frame of it at rest. Begins one stage of the
    // job. Throws InputError (a spec that the case cannot serve), Cancelled.
    Session(std::shared_ptr<const PatientCase> patient, const SceneSpec& spec, Job& job,
            const DeformBackEnd& back_end = cpu_back_end());
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // --- any thread -----------------------------------------------------------------------------
    // Queues a command for the next step boundary. Never waits for a step. What is out of range is
    // refused there: the frame's message says so, and the world is as before. Moves that no step
    // has seen yet are replaced by the newest.
    void post(Command command);

    // Called after every frame that is published, on the thread that steps; it must neither wait
    // nor throw. Takes the place of the one before, which is not called any more once this returns;
    // empty for none. Any time, from any thread but out of `tell` itself.
    void on_frame(std::function<void()> tell);

    // What drawing a picture takes [ms]: automatic quality leaves it that much of the frame. Any
    // time, from any thread.
    void set_drawing_ms(double ms) { drawing_ms_ = ms; }

    // Another dial of the same body, from the next step on. A setting in use that is not on it, but
    // was on the one before, is replaced: by what automatic quality picks, or by the one at the
    // same turn of the dial. Any time, from any thread.
    void use_dial(QualityDial dial);

    // --- the reader's thread (UI) ---------------------------------------------------------------
    // True where a newer frame is there; frame() stays valid and unchanged until the next call.
    bool update_frame() { return frames_.update(); }
    const Frame& frame() const { return frames_.front(); }

    // --- the simulation thread (or any, while run() does not run) -------------------------------
    // Applies the commands that wait, advances by one time step, publishes a frame. Commands that
    // are refused are named in the frame's message and change nothing. Any other error (no memory,
    // a defect) pauses the session, drops what is left of the step and its commands, and takes the
    // world back to its last good state; the frame says `diverged` and why.
    SessionStep step();
    // Steps at the scene's rate until asked to stop. When a step takes longer than its period,
    // simulated time runs slower than the wall's, and the frames' real_time_factor says by how
    // much; it never tries to catch up. Where further steps would change nothing (the last frame
    // says `resting`), it makes none and waits for a command.
    void run(const std::stop_token& stop);

    // Hands every step to `keep`, on the thread that steps, from the first one on: call it before.
    // Where `keep` throws, the recording ends there, and the session stops as for any error.
    void record(std::function<void(RecordedStep)> keep) { keep_ = std::move(keep); }
    // What a recording of this session begins with; no steps.
    const Recording& recording_start() const { return recording_start_; }
    // Goes on from a keyframe of a session of the same patient and scene, with the same bits.
    // Throws InputError where it is of another.
    void restore(const Keyframe& keyframe);

    // Of all that determines the steps to come.
    std::uint64_t state_hash() const;
    World& world() { return *world_; }
    const World& world() const { return *world_; }

  private:
    Keyframe keyframe() const;
    void apply_waiting_commands();
    struct Apply;  // one operator per command
    void apply(const Command& command);
    // What the recording keeps of a command that was applied.
    Command as_recorded(const Command& command) const;
    // The one barrier: whatever `work` throws ends in stop_after().
    template <class Work>
    void shielded(const Work& work) noexcept;
    void stop_after(const char* what, const char* remedy) noexcept;
    // To the last good state, but with the settings of now: what a person has chosen stays chosen.
    // A hand that is closed there closes again unless it is to be open.
    void take_back(bool open_hand);
    // From an error: takes the world back, and says so in the recording.
    void recover();
    void keep_step(SessionStep& step);
    // Shows an injection as soon as it is computed.
    void finish_ready_injection();
    // Of the dial's front, where the setting is one of its points.
    std::optional<std::size_t> point_of(const StepperOptions& setting) const;
    void use_point(std::size_t index);
    void take_dial(QualityDial dial);
    // What a frame may take beside the picture.
    double budget_ms() const;
    // Picks the setting of the next step by what this one cost.
    void govern(const SessionStep& done);
    void guard_state();
    void forget_divergence();
    // Nothing but a command can change anything after this step.
    bool rests_after(const SessionStep& done) const;
    void wait_for_command(const std::stop_token& stop);
    // Fills a frame in and hands it to the reader; `step.step_ms` is then the time since `start`.
    void publish(SessionStep& step, std::chrono::steady_clock::time_point start);

    QualityDial dial_;
    QualityGovernor governor_;
    std::optional<std::size_t> point_;  // of the dial's front, that is in use
    bool automatic_ = false;
    bool setting_changed_ = false;  // by the session, since the last step
    std::atomic<double> drawing_ms_{0.0};
    std::unique_ptr<World> world_;
    std::uint64_t step_ = 0;
    bool paused_ = false;
    bool diverged_ = false;  // until somebody resumes, restores or resets
    bool failed_ = false;    // the world may be half changed: until it was taken back
    std::string message_;
    RecordedStep recorded_;           // the step under way
    std::uint64_t played_steps_ = 0;  // not paused
    std::shared_ptr<const Keyframe> last_good_;
    double real_time_factor_ = 1.0;
    bool resting_ = false;

    std::mutex queue_mutex_;
    std::condition_variable_any command_waits_;
    std::vector<Command> queue_;
    std::mutex listener_mutex_;
    std::function<void()> tell_of_frame_;
    std::optional<QualityDial> waiting_dial_;

    TripleBuffer<Frame> frames_;
    std::function<void(RecordedStep)> keep_;  // none: nothing is recorded
    Recording recording_start_;
};

}  // namespace hepatica
