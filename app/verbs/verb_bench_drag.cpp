// SPDX-License-Identifier: GPL-3.0-or-later
// bench drag: motions of a hand on a patient's body, the times of the frames and the error of the
// motion (core/study/drag_study.h).
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/program_files.h"
#include "core/deform/body/element_name.h"
#include "core/patient/patient_case.h"
#include "core/scene/setting_json.h"
#include "core/study/drag_study.h"

namespace hepatica {

namespace {

constexpr int reference_substeps = 8;

struct BenchDragChoices {
    std::filesystem::path patient;
    std::vector<std::string> motions;
    std::filesystem::path script;  // empty: the program's own drag.json
    double quality = -1.0;
    std::string setting;
    HeardHand hand;
    bool whole = false;
    bool no_error = false;
    std::filesystem::path references;
    std::filesystem::path steps_csv;
    int threads = 0;
};

std::vector<std::string> all_motions() {
    std::vector<std::string> names = hand_motion_names();
    names.emplace_back("script");
    return names;
}

SceneSpec scene_of(const BenchDragChoices& options, const std::optional<Script>& script) {
    SceneSpec scene = script ? script->scene.value_or(default_scene()) : default_scene();
    if (!scene.deform)
        throw InputError("its scene has no body that deforms", options.script.string(),
                         "Name a deform part in it");
    scene.dt_s = SceneSpec{}.dt_s;
    if (options.quality >= 0.0) scene.deform->quality = options.quality;
    if (!options.setting.empty()) {
        const Json setting = Json::parse(options.setting, nullptr, false);
        if (setting.is_discarded())
            throw UsageError("is not JSON", "--setting", R"(Give for example {"substeps": 2})");
        scene.deform->setting = setting_from_json(setting);
    }
    return scene;
}

// RMS distance of the centreline from the reference for each frame; empty without a reference.
std::vector<double> missed_mm(const CentrelineMotion& motion, const CentrelineMotion& reference,
                              std::size_t frames) {
    std::vector<double> missed;
    if (reference.empty()) return missed;
    const std::size_t points = motion.size() / frames;
    for (std::size_t begin = 0; begin < motion.size(); begin += points)
        missed.push_back(motion_difference(std::span(motion).subspan(begin, points),
                                           std::span(reference).subspan(begin, points))
                             .rms_mm);
    return missed;
}

std::string csv_of(const std::string& motion, const HandPlay& played,
                   const std::vector<double>& missed) {
    std::ostringstream text;
    std::size_t step = 0;
    for (const HandFrame& frame : played.frames) {
        std::string message = frame.message;
        std::ranges::replace(message, '"', '\'');
        std::ranges::replace(message, '\n', ' ');
        text << motion << ',' << ++step << ',' << frame.time.cost_ms() << ',' << frame.time.wall_ms
             << ',' << frame.longest_wait_ms << ',' << frame.time.processor_ms << ','
             << frame.newton_iterations << ',' << frame.linear_solves << ','
             << frame.linear_iterations << ',' << frame.live_elements << ','
             << (frame.asleep ? 1 : 0) << ',' << (frame.degraded ? 1 : 0) << ',';
        if (!missed.empty()) text << missed[step - 1];
        text << ",\"" << message << "\"\n";
    }
    return text.str();
}

Json row_of(const std::string& motion, const DragSummary& summary) {
    return {{"motion", motion},
            {"steps", summary.steps},
            {"asleep", summary.asleep},
            {"median_ms", summary.frame_ms.median},
            {"p95_ms", summary.frame_ms.p95},
            {"p99_ms", summary.frame_ms.p99},
            {"longest_ms", summary.frame_ms.longest},
            {"frames_in_time", summary.frames_in_time},
            {"wall_median_ms", summary.wall_ms.median},
            {"wall_p95_ms", summary.wall_ms.p95},
            {"wall_longest_ms", summary.wall_ms.longest},
            {"longest_wait_ms", summary.longest_wait_ms},
            {"solves_median", summary.solves_median},
            {"solves_most", summary.solves_most},
            {"iterations_median", summary.iterations_median},
            {"iterations_most", summary.iterations_most},
            {"live_median", summary.live_median},
            {"live_most", summary.live_most},
            {"degraded", summary.degraded},
            {"error", nullptr},
            {"error_rms_mm", nullptr},
            {"error_largest_mm", nullptr},
            {"error_held", nullptr},
            {"degraded_because", summary.degraded_because}};
}

struct Study {
    Json rows = Json::array();
    Json setting;
    std::string element;
    std::size_t tetrahedra = 0;
    std::string csv =
        "motion,step,ms,wall_ms,longest_wait_ms,processor_ms,newton_iterations,solves,iterations,"
        "live_elements,"
        "asleep,degraded,error_rms_mm,message\n";
};

// The error while the hand holds the vessel, without the swing afterwards, which frames of 1/60 s
// cannot resolve.
double error_held(const CentrelineMotion& motion, const CentrelineMotion& reference,
                  const HandMotion& played) {
    const std::size_t vectors = motion.size() / static_cast<std::size_t>(played.steps) *
                                static_cast<std::size_t>(played.held_steps);
    return motion_difference(std::span(motion).first(vectors), std::span(reference).first(vectors))
        .relative;
}

void measure(const BenchDragChoices& options, const std::string& name,
             const std::shared_ptr<const PatientCase>& patient, Study& study, Job& job) {
    std::optional<Script> script;
    if (name == "script")
        script = read_script(options.script.empty() ? asset("scripts/drag.json") : options.script);
    const HandMotion motion = script ? motion_of(*script) : hand_motion(name);
    const auto region = options.whole ? PlayedRegion::whole_body : PlayedRegion::as_in_scenes;
    job.begin_stage("Playing " + name);
    HandTrial trial(patient, scene_of(options, script), region, job);
    trial.hear(options.hand);
    study.setting = to_json(trial.setting());
    study.element = element_name(trial.setting().model, trial.setting().order);
    const HandPlay played = trial.play(motion, job);
    Json row = row_of(name, summary_of(played));
    CentrelineMotion reference;
    if (!options.no_error) {
        job.begin_stage("Playing the reference of " + name);
        reference = options.references.empty()
                        ? trial.reference(motion, reference_substeps, job)
                        : trial.kept_reference(motion, reference_substeps, options.references, job);
        const MotionDifference difference = motion_difference(played.motion, reference);
        row["error"] = difference.relative;
        row["error_rms_mm"] = difference.rms_mm;
        row["error_largest_mm"] = difference.largest_mm;
        row["error_held"] = error_held(played.motion, reference, motion);
    }
    study.csv += csv_of(name, played, missed_mm(played.motion, reference, played.frames.size()));
    study.rows.push_back(std::move(row));
}

Json run_bench_drag(const BenchDragChoices& options, Job& job) {
    const std::vector<std::string> motions =
        options.motions.empty() ? all_motions() : options.motions;
    if (!options.script.empty() &&
        std::ranges::find(motions, std::string("script")) == motions.end())
        throw UsageError("is played by the motion \"script\" alone", "--script",
                         "Give --motion script, too, or leave it out");
    if (!options.steps_csv.empty()) require_writable_file(options.steps_csv, ".csv");
    if (!options.references.empty()) {
        require_writable_folder(options.references);
        std::filesystem::create_directories(options.references);
    }
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(options.threads);
    job.expect_stages(1 + static_cast<int>(motions.size()) * (options.no_error ? 1 : 2));
    job.begin_stage("Reading the case");
    const auto patient =
        std::make_shared<const PatientCase>(read_case_without_voxels(options.patient));
    Study study;
    study.tetrahedra = patient->mesh.tetrahedra.size();
    for (const std::string& motion : motions) measure(options, motion, patient, study, job);
    if (!options.steps_csv.empty()) write_text_atomically(options.steps_csv, study.csv);
    Json reference;
    if (!options.no_error)
        reference = "the same " + study.element + " on the same " +
                    std::to_string(study.tetrahedra) + " tetrahedra, the whole body, " +
                    std::to_string(reference_substeps) +
                    " substeps a frame, each solved to 1e-8 (what the mesh itself misses is not "
                    "in it)";
    return {{"tetrahedra", study.tetrahedra},
            {"region", options.whole ? "whole" : "as in scenes"},
            {"setting", study.setting},
            {"reference", reference},
            {"motions", study.rows}};
}

}  // namespace

void add_bench_drag(CommandLine& line) {
    auto options = std::make_shared<BenchDragChoices>();
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "drag",
        "Motions as hands make them on a patient's own body: the tail of the frames' times, the "
        "share of frames in time, and the error of that very motion",
        [options](Job& job) { return run_bench_drag(*options, job); });
    verb.add_option("CASE", options->patient, "Case to play on")->required();
    verb.add_option("--motion", options->motions, "Which motions; else all of them")
        ->check(CLI::IsMember(all_motions()));
    verb.add_option("--script", options->script,
                    "What the motion \"script\" plays; else the program's own drag.json");
    CLI::Option* quality =
        verb.add_option("--quality", options->quality, "The dial, 0 fastest to 1 most accurate")
            ->check(CLI::Range(0.0, 1.0));
    verb.add_option("--setting", options->setting,
                    R"(One setting exactly, as in a scene: '{"substeps": 2}')")
        ->excludes(quality);
    CLI::Option* heard =
        verb.add_option("--heard-every", options->hand.every,
                        "Hear the hand in every so many frames only, as between the pictures of a "
                        "window, and lead what it holds evenly in between")
            ->check(CLI::Range(1, 30));
    verb.add_flag("--at-once", options->hand.at_once,
                  "Put what it holds at once to where the hand is heard")
        ->needs(heard);
    verb.add_flag("--whole", options->whole, "Compute the whole body in every frame");
    CLI::Option* no_error = verb.add_flag("--no-error", options->no_error,
                                          "Leave out the reference, which takes minutes");
    verb.add_option("--references", options->references,
                    "Folder that keeps references for the next time; remove it when elements or "
                    "potentials change")
        ->excludes(no_error);
    verb.add_option("--steps-csv", options->steps_csv, "File to write, one line a frame");
    verb.add_option("--threads", options->threads, "At most so many threads")
        ->check(CLI::Range(1, 1024));
}

}  // namespace hepatica
