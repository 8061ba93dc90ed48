// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "app/as_published.h"
#include "app/back_end_choice.h"
#include "app/output_place.h"
#include "app/step_times.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/deform/step/damping_regression.h"
#include "core/mesh/mesh_io.h"
#include "core/patient/patient_case.h"
#include "core/scene/bleeding.h"
#include "core/scene/crossings.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/world.h"
#include "core/session/recording_file.h"
#include "core/session/script.h"
#include "core/session/session.h"

namespace hepatica {

namespace {

struct Options {
    std::filesystem::path patient;
    std::filesystem::path script;
    std::filesystem::path record;
    std::filesystem::path final_mesh;
    int steps = 600;
    int threads = 0;
    double dt_s = 0.0;
    double quality = -1.0;
    bool automatic = false;
    bool as_published = false;
    bool fit_velocity_error = false;
    std::string backend = "cpu";
};

struct Play {
    StepTimes times;
    Json real_time_factor;  // null where nothing was played
    int linear_iterations_max = 0;
    int degraded_steps = 0;
    std::string degraded_because;  // of the first such step
    int setting_changes = 0;
    Json velocity_error_fit;  // null unless asked for
    int contacts_max = 0;     // points in a tool's pad and pairs of features in the vessels' own
    int rows_max = 0;         // normal and, against a tool, two of friction
    double penetration_max_mm = 0.0;
    double tool_force_max_un = 0.0;
    int hand_at_limit_steps = 0, tool_at_limit_steps = 0;
    double momentum_error_relative = 0.0;  // see MomentumBalance
    TearReport tear;                       // of the last step
    double torn_nj = 0.0;                  // energy of fracture
    bool finite = true;
};

bool is_finite(const World& world) {
    for (std::size_t v = 0; v < world.vertex_count(); ++v)
        if (!world.vertex_mm(static_cast<int>(v)).allFinite()) return false;
    return true;
}

// The first steps' states, for the regression of eq. (11).
class MotionRecorder {
  public:
    void keep(const DeformPart& deform) {
        constexpr std::size_t most_states = 120;
        if (states_.size() < most_states) states_.push_back(deform.state());
    }
    Json fit(const DeformPart& deform) const {
        const StepperOptions& setting = deform.setting();
        const Body body = build_body(deform.body(), setting.model, setting.order);
        const DampingFit found = fit_damping(body, states_);
        return {{"alpha_per_s", found.error.alpha_per_s},
                {"beta_s", found.error.beta_s},
                {"r_squared", found.r_squared},
                {"steps", found.steps},
                {"used", found.used}};
    }

