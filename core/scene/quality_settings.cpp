// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/quality_settings.h"

#include <string>

#include "core/base/error.h"

namespace hepatica {

StepperOptions stepper_options(double quality) {
    if (!(quality >= 0.0 && quality <= 1.0))
        throw InputError("is " + std::to_string(quality), "quality", "Choose a value from 0 to 1");
    StepperOptions options;
    if (quality < 0.25) {
        options.linear.energy_tolerance = 0.1;
    } else if (quality < 0.75) {
        options.linear.energy_tolerance = 1e-2;
    } else if (quality < 1.0) {
        options.linear.energy_tolerance = 1e-3;
        options.newton_iterations = 2;
    } else {
        options.model = ElementModel::neohookean;
        options.linear.energy_tolerance = 1e-4;
        options.newton_iterations = 20;
    }
    return options;
}

}  // namespace hepatica
