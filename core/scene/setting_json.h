// SPDX-License-Identifier: GPL-3.0-or-later
// One setting of the dial in a file or a recording: {"element": "corotated", "solver": "automatic",
// "energy_tolerance": 0.01, "max_iterations": 10000, "newton_iterations": 1, "substeps": 1};
// "published": true for the published step; "on_processor": true for steps on the processor where a
// device plays the rest; "tension": false without tension; "swing_substeps": 1 without more
// substeps after a release.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

nlohmann::ordered_json to_json(const StepperOptions& options);

// Missing keys keep their defaults. Throws InputError for an unknown key, name or value.
StepperOptions setting_from_json(const nlohmann::ordered_json& json);

// "corotated, 4 substeps", for the window; defaults are not named.
std::string words_of(const StepperOptions& options);

// Whether two settings agree in everything that to_json writes.
bool same_setting(const StepperOptions& a, const StepperOptions& b);

}  // namespace hepatica
