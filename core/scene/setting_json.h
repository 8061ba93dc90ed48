// SPDX-License-Identifier: GPL-3.0-or-later
// One setting of the dial in a file or a recording: {"element": "corotated", "solver": "automatic",
// "energy_tolerance": 0.01, "max_iterations": 10000, "newton_iterations": 1, "substeps": 1}, and
// "published": true where the step is taken exactly as published, "on_processor": true where a
// play on a device has its steps made by the processor.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

nlohmann::ordered_json to_json(const StepperOptions& options);

// What is not named keeps its default. Throws InputError for an unknown key, name or value.
StepperOptions setting_from_json(const nlohmann::ordered_json& json);

// "corotated, 4 substeps", for the window; what is as usual is not named.
std::string words_of(const StepperOptions& options);

// Whether two settings are the same in all that to_json writes.
bool same_setting(const StepperOptions& a, const StepperOptions& b);

}  // namespace hepatica
