// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>

#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/patient/patient_case.h"
#include "core/scene/flow_part.h"
#include "core/scene/world.h"
#include "core/session/script.h"
#include "core/session/session.h"

namespace hepatica {

namespace {

struct Options {
    std::filesystem::path patient;
    std::filesystem::path script;
    std::filesystem::path record;
    int steps = 600;
    int threads = 0;
    double dt_s = 0.0;
    double quality = -1.0;
    std::string backend = "cpu";
};

struct Play {
    std::vector<double> step_ms;
    double real_time_factor = 0.0;
    int linear_iterations_max = 0;
    int degraded_steps = 0;
    std::string degraded_because;  // of the first such step
    bool finite = true;
};

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

bool is_finite(const World& world) {
    for (std::size_t v = 0; v < world.vertex_count(); ++v)
        if (!world.vertex_mm(static_cast<int>(v)).allFinite()) return false;
    return true;
}

Play play(Session& session, const std::vector<std::vector<Command>>& commands, Job& job) {
    Play result;
    for (const std::vector<Command>& now : commands) {
        for (const Command& command : now) session.post(command);
        const SessionStep step = session.step();
        if (step.paused) break;
        result.step_ms.push_back(step.step_ms);
        result.linear_iterations_max =
            std::max(result.linear_iterations_max, step.deform.linear_iterations);
        result.degraded_steps += step.deform.degraded ? 1 : 0;
        if (result.degraded_because.empty()) result.degraded_because = step.deform.message;
        result.finite = result.finite && is_finite(session.world());
        job.advance(static_cast<double>(step.step) / static_cast<double>(commands.size()));
    }
    const double wall_ms = std::accumulate(result.step_ms.begin(), result.step_ms.end(), 0.0);
    result.real_time_factor =
        1e3 * session.world().spec().dt_s * static_cast<double>(result.step_ms.size()) / wall_ms;
    return result;
}

void keep(const Session& session, const Options& options) {
    Recording recording = session.recording();
    recording.patient_path =
        std::filesystem::proximate(options.patient,
                                   std::filesystem::absolute(options.record).parent_path())
            .string();
    write_recording(options.record, recording);
}

SceneSpec scene_of(const Options& options, const Script& script) {
    SceneSpec spec = script.scene.value_or(default_scene());
    if (options.dt_s > 0.0) spec.dt_s = options.dt_s;
    if (options.quality >= 0.0 && spec.deform) spec.deform->quality = options.quality;
    return spec;
}

Json run(const Options& options, Job& job) {
    if (options.backend != "cpu")
        throw InputError("this build has no CUDA back end", "--backend", "Use --backend cpu");
    if (!options.record.empty()) require_writable(options.record);
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(options.threads);
    const Script script = read_script(options.script);
    job.begin_stage("Reading the case");
    auto patient = std::make_shared<const PatientCase>(read_case_without_voxels(options.patient));
    const SceneSpec spec = scene_of(options, script);
    Session session(patient, spec, job);
    session.keep_recording(!options.record.empty());
    job.begin_stage("Simulating");
    const Play played =
        play(session, schedule(script, patient->tree, spec.dt_s, options.steps), job);
    if (!options.record.empty()) keep(session, options);
    FlowPart* flow = session.world().flow();
    session.update_frame();
    const FrameStatistics& statistics = session.frame().statistics;
    return {{"script", script.name},
            {"steps", played.step_ms.size()},
            {"dt_s", spec.dt_s},
            {"tetrahedra", spec.deform ? patient->mesh.tetrahedra.size() : 0},
            {"step_ms",
             {{"median", quantile(played.step_ms, 0.5)},
              {"p95", quantile(played.step_ms, 0.95)},
              {"max", quantile(played.step_ms, 1.0)}}},
            {"real_time_factor", played.real_time_factor},
            {"linear_iterations_max", played.linear_iterations_max},
            {"degraded_steps", played.degraded_steps},
            {"degraded_because", played.degraded_because},
            {"expected_error", statistics.expected_error},
            {"error_reference", statistics.error_reference},
            {"contacts_max", 0},
            {"joints_broken", 0},
            {"vertices_split", 0},
            {"entropy", nullptr},
            {"mass_error_relative", flow != nullptr ? flow->mass_error_relative() : 0.0},
            {"finite", played.finite},
            {"state_hash", to_hex(session.state_hash())}};
}

}  // namespace

void add_simulate(CommandLine& line) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = line.add_verb("simulate", "Play a script on a case and measure",
                                   [options](Job& job) { return run(*options, job); });
    verb.add_option("case", options->patient, "Case to play on")->required();
    verb.add_option("--script", options->script, "Script, such as assets/scripts/drag.json")
        ->required();
    verb.add_option("--steps", options->steps, "How many steps")
        ->check(CLI::Range(1, 10'000'000))
        ->capture_default_str();
    verb.add_option("--dt-s", options->dt_s, "Time step [s]; else the script's, 1/60")
        ->check(CLI::Range(1e-4, 1.0));
    verb.add_option("--quality", options->quality, "The dial, 0 fastest to 1 most accurate")
        ->check(CLI::Range(0.0, 1.0));
    verb.add_option("--backend", options->backend, "Where the solver runs")
        ->check(CLI::IsMember({"cpu", "cuda"}))
        ->capture_default_str();
    verb.add_option("--threads", options->threads, "At most so many threads")
        ->check(CLI::Range(1, 1024));
    verb.add_option("--record", options->record, "Recording to write, NAME.hrec");
}

}  // namespace hepatica
