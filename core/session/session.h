// SPDX-License-Identifier: GPL-3.0-or-later
// The play: owns the world, takes commands, advances the clock at 60 Hz and publishes a Frame per
// step. The UI's simulation thread does nothing but run(); a script calls step() as fast as it can.
//
//     UI thread                               simulation thread
//     session.post(GrabPoint{p});             session.run(stop);      // or step() in a loop
//     if (session.update_frame())
//         view.show(session.frame());
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

#include "core/base/job.h"
#include "core/patient/patient_case.h"
#include "core/scene/frame.h"
#include "core/scene/scene_spec.h"
#include "core/session/command.h"
#include "core/session/triple_buffer.h"

namespace hepatica {

class World;
class Recorder;

// What one step did, for scripts and measurements.
struct SessionStep {
    std::uint64_t step = 0;        // number of this step, from 1
    double step_ms = 0.0;          // wall time
    std::uint64_t state_hash = 0;  // of positions, velocities and drug clock; only if recording
                                   // or asked for by hash_every_step()
    bool diverged = false;
};

class Session {
  public:
    // Builds the world's parts. Throws InputError (a spec that the case cannot serve), Cancelled.
    Session(std::shared_ptr<const PatientCase> patient, const SceneSpec& spec, Job& job);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // --- any thread -----------------------------------------------------------------------------
    // Queues a command for the next step boundary. Values out of range are refused there: the
    // frame's message says so, and the world is as before. Moves that no step has seen yet are
    // replaced by the newest.
    void post(Command command);

    // --- the reader's thread (UI) ---------------------------------------------------------------
    // True where a newer frame is there; frame() stays valid and unchanged until the next call.
    bool update_frame() { return frames_.update(); }
    const Frame& frame() const { return frames_.front(); }

    // --- the simulation thread ------------------------------------------------------------------
    // Applies the commands that wait, advances by one time step, publishes a frame.
    SessionStep step();
    // Steps at the scene's rate until asked to stop. When a step takes longer than its period,
    // simulated time runs slower than the wall's, and the frames' real_time_factor says by how
    // much; it never tries to catch up.
    void run(std::stop_token stop);

    void hash_every_step(bool on) { hash_every_step_ = on; }
    std::uint64_t state_hash() const;
    // From now on every step goes into the recorder, which must outlive the session or be removed
    // by nullptr.
    void record_to(Recorder* recorder);

    const World& world() const { return *world_; }

  private:
    struct Snapshot;

    void apply_commands();
    void apply(const Command& command);
    void publish();
    void keep_snapshot();
    void pause_on_divergence(const std::string& why);

    std::unique_ptr<World> world_;
    std::unique_ptr<Snapshot> last_good_;
    std::mutex queue_mutex_;
    std::vector<Command> queue_;
    TripleBuffer<Frame> frames_;
    Recorder* recorder_ = nullptr;
    bool hash_every_step_ = false;
};

}  // namespace hepatica
