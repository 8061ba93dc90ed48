// SPDX-License-Identifier: GPL-3.0-or-later
// simulate: plays a script on a case and measures (app/measured_play.h).
#include <spdlog/spdlog.h>

#include <filesystem>
#include <optional>

#include "app/as_published.h"
#include "app/back_end_choice.h"
#include "app/measured_play.h"
#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_run.h"
#include "core/lesson/lesson_ties.h"
#include "core/mesh/mesh_io.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_part.h"
#include "core/scene/measured_dial.h"
#include "core/scene/world.h"
#include "core/session/recording_file.h"
#include "core/session/script.h"
#include "core/session/session.h"

namespace hepatica {

namespace {

struct SimulateChoices {
    std::filesystem::path patient;
    std::filesystem::path script;
    std::string lesson;
    std::filesystem::path record;
    std::filesystem::path final_mesh;
    std::filesystem::path steps_csv;
    int steps = 600;
    int threads = 0;
    double dt_s = 0.0;
    double quality = -1.0;
    bool automatic = false;
    bool as_published = false;
    bool fit_velocity_error = false;
    std::string backend = "cpu";
};

// Throws InputError where an option is about a body that deforms, and the scene has none.
void require_use_of_body(const SimulateChoices& options, const SceneSpec& scene) {
    const char* const about_body = !options.final_mesh.empty()  ? "--final-mesh"
                                   : options.quality >= 0.0     ? "--quality"
                                   : options.automatic          ? "--automatic"
                                   : options.fit_velocity_error ? "--fit-velocity-error"
                                                                : nullptr;
    if (scene.deform || about_body == nullptr) return;
    throw InputError("the scene has no deform, so its vessels keep their shape", about_body,
                     "Leave it out, or name a deform part in the scene");
}

SceneSpec scene_of(const SimulateChoices& options, const Script& script,
                   const std::optional<Lesson>& lesson) {
    SceneSpec spec = lesson ? lesson->scene : script.scene.value_or(default_scene());
    if (options.dt_s > 0.0) spec.dt_s = options.dt_s;
    if (options.quality >= 0.0 && spec.deform) spec.deform->quality = options.quality;
    if (options.as_published) use_as_published(spec);
    return spec;
}

// The commands of each step. A lesson begins with an extra step for its setup, so that the
// recording can be scored.
std::vector<std::vector<Command>> commands_of(const SimulateChoices& options, const Script& script,
                                              const std::optional<Lesson>& lesson, double dt_s,
                                              const std::shared_ptr<const PatientCase>& patient) {
    auto commands = schedule(script, patient->tree, dt_s, options.steps);
    if (lesson) commands.insert(commands.begin(), LessonRun(*lesson, patient).setup());
    if (options.as_published) use_as_published(commands);
    return commands;
}

// Explains which setting is used: the dial has only as many settings as were measured, so the
// requested quality is rarely met exactly.
void explain_quality(double wanted, const SceneSpec& spec, const PatientCase& patient,
                     const DeformBackEnd& back_end) {
    if (spec.deform->setting) {
        spdlog::warn("--quality {} changes nothing: the scene names its setting", wanted);
        return;
    }
    const QualityDial whole = dial_of(patient, back_end);
    const QualityDial dial = spec.tear ? dial_that_tears(whole) : whole;
    const std::size_t used = dial.index_at(wanted);
    if (dial.quality_of(used) == wanted) return;
    spdlog::info(
        "--quality {}: the dial has {} settings, and the most accurate that costs no more stands "
        "at {:.5g}",
        wanted, dial.front().size(), dial.quality_of(used));
}

Json run_simulate(const SimulateChoices& options, Job& job) {
    const BackEndChoice back_end = choose_back_end(options.backend);
    require_different({options.script, options.record, options.final_mesh, options.steps_csv});
    if (!options.record.empty()) require_growing_file(options.record, ".hrec");
    if (!options.final_mesh.empty()) require_writable_file(options.final_mesh, ".vtu");
    if (!options.steps_csv.empty()) require_writable_file(options.steps_csv, ".csv");
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(options.threads);
    const Script script = read_script(options.script);
    std::optional<Lesson> lesson;
    if (!options.lesson.empty()) lesson = find_lesson(options.lesson);
    job.expect_stages(3);
    job.begin_stage("Reading the case");
    auto patient = std::make_shared<const PatientCase>(read_case_without_voxels(options.patient));
    if (lesson)
        for (const std::string& misfit : misfits(*lesson, patient->tree))
            spdlog::warn("{}", misfit);
    const SceneSpec spec = scene_of(options, script, lesson);
    require_use_of_body(options, spec);
    if (options.quality >= 0.0) explain_quality(options.quality, spec, *patient, back_end.back_end);
    if (spec.deform && !spec.deform->setting)
        if (const auto words = words_on_left_out(back_end.back_end, measured_points(*patient));
            !words.empty())
            spdlog::warn("{}", words);
    Session session(patient, spec, job, back_end.back_end);
    say_where_obstacles_are_none(session.world());
    std::optional<RecordingWriter> recording;
    if (!options.record.empty()) {
        recording.emplace(options.record, session.recording_start());
        session.record([&](RecordedStep step) { recording->append(std::move(step)); });
    }
    job.begin_stage("Simulating");
    if (options.automatic) session.post(SetAutomaticQuality{true});
    const auto commands = commands_of(options, script, lesson, spec.dt_s, patient);
    const MeasuredPlay played =
        measure_play(session, commands,
                     {.fit = options.fit_velocity_error, .table = !options.steps_csv.empty()}, job);
    if (recording) recording->close();
    if (played.table) write_text_atomically(options.steps_csv, played.table->text());
    if (!options.final_mesh.empty())
        write_vtu(options.final_mesh, session.world().deform()->shape());
    Json answer{{"script", script.name},
                {"tetrahedra", spec.deform ? patient->mesh.tetrahedra.size() : 0}};
    answer.update(answer_of(session, played));
    answer["back_end"] = session.recording_start().back_end;
    answer["gpu"] = facts_of(back_end);
    return answer;
}

}  // namespace

void add_simulate(CommandLine& line) {
    auto options = std::make_shared<SimulateChoices>();
    CLI::App& verb = line.add_verb("simulate", "Play a script on a case and measure",
                                   [options](Job& job) { return run_simulate(*options, job); });
    verb.add_option("case", options->patient, "Case to play on")->required();
    verb.add_option("--script", options->script,
                    "Script, such as the program's own scripts/drag.json")
        ->required();
    verb.add_option("--lesson", options->lesson,
                    "Lesson to play, a file or a name such as gentle_pull: its scene in the place "
                    "of the script's, its setup before the first step");
    verb.add_option("--steps", options->steps, "How many steps")
        ->check(CLI::Range(1, 10'000'000))
        ->capture_default_str();
    verb.add_option("--dt-s", options->dt_s, "Time step [s]; else the script's, 1/60")
        ->check(CLI::Range(1e-4, 1.0));
    verb.add_option("--quality", options->quality, "The dial, 0 fastest to 1 most accurate")
        ->check(CLI::Range(0.0, 1.0));
    verb.add_flag("--automatic", options->automatic,
                  "Pick the most accurate setting whose steps are in time, as the window does");
    verb.add_flag("--fit-velocity-error", options->fit_velocity_error,
                  "Fit E of eq. (11) to the first 120 steps; a scene may name it: "
                  "\"velocity_error\": [alpha_per_s, beta_s]");
    verb.add_option("--backend", options->backend,
                    "Where the solver runs; cuda-emulated: the GPU's kernels on the processor")
        ->check(CLI::IsMember(back_end_names()))
        ->capture_default_str();
    verb.add_option("--threads", options->threads, "At most so many threads")
        ->check(CLI::Range(1, 1024));
    verb.add_option("--record", options->record,
                    "Recording to write, NAME.hrec; it grows as the play goes");
    verb.add_option("--final-mesh", options->final_mesh, "Last shape to write, NAME.vtu");
    verb.add_option("--steps-csv", options->steps_csv, "File to write, one line a step");
    CLI::Option* as_published = verb.add_flag(
        "--as-published", options->as_published,
        "As the paper has it: springs, eq. (12) taken whole, the published pressure law");
    for (const char* other : {"--quality", "--automatic"})
        as_published->excludes(verb.get_option(other));
    verb.get_option("--automatic")->excludes(verb.get_option("--quality"));
    for (const char* other : {"--dt-s", "--as-published"})
        verb.get_option("--lesson")->excludes(verb.get_option(other));
}

}  // namespace hepatica
