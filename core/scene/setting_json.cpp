// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/setting_json.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/deform/body/element_name.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

[[noreturn]] void refuse(const std::string& key, const std::string& problem) {
    throw InputError(problem, "setting: " + key, "Correct the scene or recording");
}

// Larger counts would keep a step busy for longer than anybody waits.
constexpr int most_linear_iterations = 20000;
constexpr int most_newton_iterations = 100;
constexpr int most_substeps = 64;

void require_count(const std::string& key, int value, int most) {
    if (value < 1 || value > most)
        refuse(key,
               "is " + std::to_string(value) + "; it must lie from 1 to " + std::to_string(most));
}

void read_into(StepperOptions& options, const std::string& key, const Json& value) {
    if (key == "element") {
        const auto [model, order] = element_of(value.get<std::string>());
        options.model = model;
        options.order = order;
    } else if (key == "solver") {
        options.solver = linear_solver_kind(value.get<std::string>());
    } else if (key == "energy_tolerance") {
        options.linear.energy_tolerance = value.get<double>();
    } else if (key == "max_iterations") {
        options.linear.max_iterations = whole_number<int>(value);
    } else if (key == "newton_iterations") {
        options.newton_iterations = whole_number<int>(value);
    } else if (key == "substeps") {
        options.substeps = whole_number<int>(value);
    } else if (key == "swing_substeps") {
        options.swing_substeps = whole_number<int>(value);
    } else if (key == "tension") {
        options.tension = value.get<bool>();
    } else if (key == "on_processor") {
        options.on_processor = value.get<bool>();
    } else if (key == "published") {
        options.published = value.get<bool>();
    } else {
        refuse(key, "is not known");
    }
}

}  // namespace

Json to_json(const StepperOptions& options) {
    Json json{{"element", element_name(options.model, options.order)},
              {"solver", std::string(name_of(options.solver))},
              {"energy_tolerance", options.linear.energy_tolerance},
              {"max_iterations", options.linear.max_iterations},
              {"newton_iterations", options.newton_iterations},
              {"substeps", options.substeps}};
    if (options.swing_substeps != StepperOptions{}.swing_substeps)
        json["swing_substeps"] = options.swing_substeps;
    if (!options.tension) json["tension"] = false;
    if (options.on_processor) json["on_processor"] = true;
    if (options.published) json["published"] = true;
    return json;
}

StepperOptions setting_from_json(const Json& json) {
    if (!json.is_object()) refuse("setting", "is not an object");
    StepperOptions options;
    for (const auto& [key, value] : json.items()) {
        try {
            read_into(options, key, value);
        } catch (const Json::exception&) {
            refuse(key, "has a value of the wrong kind (" + value.dump() + ")");
        } catch (const UsageError& error) {
            refuse(key, error.problem());
        }
    }
    if (!(options.linear.energy_tolerance >= 0.0)) refuse("energy_tolerance", "is below 0");
    require_count("max_iterations", options.linear.max_iterations, most_linear_iterations);
    require_count("newton_iterations", options.newton_iterations, most_newton_iterations);
    require_count("substeps", options.substeps, most_substeps);
    require_count("swing_substeps", options.swing_substeps, most_substeps);
    return options;
}

std::string words_of(const StepperOptions& options) {
    std::ostringstream words;
    words << element_name(options.model, options.order);
    if (options.solver == LinearSolverKind::block_jacobi && options.linear.energy_tolerance == 0.0)
        words << ", " << options.linear.max_iterations << " iterations";
    else if (options.solver != LinearSolverKind::automatic)
        words << ", " << name_of(options.solver);
    if (options.substeps > 1) words << ", " << options.substeps << " substeps";
    if (options.newton_iterations > 1)
        words << ", " << options.newton_iterations << " Newton iterates";
    if (options.on_processor) words << ", on the processor";
    return words.str();
}

bool same_setting(const StepperOptions& a, const StepperOptions& b) {
    return to_json(a) == to_json(b);
}

}  // namespace hepatica
