// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measured_play.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include "core/base/hash.h"
#include "core/deform/step/damping_regression.h"
#include "core/scene/bleeding.h"
#include "core/scene/crossings.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/world.h"

namespace hepatica {
namespace {

bool is_finite(const World& world) {
    for (std::size_t v = 0; v < world.vertex_count(); ++v)
        if (!world.vertex_mm(static_cast<int>(v)).allFinite()) return false;
    return true;
}

// Collects the states of the first steps for the regression of eq. (11).
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

// Adds one step to the sums and extremes of a play.
void add_step(const SessionStep& step, MeasuredPlay& result) {
    result.times.add(step);
    result.linear_iterations_max =
        std::max(result.linear_iterations_max, step.deform.linear_iterations);
    result.degraded_steps += step.deform.degraded ? 1 : 0;
    if (result.degraded_because.empty()) result.degraded_because = step.deform.message;
    const ToolLoad& tool = step.deform.tool;
    const SelfLoad& self = step.deform.self;
    const SelfLoad& obstacles = step.deform.obstacles.touch;
    result.contacts_max =
        std::max(result.contacts_max, tool.contacts + self.contacts + obstacles.contacts);
    result.obstacle_contacts_max = std::max(result.obstacle_contacts_max, obstacles.contacts);
    result.rows_max =
        std::max(result.rows_max, 3 * (tool.contacts + obstacles.contacts) + self.contacts);
    result.penetration_max_mm = std::max({result.penetration_max_mm, -tool.least_gap_mm,
                                          -self.least_gap_mm, -obstacles.least_gap_mm});
    if (step.deform.momentum_exchanged_g_mm_per_s > 0.0)
        result.momentum_error_relative = std::max(
            result.momentum_error_relative.value_or(0.0),
            step.deform.momentum_error_g_mm_per_s / step.deform.momentum_exchanged_g_mm_per_s);
    result.tear = step.deform.tear;
    result.torn_nj += step.deform.energy.tear_loss;
    result.tool_force_max_un = std::max(result.tool_force_max_un, tool.force_un.norm());
}

bool resumes(const Command& command) {
    const auto* pause = std::get_if<SetPaused>(&command);
    return (pause != nullptr && !pause->paused) || std::holds_alternative<ResetWorld>(command) ||
           std::holds_alternative<RestoreSnapshot>(command);
}

// The last step whose commands may end a pause; 0 where there is none.
std::size_t last_resume(const std::vector<std::vector<Command>>& commands) {
    for (std::size_t step = commands.size(); step > 0; --step)
        if (std::ranges::any_of(commands[step - 1], resumes)) return step - 1;
    return 0;
}

std::string stopped_by(const TearSpec& spec, const TearReport& report) {
    if (!report.stopped) return "none";
    return spec.stop == TearStop::entropy ? "entropy" : "vertices";
}

// Null where the play went on to its end.
Json why_stopped(const FrameStatistics& statistics, const MeasuredPlay& played) {
    if (statistics.diverged) return statistics.message;
    if (!played.paused_at) return nullptr;
    return "the script paused it at step " + std::to_string(*played.paused_at);
}

Json value_if(bool known, const Json& value) {
    return known ? value : Json(nullptr);
}

Json pace_of(const MeasuredPlay& played) {
    return {{"step_ms",
             {{"median", played.times.quantile(0.5)},
              {"p95", played.times.quantile(0.95)},
              {"max", played.times.quantile(1.0)}}},
            {"frames_in_time", played.times.frames_in_time()},
            {"real_time_factor", played.real_time_factor},
            {"linear_iterations_max", played.linear_iterations_max},
            {"degraded_steps", played.degraded_steps},
            {"degraded_because", played.degraded_because}};
}

Json dial_of(bool moves, const FrameStatistics& statistics, const MeasuredPlay& played) {
    const bool known = moves && statistics.expected_error > 0.0;
    return {{"expected_error", value_if(known, statistics.expected_error)},
            {"error_reference", value_if(known, statistics.error_reference)},
            {"quality", value_if(moves, statistics.quality)},
            {"setting", value_if(moves, statistics.setting)},
            {"setting_changes", played.setting_changes},
            {"velocity_error_fit", played.velocity_error_fit}};
}

Json touch_of(World& world, const MeasuredPlay& played) {
    const std::optional<ContactSpec>& contact = world.spec().contact;
    const bool tools = contact && contact->tools;
    const bool self = contact && contact->self;
    const Json obstacles = obstacles_of(world);
    const bool beside = obstacles.is_number() && obstacles > 0;
    const bool touches = tools || self || beside;
    return {
        {"contacts_max", value_if(touches, played.contacts_max)},
        {"obstacles", obstacles},
        {"obstacle_contacts_max", value_if(beside, played.obstacle_contacts_max)},
        {"rows_max", value_if(touches, played.rows_max)},
        {"penetration_max_mm", value_if(touches, played.penetration_max_mm)},
        {"tool_force_max_un", value_if(tools, played.tool_force_max_un)},
        {"hand_at_limit_steps", value_if(world.deform() != nullptr, played.hand_at_limit_steps)},
        {"tool_at_limit_steps", value_if(tools, played.tool_at_limit_steps)},
        {"intersections_at_end",
         self || beside ? Json(crossing_pairs(*world.deform())) : Json(nullptr)},
        {"momentum_error_relative", value_if(played.momentum_error_relative.has_value(),
                                             played.momentum_error_relative.value_or(0.0))}};
}

Json tear_of(World& world, const MeasuredPlay& played) {
    const std::optional<TearSpec>& spec = world.spec().tear;
    const bool tears = spec.has_value();
    const Bleeding* bleeding = world.bleeding();
    const auto open_share = [bleeding](bool before_a_tear) {
        return bleeding != nullptr ? Json(bleeding->most_pressed(before_a_tear).open_share)
                                   : Json(nullptr);
    };
    return {
        {"joints_broken", value_if(tears, played.tear.joints_broken)},
        {"joints_parted", value_if(tears, played.tear.joints_parted)},
        {"vertices_split", value_if(tears, played.tear.vertices_split)},
        {"pieces", value_if(tears, played.tear.pieces)},
        {"entropy", value_if(tears, played.tear.entropy_nats)},
        {"entropy_produced", value_if(tears, played.tear.entropy_produced_nats)},
        {"stopped_by", tears ? Json(stopped_by(*spec, played.tear)) : Json(nullptr)},
        {"leak_g_s", bleeding != nullptr ? Json(bleeding->leak_g_s()) : Json(nullptr)},
        {"leaked_g", bleeding != nullptr ? Json(bleeding->leaked_g()) : Json(nullptr)},
        {"leaked_drug_g", bleeding != nullptr ? Json(bleeding->leaked_drug_g()) : Json(nullptr)},
        {"open_share", open_share(true)},
        {"other_open_share", open_share(false)},
        {"body_mass_error_relative",
         tears ? Json(world.deform()->mass_error_relative()) : Json(nullptr)},
        {"tear_work_nj", value_if(tears, played.torn_nj)}};
}

}  // namespace

Json obstacles_of(const World& world) {
    const std::optional<ContactSpec>& contact = world.spec().contact;
    if (!contact || contact->obstacles == WantedObstacles::none) return nullptr;
    const auto& obstacles = world.deform()->body().obstacles;
    return obstacles ? obstacles->all.size() : 0;
}

void say_where_obstacles_are_none(const World& world) {
    if (obstacles_of(world) == 0)
        spdlog::warn("the case knows neither a liver nor a tumour: the scene has no obstacles");
}

MeasuredPlay measure_play(Session& session, const std::vector<std::vector<Command>>& commands,
                          const PlayWishes& wishes, Job& job) {
    MeasuredPlay result;
    if (wishes.table) result.table.emplace();
    MotionRecorder motion;
    DeformPart* deform = session.world().deform();
    std::string setting;
    const std::size_t resumed_at = last_resume(commands);
    for (std::size_t i = 0; i < commands.size(); ++i) {
        session.finish_injection();
        const std::vector<std::string> idle = moves_of_nothing(session.world(), commands[i]);
        for (const Command& command : commands[i]) session.post(command);
        const FrameTimer timer;
        const SessionStep step = session.step(job);
        const FrameTime took = timer.passed();
        for (const auto* refused : {&step.refused, &idle})
            for (const std::string& message : *refused) result.refusals.add(step.step, message);
        if (step.paused) {
            job.throw_if_cancelled();
            job.advance(static_cast<double>(i + 1) / static_cast<double>(commands.size()));
            session.update_frame();
            if (i < resumed_at && !session.frame().statistics.diverged) continue;
            result.paused_at = step.step;
            break;
        }
        if (result.table) result.table->add(step, took);
        add_step(step, result);
        result.finite = result.finite && is_finite(session.world());
        session.update_frame();
        const Frame& shown = session.frame();
        result.hand_at_limit_steps += shown.grab && shown.grab->at_limit ? 1 : 0;
        result.tool_at_limit_steps += shown.tool && shown.tool->at_limit ? 1 : 0;
        const std::string& used = session.frame().statistics.setting;
        if (!setting.empty() && used != setting) ++result.setting_changes;
        setting = used;
        if (wishes.fit && deform != nullptr) motion.keep(*deform);
        job.advance(static_cast<double>(step.step) / static_cast<double>(commands.size()));
    }
    if (result.times.steps() == 0) return result;
    if (wishes.fit && deform != nullptr) result.velocity_error_fit = motion.fit(*deform);
    result.real_time_factor = 1e3 * session.world().spec().dt_s *
                              static_cast<double>(result.times.steps()) / result.times.wall_ms();
    return result;
}

Json answer_of(Session& session, const MeasuredPlay& played) {
    session.update_frame();
    World& world = session.world();
    const SceneSpec& spec = world.spec();
    const FlowPart* flow = world.flow();
    const FrameStatistics& statistics = session.frame().statistics;
    Json answer{{"steps", played.times.steps()},
                {"steps_asleep", played.times.asleep()},
                {"dt_s", spec.dt_s}};
    answer.update(pace_of(played));
    answer.update(dial_of(world.deform() != nullptr, statistics, played));
    answer.update(touch_of(world, played));
    answer.update(tear_of(world, played));
    answer["mass_error_relative"] = flow != nullptr ? flow->mass_error_relative() : 0.0;
    answer["finite"] = played.finite;
    answer["stopped_because"] = why_stopped(statistics, played);
    answer["refused"] = played.refusals.json();
    answer["state_hash"] = to_hex(session.state_hash());
    return answer;
}

}  // namespace hepatica
