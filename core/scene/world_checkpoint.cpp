// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/world_checkpoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/base/base64.h"
#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/scene/setting_json.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

[[noreturn]] void refuse(const std::string& problem) {
    throw InputError(problem, "keyframe", "The recording is damaged");
}

Json to_json(const Vec3& vector) {
    return {vector.x(), vector.y(), vector.z()};
}

Vec3 vector_from(const Json& json) {
    const auto numbers = json.get<std::array<double, 3>>();
    return {numbers[0], numbers[1], numbers[2]};
}

Json to_json(const Hold& hold) {
    Json offsets = Json::array();
    for (const Vec3& offset : hold.offsets_mm) offsets.push_back(to_json(offset));
    return {{"vertices", hold.vertices},
            {"offsets_mm", std::move(offsets)},
            {"target_mm", to_json(hold.target_mm)},
            {"stiffness_un_per_mm", hold.stiffness_un_per_mm},
            {"force_limit_un", hold.force_limit_un}};
}

Hold hold_from(const Json& json) {
    Hold hold;
    hold.vertices = whole_numbers<int>(json.at("vertices"));
    for (const Json& offset : json.at("offsets_mm")) hold.offsets_mm.push_back(vector_from(offset));
    hold.target_mm = vector_from(json.at("target_mm"));
    hold.stiffness_un_per_mm = json.at("stiffness_un_per_mm").get<double>();
    hold.force_limit_un = json.at("force_limit_un").get<double>();
    return hold;
}

Json to_json(const DeformCheckpoint& checkpoint) {
    const DeformSettings& settings = checkpoint.settings;
    Json json{{"gravity_mm_per_s2", to_json(settings.gravity_mm_per_s2)},
              {"tether_pa_per_mm2", settings.tether_pa_per_mm2},
              {"wall_mm", settings.wall_mm},
              {"setting", to_json(settings.stepper)},
              {"touchable", settings.touchable}};
    if (settings.tear) json["tear"] = to_json(*settings.tear);
    if (settings.self_friction) json["self_friction"] = *settings.self_friction;
    if (settings.obstacles) json["obstacles"] = true;
    if (checkpoint.hold) json["hold"] = to_json(*checkpoint.hold);
    json["stepper"] = to_base64(to_bytes(checkpoint.stepper));
    return json;
}

DeformCheckpoint deform_from(const Json& json) {
    DeformCheckpoint checkpoint;
    DeformSettings& settings = checkpoint.settings;
    settings.gravity_mm_per_s2 = vector_from(json.at("gravity_mm_per_s2"));
    settings.tether_pa_per_mm2 = json.at("tether_pa_per_mm2").get<double>();
    settings.wall_mm = json.at("wall_mm").get<double>();
    settings.stepper = setting_from_json(json.at("setting"));
    settings.touchable = json.at("touchable").get<bool>();
    if (json.contains("tear")) settings.tear = tear_from_json(json.at("tear"));
    if (json.contains("self_friction"))
        settings.self_friction = json.at("self_friction").get<double>();
    settings.obstacles = json.value("obstacles", false);
    if (json.contains("hold")) checkpoint.hold = hold_from(json.at("hold"));
    const auto bytes = from_base64(json.at("stepper").get_ref<const std::string&>());
    if (!bytes) refuse("the stepper's bytes are not base64");
    checkpoint.stepper = checkpoint_from_bytes(*bytes);
    return checkpoint;
}

Json to_json(const ThroughTear& tear) {
    Json json{{"segment", tear.at.segment},
              {"arclength_mm", tear.at.arclength_mm},
              {"area_mm2", tear.area_mm2}};
    if (tear.side) json["side"] = true;
    return json;
}

ThroughTear tear_at_from(const Json& json) {
    return {{whole_number<int>(json.at("segment")), json.at("arclength_mm").get<double>(), 0.0},
            json.at("area_mm2").get<double>(),
            json.value("side", false)};
}

Json to_json(const BloodPool& pool) {
    Json json = to_json(pool.of);
    json["lost_g"] = pool.lost_g;
    if (pool.drug_g != 0.0) json["drug_g"] = pool.drug_g;
    return json;
}

BloodPool pool_from(const Json& json) {
    BloodPool pool{tear_at_from(json), json.at("lost_g").get<double>(), json.value("drug_g", 0.0)};
    if (!(pool.lost_g >= 0.0 && pool.drug_g >= 0.0)) refuse("less than nothing bled");
    return pool;
}

Json to_json(const Injection& injection) {
    Json json{{"segment", injection.at.segment},
              {"arclength_mm", injection.at.arclength_mm},
              {"mass_flow_g_s", injection.mass_flow_g_s},
              {"void_fraction", injection.void_fraction},
              {"second_phase", injection.second_phase},
              {"pressure_model", injection.pressure_model},
              {"drug_viscosity_pa_s", injection.drug_viscosity_pa_s}};
    for (const ThroughTear& tear : injection.tears) json["tears"].push_back(to_json(tear));
    if (injection.least_end_s != 0.0) json["least_end_s"] = injection.least_end_s;
    for (const TornSince& later : injection.later) {
        Json tears = Json::array();
        for (const ThroughTear& tear : later.tears) tears.push_back(to_json(tear));
        json["later"].push_back({{"from_s", later.from_s}, {"tears", std::move(tears)}});
    }
    return json;
}

