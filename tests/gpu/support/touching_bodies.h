// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that touch something while they are led, for the tests of contact on the GPU's back end.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/deform/stepper/step_back_end.h"

namespace hepatica::test {

struct TouchingBody {
    BodyDescription description;
    std::optional<Tool> tool{};
    Vec3 tool_mm_per_step = Vec3::Zero();  // how it is led
    double closing_mm_per_step = 0.0;      // its jaws
    std::optional<Grab> grab{};
    Vec3 grab_mm_per_step = Vec3::Zero();
};

// "probe", "rod", "forceps", "hook", "obstacle", "self", "self-friction", "everything".
TouchingBody touching_body(const std::string& kind);

// Leads tool and grab on by a step.
void lead(TouchingBody& body, StepBackEnd& back_end, double dt_s);

}  // namespace hepatica::test
