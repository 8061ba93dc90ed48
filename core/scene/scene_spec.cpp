// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene_spec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/number_text.h"
#include "core/base/text_file.h"
#include "core/base/unknown_key.h"
#include "core/base/written_json.h"
#include "core/scene/setting_json.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

// Reads the known keys of a JSON object and refuses others, so that a misspelt key is not silently
// ignored.
class Fields {
  public:
    Fields(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
        if (!json.is_object()) refuse("is not an object", where_);
    }

    template <class T>
    void read(const char* key, T& value) {
        known_.push_back(key);
        const auto found = json_.find(key);
        if (found == json_.end()) return;
        try {
            if constexpr (std::is_same_v<T, int>)
                value = whole_number<int>(*found);
            else
                value = found->template get<T>();
        } catch (const Json::exception&) {
            refuse("has a value of the wrong kind (" + found->dump() + ")", key);
        }
    }
    void read_number(const char* key, double& value, const NumberRange& range) {
        read(key, value);
        require_in(range, value, key);
    }
    void read_vector(const char* key, Vec3& value, const NumberRange& range) {
        std::array<double, 3> numbers{value.x(), value.y(), value.z()};
        read(key, numbers);
        for (const double number : numbers) require_in(range, number, key);
        value = Vec3(numbers[0], numbers[1], numbers[2]);
    }
    void refuse_unknown() const {
        for (const auto& [key, value] : json_.items())
            if (std::ranges::find(known_, key) == known_.end())
                refuse(unknown_key(key, known_), key);
    }
    [[noreturn]] void refuse(const std::string& problem, const std::string& key) const {
        throw InputError(problem, where_ + ": " + key, "docs/scenes.md lists the keys of a scene");
    }

  private:
    void require_in(const NumberRange& range, double value, const char* key) const {
        if (!range.holds(value)) refuse(outside(value, range), key);
    }

    const Json& json_;
    std::string where_;
    std::vector<std::string> known_;
};

constexpr std::array<std::pair<const char*, FixedEnds>, 3> names_of_ends{
    {{"none", FixedEnds::none}, {"roots", FixedEnds::roots}, {"all", FixedEnds::all}}};

const char* name_of(FixedEnds ends) {
    return std::ranges::find(names_of_ends, ends, [](const auto& entry) { return entry.second; })
        ->first;
}

DeformSpec deform_from(const Json& json) {
    DeformSpec spec;
    Fields fields(json, "deform");
    fields.read("material", spec.material);
    std::string fixed = name_of(spec.fixed);
    fields.read("fixed", fixed);
    const auto ends = std::ranges::find(names_of_ends, fixed,
                                        [](const auto& entry) { return std::string(entry.first); });
    if (ends == names_of_ends.end())
        fields.refuse("is \"" + fixed + "\"; it must be none, roots or all", "fixed");
    spec.fixed = ends->second;
    fields.read_vector("gravity_mm_per_s2", spec.gravity_mm_per_s2, gravity_range_mm_per_s2);
    fields.read_number("tether_pa_per_mm2", spec.tether_pa_per_mm2, tether_range_pa_per_mm2);
    fields.read("wall_mm", spec.wall_mm);
    validate_wall(spec.wall_mm);
    fields.read_number("quality", spec.quality, {0.0, 1.0});
    Json setting;
    fields.read("setting", setting);
    if (!setting.is_null()) spec.setting = setting_from_json(setting);
    std::array<double, 2> error{spec.velocity_error.alpha_per_s, spec.velocity_error.beta_s};
    fields.read("velocity_error", error);
    if (!std::isfinite(error[0]) || !std::isfinite(error[1]))
        fields.refuse("is not finite", "velocity_error");
    spec.velocity_error = {error[0], error[1]};
    fields.refuse_unknown();
    return spec;
}

FlowSpec flow_from(const Json& json) {
    FlowSpec spec;
    Fields fields(json, "flow");
    fields.read_number("drug_speed", spec.drug_speed, drug_speed_range);
    fields.refuse_unknown();
    return spec;
}

