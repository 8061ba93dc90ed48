// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/review.h"

#include <utility>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/lesson/play_events.h"
#include "core/lesson/score.h"
#include "core/session/replay.h"

namespace hepatica {

Review review(const Recording& recording, const std::optional<Lesson>& lesson,
              std::shared_ptr<const PatientCase> patient, ReviewTape& tape, Job& job,
              const DeformBackEnd& back_end, bool interrupted) {
    if (recording.steps.empty())
        throw InputError("holds no step", "recording", "Choose one of a play that was begun");
    std::optional<LessonRun> run;
    if (lesson) {
        require_same_scene(recording.scene, lesson->scene);
        run.emplace(*lesson, patient);
    }
    PlayEvents events;
    std::vector<double> ends_s;  // per step
    double now_s = 0.0;
    const ReplayResult result = replay(
        recording, patient, job, 0, back_end,
        [&](const std::vector<Command>& commands, const Frame& frame, const std::stop_token& stop) {
            if (!frame.statistics.paused) now_s += recording.scene.dt_s;
            ends_s.push_back(now_s);
            if (run) run->see(commands, frame, stop);
            tape.add(now_s, frame);
            for (PlayEvent& event :
                 events.see(now_s, commands, frame, run ? &run->standing() : nullptr))
                tape.note(std::move(event));
            return true;
        });
    Review found;
    found.diverged_at = result.diverged_at;
    if (result.diverged_at)
        tape.note({ends_s.at(*result.diverged_at - 1), PlayEventKind::trouble,
                   "From here on it is not what was played: another build of the program or "
                   "another processor recorded it"});
    if (run) {
        const bool ended = run->standing().outcome != LessonOutcome::running;
        run->end();
        found.standing = run->standing();
        if (!ended && interrupted)
            tape.note({now_s, PlayEventKind::trouble, "Interrupted before the end"});
        else if (!ended)
            for (const std::string& reason : found.standing->reasons)
                tape.note({now_s, PlayEventKind::not_passed, "Not passed: " + reason});
    }
    return found;
}

double played_s(const Recording& recording) {
    bool paused = false;
    std::size_t played = 0;
    for (const RecordedStep& step : recording.steps) {
        for (const Command& command : step.commands) {
            if (const auto* set = std::get_if<SetPaused>(&command)) paused = set->paused;
            if (std::holds_alternative<ResetWorld>(command) ||
                std::holds_alternative<RestoreSnapshot>(command))
                paused = false;
        }
        if (!paused) ++played;
    }
    return static_cast<double>(played) * recording.scene.dt_s;
}

}  // namespace hepatica
