// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson being played: a session of the lesson's scene on a thread of its own, evaluated by a
// LessonRun and recorded. No widgets.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

#include "core/base/job.h"
#include "core/lesson/lesson_run.h"
#include "core/scene/deform_back_end.h"
#include "core/session/recording_file.h"
#include "ui/simulation.h"

namespace hepatica {

// Shared by the thread that steps and the UI thread.
class LessonWatch {
  public:
    LessonWatch(Lesson lesson, std::shared_ptr<const PatientCase> patient,
                std::filesystem::path recording);

    const Lesson& lesson() const { return run_.lesson(); }
    const std::filesystem::path& recording() const { return recording_; }
    // As of the newest step. Any thread.
    LessonStanding standing() const;
    // The attempt has ended and its recording is complete on disk. Any thread.
    bool recorded() const { return recorded_; }
    // Where the lesson's marks are in a frame, mm. Any thread.
    std::vector<Vec3> marks_in(const Frame& frame) const { return run_.marks_in(frame); }

  private:
    friend struct LessonPlay;
    // Returns whether the attempt goes on after this step.
    bool see(const std::vector<Command>& commands, const Frame& frame, const std::stop_token& stop);
    void keep(RecordedStep step);

    LessonRun run_;  // used by the stepping thread, except for what never changes
    std::filesystem::path recording_;
    std::unique_ptr<RecordingWriter> writer_;  // null once the recording is complete
    std::atomic<bool> recorded_ = false;
    mutable std::mutex mutex_;  // guards standing_
    LessonStanding standing_;
};

struct LessonPlay {
    std::shared_ptr<LessonWatch> watch;
    std::unique_ptr<Simulation> simulation;  // running

    // Builds the scene, performs the setup and pauses; it pauses again at the verdict. The
    // recording is written while playing and is complete once the simulation is destroyed. Throws
    // InputError, also where a command of the setup is refused, and Cancelled.
    static LessonPlay begin(const Lesson& lesson, std::shared_ptr<const PatientCase> patient,
                            const std::filesystem::path& recording, Job& job,
                            const DeformBackEnd& back_end = cpu_back_end());
};

}  // namespace hepatica
