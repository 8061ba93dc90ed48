// SPDX-License-Identifier: GPL-3.0-or-later
// review: lists what happened in a recording, and when (core/lesson/review.h).
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <string>

#include "app/back_end_choice.h"
#include "app/recorded_patient.h"
#include "app/verbs/verbs.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/play_notes.h"
#include "core/lesson/review.h"
#include "core/lesson/score.h"
#include "core/session/recording_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct ReviewChoices {
    fs::path recording;
    std::string lesson;
    fs::path patient;
};

Json run_review(const ReviewChoices& options, Job& job) {
    const Recording recording = read_recording(options.recording);
    // Notes are read before the long replay, so that errors appear at once.
    const std::vector<PlayNote> read = read_notes(options.recording);
    for (const std::string& warning : recording.warnings) spdlog::warn("{}", warning);
    const auto lesson =
        with_course_pass(options.lesson.empty() ? built_in_lesson_of(recording)
                                                : std::optional(find_lesson(options.lesson)),
                         options.recording);
    constexpr int building_and_replaying = 2;
    const BuiltInCache no_cache;
    const auto patient = std::make_shared<const PatientCase>(recorded_patient(
        recording, options.recording,
        lesson ? case_of_lesson(*lesson, options.lesson, options.patient) : options.patient,
        &no_cache, building_and_replaying, job));
    ReviewTape tape(0);  // events only
    const Review found =
        review(recording, lesson, patient, tape, job, choose_back_end(recording.back_end).back_end,
               interrupted_beside(options.recording));
    if (found.diverged_at) spdlog::warn("diverged at step {}", *found.diverged_at);
    Json events = Json::array(), notes = Json::array();
    for (const PlayEvent& event : tape.events()) events.push_back(to_json(event));
    for (const PlayNote& note : read) notes.push_back({{"at_s", note.at_s}, {"text", note.text}});
    return {{"lesson", lesson ? Json(lesson->name) : Json()},
            {"time_s", tape.end_s()},
            {"events", events},
            {"notes", notes}};
}

}  // namespace

void add_review(CommandLine& line) {
    auto options = std::make_shared<ReviewChoices>();
    CLI::App& verb = line.add_verb("review", "Say what happened in a recording, and when",
                                   [options](Job& job) { return run_review(*options, job); });
    verb.add_option("recording", options->recording, "What was played, NAME.hrec")->required();
    verb.add_option("--lesson", options->lesson,
                    "Lesson that was played: a file, or the name of one that comes with the "
                    "program; none: the built-in one with the recorded scene, if any");
    verb.add_option("--patient", options->patient,
                    "Case that was recorded; none: the one beside the recording that fits, or the "
                    "built-in patient");
}

}  // namespace hepatica