// Everything that the case knows, or only what is named. A friction alone does not count as naming.
ContactSpec contact_from(const Json& json) {
    const bool all = json.is_object() && json.size() == json.count("friction");
    ContactSpec spec{.tools = all,
                     .self = all,
                     .obstacles = all ? WantedObstacles::known : WantedObstacles::none};
    Fields fields(json, "contact");
    fields.read("tools", spec.tools);
    fields.read("self", spec.self);
    Json obstacles = false;
    fields.read("obstacles", obstacles);
    if (obstacles == "known")
        spec.obstacles = WantedObstacles::known;
    else if (!obstacles.is_boolean())
        fields.refuse("has a value of the wrong kind (" + obstacles.dump() + ")", "obstacles");
    else if (obstacles.get<bool>())
        spec.obstacles = WantedObstacles::required;
    fields.read_number("friction", spec.friction, {0.0, greatest_friction});
    if (spec.friction > 0.0 && !spec.self)
        fields.refuse("needs self: only vessels that touch each other rub", "friction");
    fields.refuse_unknown();
    return spec;
}

constexpr std::array<std::pair<const char*, TearStop>, 3> names_of_stops{
    {{"none", TearStop::none}, {"entropy", TearStop::entropy}, {"vertices", TearStop::vertices}}};

Json to_json(const ContactSpec& spec) {
    Json json = Json::object();
    if (!spec.all()) {
        json = {{"tools", spec.tools}, {"self", spec.self}};
        if (spec.obstacles == WantedObstacles::required) json["obstacles"] = true;
        if (spec.obstacles == WantedObstacles::known) json["obstacles"] = "known";
    }
    if (spec.friction > 0.0) json["friction"] = spec.friction;
    return json;
}

const char* name_of(TearStop stop) {
    return std::ranges::find(names_of_stops, stop, [](const auto& entry) { return entry.second; })
        ->first;
}

}  // namespace

TearSpec tear_from_json(const Json& json) {
    TearSpec spec;
    Fields fields(json, "tear");
    fields.read_number("tear_factor", spec.tear_factor, {least_tear_factor, greatest_tear_factor});
    std::string stop = name_of(spec.stop);
    fields.read("stop", stop);
    const auto found = std::ranges::find(
        names_of_stops, stop, [](const auto& entry) { return std::string(entry.first); });
    if (found == names_of_stops.end())
        fields.refuse("is \"" + stop + "\"; it must be entropy, vertices or none", "stop");
    spec.stop = found->second;
    fields.read_number("entropy_budget", spec.entropy_budget, {0.0, 1e6});
    fields.read("vertex_budget", spec.vertex_budget);
    if (spec.vertex_budget < 0) fields.refuse("is less than 0", "vertex_budget");
    fields.read("bare_limit", spec.bare_limit);
    fields.refuse_unknown();
    return spec;
}

Json to_json(const TearSpec& spec) {
    Json json{{"tear_factor", spec.tear_factor},
              {"stop", name_of(spec.stop)},
              {"entropy_budget", spec.entropy_budget},
              {"vertex_budget", spec.vertex_budget}};
    if (spec.bare_limit) json["bare_limit"] = true;
    return json;
}

void validate_wall(double wall_mm) {
    if (wall_mm == 0.0 || (wall_mm >= thinnest_wall_mm && wall_mm <= thickest_wall_mm)) return;
    throw InputError("is " + number_text(wall_mm), "wall_mm",
                     "Give a wall from 0.01 to 100 mm, or 0 for solid vessels");
}

void validate_friction(double friction) {
    if (friction >= 0.0 && friction <= greatest_friction) return;
    throw InputError("is " + number_text(friction), "friction", "Give a coefficient from 0 to 10");
}

