// SPDX-License-Identifier: GPL-3.0-or-later
// bench keyframe: the cost that a keyframe adds to a step of a recording.
#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/step_times.h"
#include "app/verbs/verbs.h"
#include "core/base/program_files.h"
#include "core/patient/patient_case.h"
#include "core/scene/world.h"
#include "core/session/script.h"
#include "core/session/session.h"

namespace hepatica {

namespace {

struct BenchKeyframeChoices {
    std::filesystem::path patient;
    std::filesystem::path script;  // empty: the program's own drag.json
    int steps = 600;
};

double milliseconds_of(const std::chrono::steady_clock::duration& time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

Json row_of(const StepTimes& times) {
    return {{"median", times.quantile(0.5)},
            {"p95", times.quantile(0.95)},
            {"longest", times.quantile(1.0)}};
}

// Times every step without a keyframe and with one taken at its end; in play only every 60th step
// takes one.
Json run_bench_keyframe(const BenchKeyframeChoices& options, Job& job) {
    job.expect_stages(3);
    job.begin_stage("Reading the case");
    const auto patient =
        std::make_shared<const PatientCase>(read_case_without_voxels(options.patient));
    const Script script =
        read_script(options.script.empty() ? asset("scripts/drag.json") : options.script);
    Session session(patient, script.scene.value_or(default_scene()), job);
    job.begin_stage("Simulating");
    StepTimes without, with, alone;
    const auto commands =
        schedule(script, patient->tree, session.world().spec().dt_s, options.steps);
    for (const std::vector<Command>& now : commands) {
        for (const Command& command : now) session.post(command);
        SessionStep step = session.step(job);
        if (step.paused) break;
        without.add(step);
        const auto begin = std::chrono::steady_clock::now();
        const auto kept = std::make_shared<const WorldCheckpoint>(session.world().checkpoint());
        const double keyframe_ms = milliseconds_of(std::chrono::steady_clock::now() - begin);
        step.step_ms += keyframe_ms;
        with.add(step);
        step.step_ms = keyframe_ms;
        alone.add(step);
        job.advance(static_cast<double>(without.steps()) / static_cast<double>(commands.size()));
    }
    return {{"steps", without.steps()},
            {"steps_asleep", without.asleep()},
            {"tetrahedra", patient->mesh.tetrahedra.size()},
            {"step_ms", row_of(without)},
            {"step_with_keyframe_ms", row_of(with)},
            {"keyframe_ms", row_of(alone)}};
}

}  // namespace

void add_bench_keyframe(CommandLine& line) {
    const auto options = std::make_shared<BenchKeyframeChoices>();
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "keyframe",
        "What a keyframe adds to a step: a played script, each step without and with one",
        [options](Job& job) { return run_bench_keyframe(*options, job); });
    verb.add_option("case", options->patient, "Case to play on")->required();
    verb.add_option("--script", options->script,
                    "Script to play; else the program's own drag.json");
    verb.add_option("--steps", options->steps, "How many steps")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
}

}  // namespace hepatica
