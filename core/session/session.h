// SPDX-License-Identifier: GPL-3.0-or-later
// Owns the world, applies commands, advances simulated time in steps of 1/60 s and publishes a
// Frame after each step, and within a step of several substeps that takes longer than it may. While
// nothing moves and no clock runs, it makes no steps and uses no processor time until the next
// command. The window's simulation thread only calls run(); a script calls step() in a loop. An
// error in a command or a step never ends the program: the session pauses, reports it in the frame,
// and returns to its last good state.
//
//     UI thread                               simulation thread
//     session.post(GrabPoint{p});             session.run(stop);      // or step() in a loop
//     if (session.update_frame())
//         view.show(session.frame());
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/base/frame_time.h"
#include "core/base/job.h"
#include "core/deform/stepper/quality_dial.h"
#include "core/deform/stepper/stepper.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/felt_force.h"
#include "core/scene/frame.h"
#include "core/scene/scene_spec.h"
#include "core/session/command.h"
#include "core/session/dial_in_use.h"
#include "core/session/led_point.h"
#include "core/session/recording.h"
#include "core/session/session_inbox.h"
#include "core/session/triple_buffer.h"

namespace hepatica {

class World;

// What one step did, for scripts and measurements.
struct SessionStep {
    std::uint64_t step = 0;        // number of this step, from 1
    double step_ms = 0.0;          // wall time of commands, physics, recording and frame
    double longest_wait_ms = 0.0;  // of it, for a frame: less where the step showed its parts
    std::uint64_t state_hash = 0;  // of the world after the step; 0 unless recording
    bool paused = false;           // whether simulated time stood still
    bool stopped = false;          // it was stopped midway and does not count, see Session::step
    StepReport deform;             // of the deforming body; empty where the scene has none
    std::vector<std::string>
        refused;  // in words: what was refused of this step, or came to nothing
};

class Session {
  public:
    // Builds the parts that the scene requires and publishes a frame of the world at rest. Begins
    // one stage of the job. Throws InputError where the patient lacks what the scene requires, and
    // Cancelled.
    Session(std::shared_ptr<const PatientCase> patient, const SceneSpec& spec, Job& job,
            const DeformBackEnd& back_end = cpu_back_end());
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // --- any thread -----------------------------------------------------------------------------
    // Queues a command, which is applied before the next step. Never waits for a step. A command
    // with a value out of range is then refused: the frame's message names it and the world is
    // unchanged. Of several consecutive MoveGrab only the newest is applied, and likewise of
    // consecutive MoveTool with share 1. Returns the command's number, see commands_taken().
    std::uint64_t post(Command command) { return inbox_.post(std::move(command)); }

    // `tell` is called after every published frame, on the thread that steps; it must neither wait
    // nor throw. It replaces an earlier one, which is never called after this returns; an empty
    // function removes it. May be called at any time from any thread, but not from within `tell`.
    void on_frame(std::function<void()> tell);

    // Time that drawing a picture takes [ms]; automatic quality subtracts it from the frame's
    // budget. May be called at any time from any thread.
    void set_drawing_ms(double ms) { drawing_ms_ = ms; }

    // A step whose substeps take longer than this publishes a frame of what it has computed so far:
    // a vessel that is let go is seen to swing back and does not jump. By the clock, which decides
    // only what is shown: the steps have the same bits. Such frames are not watched or recorded.
    // Call before the first step.
    void show_parts_after(double ms) { show_parts_after_ms_ = ms; }

    // Whether run() waits for a command: nothing happens until one is posted or a dial or a
    // recording is given. May be called at any time from any thread.
    bool waits_for_command() const { return inbox_.waited_for(); }

    // Uses another dial of the same body from the next step on, see DialInUse::take. While the
    // vessels tear, a dial without a setting that can is refused: the frame's message says so. May
    // be called at any time from any thread.
    void use_dial(QualityDial dial) { inbox_.hand_over(std::move(dial)); }

    // Starts a recording before the next step, in place of the present one. `begin` gets the
    // recording's start, which is the state at that time; the function that it returns gets every
    // step. Both run on the thread that steps. An empty function ends recording. The last good
    // state is set to the same state. May be called at any time from any thread.
    using Keep = SessionInbox::Keep;
    void record_from_now(SessionInbox::BeginRecording begin) { inbox_.hand_over(std::move(begin)); }

    // --- the reader's thread (UI) ---------------------------------------------------------------
    // Takes the newest frame; false where there is none since the last call. frame() stays valid
    // and unchanged until the next call.
    bool update_frame() { return frames_.update(); }
    const Frame& frame() const { return frames_.front(); }

    // --- the simulation thread (or any, while run() does not run) -------------------------------
    // Applies the queued commands, advances by one time step and publishes a frame. Refused
    // commands change nothing and are named in the frame's message. Any other error (no memory, a
    // defect) pauses the session, drops the rest of the step and of its commands, and returns the
    // world to its last good state; the frame then has `diverged` and the reason. A requested stop
    // ends the step within a few iterations. The step then does not count: it is not recorded or
    // shown to a watch, and published are at most parts of it. The world is half changed until the
    // next step(), which first returns to the last good state as after an error; its recording
    // begins with the commands of the stopped step, and a replay makes the same bits.
    SessionStep step(const std::stop_token& stop = {});
    // The same, stopped by a cancel of the job: then throws Cancelled.
    SessionStep step(const Job& job);
    // Call before each step() where run() does not run: an injection that has to be computed again
    // because vessels have torn is then shown by that step, which waits for it.
    void finish_injection();
    // Steps at the scene's rate until a stop is requested, which ends the present step: see step().
    // Where a step takes longer than its period, simulated time falls behind wall time and is not
    // caught up; real_time_factor of the frames says by how much it is slower. Where further steps
    // would change nothing (the last frame is `resting`), it waits for a command instead.
    void run(const std::stop_token& stop);