void validate_tear_factor(double factor) {
    if (factor >= least_tear_factor && factor <= greatest_tear_factor) return;
    throw InputError("is " + number_text(factor), "tear factor", "Give a value from 1e-6 to 1e9");
}

SceneSpec default_scene() {
    SceneSpec spec;
    spec.name = "default";
    return spec;
}

Json to_json(const SceneSpec& spec) {
    Json json{{"name", spec.name}, {"dt_s", spec.dt_s}};
    if (spec.deform) {
        const Vec3& gravity = spec.deform->gravity_mm_per_s2;
        json["deform"] = {{"material", spec.deform->material},
                          {"fixed", name_of(spec.deform->fixed)},
                          {"gravity_mm_per_s2", {gravity.x(), gravity.y(), gravity.z()}},
                          {"tether_pa_per_mm2", spec.deform->tether_pa_per_mm2},
                          {"quality", spec.deform->quality}};
        const RayleighDamping& error = spec.deform->velocity_error;
        if (spec.deform->setting) json["deform"]["setting"] = to_json(*spec.deform->setting);
        if (spec.deform->wall_mm > 0.0) json["deform"]["wall_mm"] = spec.deform->wall_mm;
        if (error.alpha_per_s != 0.0 || error.beta_s != 0.0)
            json["deform"]["velocity_error"] = {error.alpha_per_s, error.beta_s};
    }
    if (spec.contact) json["contact"] = to_json(*spec.contact);
    if (spec.tear) json["tear"] = to_json(*spec.tear);
    if (spec.flow) json["flow"] = {{"drug_speed", spec.flow->drug_speed}};
    return json;
}

SceneSpec scene_from_json(const Json& json) {
    SceneSpec spec;
    Fields fields(json, "scene");
    fields.read("name", spec.name);
    fields.read_number("dt_s", spec.dt_s, {1e-4, 1.0});
    Json deform, flow, contact, tear;
    fields.read("deform", deform);
    fields.read("contact", contact);
    fields.read("tear", tear);
    fields.read("flow", flow);
    fields.refuse_unknown();
    spec.deform.reset();
    spec.flow.reset();
    if (!deform.is_null()) spec.deform = deform_from(deform);
    if (!flow.is_null()) spec.flow = flow_from(flow);
    if (!contact.is_null()) spec.contact = contact_from(contact);
    if (spec.contact && !spec.deform)
        fields.refuse("needs deform: only what moves is touched", "contact");
    if (!tear.is_null()) spec.tear = tear_from_json(tear);
    if (spec.tear && !spec.deform) fields.refuse("needs deform: only what moves can tear", "tear");
    if (!spec.deform && !spec.flow)
        fields.refuse("names no part; name deform, flow or both", "deform, flow");
    return spec;
}

namespace {

constexpr const char* scene_remedy = R"(Give a scene file: {"case": "NAME.hep", "deform": {}})";

Json json_in(const std::filesystem::path& file) {
    const std::string text = read_text_file(file, "Give a scene file (JSON) or a case");
    try {
        return parse_written<Json>(text);
    } catch (const InputError& error) {
        throw InputError(error.place() + " " + error.problem(), file.string(), error.remedy());
    } catch (const Json::exception& error) {
        throw InputError(json_problem(error), file.string(), scene_remedy);
    }
}

}  // namespace

SceneFile read_scene(const std::filesystem::path& file) {
    Json json = json_in(file);
    if (!json.is_object()) throw InputError("is not a JSON object", file.string(), scene_remedy);
    SceneFile scene;
    const auto found = json.find("case");
    if (found == json.end() || !found->is_string())
        throw InputError("names no case", file.string(), R"(Add "case": "PATH.hep")");
    scene.patient = file.parent_path() / std::filesystem::path(found->get<std::string>());
    json.erase("case");
    try {
        scene.spec = scene_from_json(json);
    } catch (const InputError& error) {
        throw InputError(error.place() + " " + error.problem(), file.string(), error.remedy());
    }
    return scene;
}

}  // namespace hepatica