  private:
    std::vector<BodyState> states_;
};

Play play(Session& session, const std::vector<std::vector<Command>>& commands, bool fit, Job& job) {
    Play result;
    MotionRecorder motion;
    DeformPart* deform = session.world().deform();
    std::string setting;
    for (const std::vector<Command>& now : commands) {
        for (const Command& command : now) session.post(command);
        const SessionStep step = session.step();
        if (step.paused) break;
        result.times.add(step);
        result.linear_iterations_max =
            std::max(result.linear_iterations_max, step.deform.linear_iterations);
        result.degraded_steps += step.deform.degraded ? 1 : 0;
        if (result.degraded_because.empty()) result.degraded_because = step.deform.message;
        const ToolLoad& tool = step.deform.tool;
        const SelfLoad& self = step.deform.self;
        result.contacts_max = std::max(result.contacts_max, tool.contacts + self.contacts);
        result.rows_max = std::max(result.rows_max, 3 * tool.contacts + self.contacts);
        result.penetration_max_mm =
            std::max({result.penetration_max_mm, -tool.least_gap_mm, -self.least_gap_mm});
        if (step.deform.momentum_exchanged_g_mm_per_s > 0.0)
            result.momentum_error_relative = std::max(
                result.momentum_error_relative,
                step.deform.momentum_error_g_mm_per_s / step.deform.momentum_exchanged_g_mm_per_s);
        result.tear = step.deform.tear;
        result.torn_nj += step.deform.energy.tear_loss;
        result.tool_force_max_un = std::max(result.tool_force_max_un, tool.force_un.norm());
        result.finite = result.finite && is_finite(session.world());
        session.update_frame();
        const Frame& shown = session.frame();
        result.hand_at_limit_steps += shown.grab && shown.grab->at_limit ? 1 : 0;
        result.tool_at_limit_steps += shown.tool && shown.tool->at_limit ? 1 : 0;
        const std::string& used = session.frame().statistics.setting;
        if (!setting.empty() && used != setting) ++result.setting_changes;
        setting = used;
        if (fit && deform != nullptr) motion.keep(*deform);
        job.advance(static_cast<double>(step.step) / static_cast<double>(commands.size()));
    }
    if (result.times.steps() == 0) return result;
    if (fit && deform != nullptr) result.velocity_error_fit = motion.fit(*deform);
    result.real_time_factor = 1e3 * session.world().spec().dt_s *
                              static_cast<double>(result.times.steps()) / result.times.wall_ms();
    return result;
}

void write_final_mesh(const World& world, const std::filesystem::path& file) {
    if (world.deform() == nullptr)
        throw InputError("has no deform, so its vessels keep their shape", "the scene",
                         "Leave out --final-mesh");
    write_vtu(file, world.deform()->shape());
}

std::string stopped_by(const TearSpec& spec, const TearReport& report) {
    if (!report.stopped) return "none";
    return spec.stop == TearStop::entropy ? "entropy" : "vertices";
}

SceneSpec scene_of(const Options& options, const Script& script) {
    SceneSpec spec = script.scene.value_or(default_scene());
    if (options.dt_s > 0.0) spec.dt_s = options.dt_s;
    if (options.quality >= 0.0 && spec.deform) spec.deform->quality = options.quality;
    if (options.as_published) use_as_published(spec);
    return spec;
}

Json run(const Options& options, Job& job) {
    const BackEndChoice back_end = choose_back_end(options.backend);
    if (!options.record.empty()) require_writable(options.record);
    if (!options.final_mesh.empty()) require_writable(options.final_mesh);
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(options.threads);
    const Script script = read_script(options.script);
    job.expect_stages(3);
    job.begin_stage("Reading the case");
    auto patient = std::make_shared<const PatientCase>(read_case_without_voxels(options.patient));
    const SceneSpec spec = scene_of(options, script);
    Session session(patient, spec, job, back_end.back_end);
    std::optional<RecordingWriter> recording;
    if (!options.record.empty()) {
        recording.emplace(options.record, session.recording_start());
        session.record([&](RecordedStep step) { recording->append(std::move(step)); });
    }
    job.begin_stage("Simulating");
    if (options.automatic) session.post(SetAutomaticQuality{true});
    auto commands = schedule(script, patient->tree, spec.dt_s, options.steps);
    if (options.as_published) use_as_published(commands);
    const Play played = play(session, commands, options.fit_velocity_error, job);
    if (recording) recording->close();
    FlowPart* flow = session.world().flow();
    const Bleeding* bleeding = session.world().bleeding();
    session.update_frame();
    const FrameStatistics& statistics = session.frame().statistics;
    const bool moves = session.world().deform() != nullptr;
    const bool tools = spec.contact && spec.contact->tools;
    const bool self = spec.contact && spec.contact->self;
    const bool touches = tools || self;
    if (!options.final_mesh.empty()) write_final_mesh(session.world(), options.final_mesh);
    const bool known = moves && statistics.expected_error > 0.0;
    return {
        {"script", script.name},
        {"steps", played.times.steps()},
        {"steps_asleep", played.times.asleep()},
        {"dt_s", spec.dt_s},
        {"tetrahedra", spec.deform ? patient->mesh.tetrahedra.size() : 0},
        {"step_ms",
         {{"median", played.times.quantile(0.5)},
          {"p95", played.times.quantile(0.95)},
          {"max", played.times.quantile(1.0)}}},
        {"frames_in_time", played.times.frames_in_time()},
        {"real_time_factor", played.real_time_factor},
        {"linear_iterations_max", played.linear_iterations_max},
        {"degraded_steps", played.degraded_steps},
        {"degraded_because", played.degraded_because},
        {"expected_error", known ? Json(statistics.expected_error) : Json(nullptr)},
        {"error_reference", known ? Json(statistics.error_reference) : Json(nullptr)},
        {"quality", moves ? Json(statistics.quality) : Json(nullptr)},
        {"setting", moves ? Json(statistics.setting) : Json(nullptr)},
        {"setting_changes", played.setting_changes},
        {"velocity_error_fit", played.velocity_error_fit},
        {"contacts_max", touches ? Json(played.contacts_max) : Json(nullptr)},
        {"rows_max", touches ? Json(played.rows_max) : Json(nullptr)},
        {"penetration_max_mm", touches ? Json(played.penetration_max_mm) : Json(nullptr)},
        {"tool_force_max_un", tools ? Json(played.tool_force_max_un) : Json(nullptr)},
        {"hand_at_limit_steps", moves ? Json(played.hand_at_limit_steps) : Json(nullptr)},
        {"tool_at_limit_steps", tools ? Json(played.tool_at_limit_steps) : Json(nullptr)},
        {"intersections_at_end",
         self ? Json(crossing_pairs(*session.world().deform())) : Json(nullptr)},
        {"momentum_error_relative",
         self || spec.tear ? Json(played.momentum_error_relative) : Json(nullptr)},
        {"joints_broken", spec.tear ? Json(played.tear.joints_broken) : Json(nullptr)},
        {"joints_parted", spec.tear ? Json(played.tear.joints_parted) : Json(nullptr)},
        {"vertices_split", spec.tear ? Json(played.tear.vertices_split) : Json(nullptr)},
        {"pieces", spec.tear ? Json(played.tear.pieces) : Json(nullptr)},
        {"entropy", spec.tear ? Json(played.tear.entropy_nats) : Json(nullptr)},
        {"entropy_produced", spec.tear ? Json(played.tear.entropy_produced_nats) : Json(nullptr)},
        {"stopped_by", spec.tear ? Json(stopped_by(*spec.tear, played.tear)) : Json(nullptr)},
        {"leak_g_s", bleeding != nullptr ? Json(bleeding->leak_g_s()) : Json(nullptr)},
        {"leaked_g", bleeding != nullptr ? Json(bleeding->leaked_g()) : Json(nullptr)},
        {"body_mass_error_relative",
         spec.tear ? Json(session.world().deform()->mass_error_relative()) : Json(nullptr)},
        {"tear_work_nj", spec.tear ? Json(played.torn_nj) : Json(nullptr)},
        {"mass_error_relative", flow != nullptr ? flow->mass_error_relative() : 0.0},
        {"back_end", session.recording_start().back_end},
        {"gpu", facts_of(back_end)},
        {"finite", played.finite},
        {"stopped_because", statistics.diverged ? Json(statistics.message) : Json(nullptr)},
        {"state_hash", to_hex(session.state_hash())}};
}

}  // namespace

void add_simulate(CommandLine& line) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = line.add_verb("simulate", "Play a script on a case and measure",
                                   [options](Job& job) { return run(*options, job); });
    verb.add_option("case", options->patient, "Case to play on")->required();
    verb.add_option("--script", options->script,
                    "Script, such as the program's own scripts/drag.json")
        ->required();
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
        ->check(CLI::IsMember({"cpu", "cuda", "cuda-emulated", "auto"}))
        ->capture_default_str();
    verb.add_option("--threads", options->threads, "At most so many threads")
        ->check(CLI::Range(1, 1024));
    verb.add_option("--record", options->record,
                    "Recording to write, NAME.hrec; it grows as the play goes");
    verb.add_option("--final-mesh", options->final_mesh, "Last shape to write, NAME.vtu");
    CLI::Option* as_published = verb.add_flag(
        "--as-published", options->as_published,
        "As the paper has it: springs, eq. (12) taken whole, the published pressure law");
    for (const char* other : {"--quality", "--automatic"})
        as_published->excludes(verb.get_option(other));
}

}  // namespace hepatica