    // Passes every step to `keep`, on the thread that steps. Call it before the first step. Where
    // `keep` throws, the recording ends there and the session pauses as after any other error.
    void record(Keep keep) { keep_ = std::move(keep); }
    // Shows every step to `see`, on the thread that steps: the commands applied before it, as they
    // are recorded, and its frame before it is published. Call it before the first step. A watched
    // session rests only while it is paused, because time passes for the watch. Where `see` returns
    // false or throws, it is not called again; where it throws, the session also pauses as after
    // any other error. The token is that of the step, for a watch that waits.
    using Watch =
        std::function<bool(const std::vector<Command>&, const Frame&, const std::stop_token&)>;
    void watch(Watch see) { watch_ = std::move(see); }
    // The start of a recording of this session, without steps.
    const Recording& recording_start() const { return recording_start_; }
    // Continues from a keyframe of a session of the same patient and scene; all later steps have
    // the same bits as there. Throws InputError where patient or scene is another one, and where it
    // tears and no setting of the dial can.
    void restore(const Keyframe& keyframe);

    // Number, as post() returned it, of the newest command that has had its effect, if it has one;
    // 0: none.
    std::uint64_t commands_taken() const { return inbox_.commands_taken(); }

    // For what on_frame() tells: whether this frame shows a part of a step that is not done. Its
    // body has moved; everything else is as after the step before.
    bool within_step() const { return within_step_; }

    // Hash of everything that determines later steps.
    std::uint64_t state_hash() const;
    World& world() { return *world_; }
    const World& world() const { return *world_; }

  private:
    Keyframe keyframe() const;
    void begin_waiting_recording();
    void apply_waiting_commands(const std::stop_token& stop);
    // False where the command is refused.
    bool apply_and_record(const Command& command, const std::stop_token& stop);
    // Says it in the frame and in the step.
    void say_refused(const char* why);
    // Applies this step's pieces of timed moves.
    void lead_on(const std::stop_token& stop);
    struct Apply;  // one operator per command
    void apply(const Command& command, const std::stop_token& stop);
    // The form in which an applied command is recorded.
    Command as_recorded(const Command& command) const;
    // Calls `work`; any exception is passed to stop_after().
    template <class Work>
    void shielded(const Work& work) noexcept;
    void stop_after(const char* what, const char* remedy) noexcept;
    // Returns to the last good state but keeps the present settings. A grab of that state is
    // restored unless open_hand, a tool unless without_tool.
    void take_back(bool open_hand, bool without_tool);
    // After an error: returns to the last good state and records that.
    void recover();
    void govern();
    void keep_step(SessionStep& step);
    void show_to_watch(const Frame& frame, const std::stop_token& stop);
    // Shows an injection whose computation has ended.
    void finish_ready_injection();
    // Uses what the body can of this dial; where that is nothing, keeps the old dial and says why.
    void take_dial(QualityDial dial);
    // Time that a step may take: the frame's period minus the time for drawing.
    double budget_ms() const;
    void guard_state();
    void forget_divergence();
    // Whether no step would change anything before the next command.
    bool rests_after(const SessionStep& done) const;
    // Passes the frame that was filled to the reader.
    void hand_over_frame();
    // Publishes a frame within a step, of which this share is done.
    void publish_part(double share);
    // Fills a frame, passes it to the reader, and sets step.step_ms to the time since `start`.
    void publish(SessionStep& step, std::chrono::steady_clock::time_point start,
                 const std::stop_token& stop = {});

    SessionInbox inbox_;
    QualityDial whole_dial_;             // with the settings that cannot tear
    DialInUse dial_;                     // while vessels tear: without them
    bool setting_changed_ = false;       // the session changed the setting since the last step
    std::optional<double> measured_ms_;  // of the last step, if the governor is to know
    std::atomic<double> drawing_ms_{0.0};
    std::unique_ptr<World> world_;
    std::uint64_t step_ = 0;
    bool paused_ = false;
    LedPoint hand_, led_tool_;  // timed moves under way
    bool diverged_ = false;     // set by a divergence, cleared by resuming, restoring or resetting
    bool failed_ = false;       // the world may be half changed; cleared by recover()
    bool stopped_ = false;      // the last step was stopped midway; see recorded_
    bool within_step_ = false;  // see within_step()
    std::string message_;
    std::vector<std::string> refused_;  // in the present step
    RecordedStep recorded_;             // the present step
    std::uint64_t played_steps_ = 0;    // steps during which it was not paused
    std::shared_ptr<const Keyframe> last_good_;
    double real_time_factor_ = 1.0;
    bool resting_ = false;
    FeltForce felt_force_;   // for the frames alone
    FrameStatistics shown_;  // of the last whole step
    double show_parts_after_ms_ = 1e3 * frame_s;

    TripleBuffer<Frame> frames_;
    std::mutex listener_mutex_;
    std::function<void()> tell_of_frame_;
    Keep keep_;                        // empty: nothing is recorded
    std::uint64_t recorded_from_ = 0;  // number of the step before the recording's first
    Watch watch_;                      // empty: nobody watches
    std::vector<Command> watched_;     // commands of the present step
    Recording recording_start_;
};

}  // namespace hepatica