Injection injection_from(const Json& json) {
    Injection injection;
    injection.at.segment = whole_number<int>(json.at("segment"));
    injection.at.arclength_mm = json.at("arclength_mm").get<double>();
    injection.mass_flow_g_s = json.at("mass_flow_g_s").get<double>();
    injection.void_fraction = json.at("void_fraction").get<double>();
    injection.second_phase = json.at("second_phase").get<std::string>();
    injection.pressure_model = json.at("pressure_model").get<std::string>();
    injection.drug_viscosity_pa_s = json.at("drug_viscosity_pa_s").get<double>();
    injection.least_end_s = json.value("least_end_s", 0.0);
    if (json.contains("tears"))
        for (const Json& tear : json.at("tears")) injection.tears.push_back(tear_at_from(tear));
    if (json.contains("later"))
        for (const Json& later : json.at("later")) {
            TornSince since{.from_s = later.at("from_s").get<double>()};
            for (const Json& tear : later.at("tears")) since.tears.push_back(tear_at_from(tear));
            injection.later.push_back(std::move(since));
        }
    return injection;
}

Json to_json(const FlowCheckpoint& checkpoint) {
    Json json{{"time_s", checkpoint.time_s},
              {"playing", checkpoint.playing},
              {"speed", checkpoint.speed}};
    if (checkpoint.injected) json["injected"] = to_json(*checkpoint.injected);
    if (checkpoint.computing) json["computing"] = to_json(*checkpoint.computing);
    if (checkpoint.updating) json["updating"] = true;
    if (checkpoint.steps_left > 0) json["steps_left"] = checkpoint.steps_left;
    if (checkpoint.reached_before) {
        std::string reached;
        for (const std::uint8_t yes : *checkpoint.reached_before) reached += yes != 0 ? '1' : '0';
        json["reached_before"] = std::move(reached);
    }
    return json;
}

std::shared_ptr<const std::vector<std::uint8_t>> reached_from(const std::string& text) {
    if (text.find_first_not_of("01") != std::string::npos)
        refuse("what was reached before is not told by 0 and 1");
    auto reached = std::make_shared<std::vector<std::uint8_t>>();
    for (const char digit : text) reached->push_back(digit == '1');
    return reached;
}

FlowCheckpoint flow_from(const Json& json) {
    FlowCheckpoint checkpoint;
    checkpoint.time_s = json.at("time_s").get<double>();
    checkpoint.playing = json.at("playing").get<bool>();
    checkpoint.speed = json.at("speed").get<double>();
    if (json.contains("injected")) checkpoint.injected = injection_from(json.at("injected"));
    if (json.contains("computing")) checkpoint.computing = injection_from(json.at("computing"));
    checkpoint.updating = json.value("updating", false);
    if (json.contains("steps_left"))
        checkpoint.steps_left = std::max(whole_number<int>(json.at("steps_left")), 0);
    if (json.contains("reached_before"))
        checkpoint.reached_before =
            reached_from(json.at("reached_before").get_ref<const std::string&>());
    return checkpoint;
}

}  // namespace

Json to_json(const WorldCheckpoint& checkpoint) {
    Json json{{"time_s", checkpoint.time_s}};
    if (checkpoint.leaked_g != 0.0) json["leaked_g"] = checkpoint.leaked_g;
    if (checkpoint.leaked_drug_g != 0.0) json["leaked_drug_g"] = checkpoint.leaked_drug_g;
    if (checkpoint.deform) json["deform"] = to_json(*checkpoint.deform);
    if (checkpoint.flow) json["flow"] = to_json(*checkpoint.flow);
    for (const BloodPool& pool : checkpoint.pools) json["pools"].push_back(to_json(pool));
    return json;
}

WorldCheckpoint world_checkpoint_from_json(const Json& json) {
    try {
        WorldCheckpoint checkpoint;
        checkpoint.time_s = json.at("time_s").get<double>();
        if (json.contains("leaked_g")) checkpoint.leaked_g = json.at("leaked_g").get<double>();
        if (json.contains("leaked_drug_g"))
            checkpoint.leaked_drug_g = json.at("leaked_drug_g").get<double>();
        if (json.contains("deform")) checkpoint.deform = deform_from(json.at("deform"));
        if (json.contains("flow")) checkpoint.flow = flow_from(json.at("flow"));
        if (json.contains("pools"))
            for (const Json& pool : json.at("pools")) checkpoint.pools.push_back(pool_from(pool));
        return checkpoint;
    } catch (const Json::exception& error) {
        refuse(json_problem(error));
    }
}

}  // namespace hepatica
