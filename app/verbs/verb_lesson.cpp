// SPDX-License-Identifier: GPL-3.0-or-later
// lesson: scores a recording of a lesson (core/lesson/score.h).
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <string>

#include "app/back_end_choice.h"
#include "app/output_place.h"
#include "app/recorded_patient.h"
#include "app/verbs/verbs.h"
#include "core/base/atomic_write.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_ties.h"
#include "core/lesson/score.h"
#include "core/session/recording_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct LessonChoices {
    std::string lesson;
    fs::path recording;
    fs::path patient;
    fs::path csv;
};

Json run_lesson(const LessonChoices& options, Job& job) {
    require_different({options.recording, options.csv});
    if (!options.csv.empty()) require_writable_file(options.csv, ".csv");
    const Lesson lesson = *with_course_pass(find_lesson(options.lesson), options.recording);
    const Recording recording = read_recording(options.recording);
    for (const std::string& warning : recording.warnings) spdlog::warn("{}", warning);
    constexpr int building_and_replaying = 2;
    const BuiltInCache no_cache;
    const auto patient = std::make_shared<const PatientCase>(recorded_patient(
        recording, options.recording, case_of_lesson(lesson, options.lesson, options.patient),
        &no_cache, building_and_replaying, job));
    for (const std::string& misfit : misfits(lesson, patient->tree)) spdlog::warn("{}", misfit);
    const Score scored =
        score(recording, lesson, patient, job, choose_back_end(recording.back_end).back_end);
    if (!options.csv.empty()) write_text_atomically(options.csv, to_csv(scored.standing.metrics));
    return to_json(scored.standing, lesson);
}

}  // namespace

void add_lesson(CommandLine& line) {
    auto options = std::make_shared<LessonChoices>();
    CLI::App& verb = line.add_verb("lesson", "Score a recording of a lesson",
                                   [options](Job& job) { return run_lesson(*options, job); });
    verb.add_option("lesson", options->lesson,
                    "Lesson: a file, or the name of one that comes with the program, such as "
                    "gentle_pull")
        ->required();
    verb.add_option("--recording", options->recording, "What was played")->required();
    verb.add_option("--patient", options->patient,
                    "Case that was recorded; none: the one beside the recording that fits, or the "
                    "built-in patient");
    verb.add_option("--csv", options->csv, "Metrics as a table, NAME.csv");
}

}  // namespace hepatica
