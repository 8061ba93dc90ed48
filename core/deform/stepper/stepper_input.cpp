// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/stepper_input.h"

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/deform/potentials/load_input.h"
#include "core/deform/step/step_input.h"
#include "core/deform/stepper/stepper_checkpoint.h"

namespace hepatica {
void validate(const StepperOptions& options) {
    const auto check = [](bool good, const std::string& name, double value) {
        if (!good)
            throw InputError(name + " is " + number_text(value), "the step's options",
                             "Choose another value");
    };
    const auto check_tolerance = [&](const std::string& name, double value) {
        check(value >= 0.0 && std::isfinite(value), name, value);
    };
    check(options.newton_iterations >= 1, "the number of Newton iterates",
          options.newton_iterations);
    check(options.newton_tolerance > 0 && std::isfinite(options.newton_tolerance),
          "the tolerance of Newton's method", options.newton_tolerance);
    check(options.substeps >= 1, "the number of substeps", options.substeps);
    check(options.swing_substeps >= 1, "the number of substeps of a swing", options.swing_substeps);
    check(options.linear.max_iterations >= 1, "the limit of linear iterations",
          options.linear.max_iterations);
    check_tolerance("the tolerance of the linear solver's energy error",
                    options.linear.energy_tolerance);
    check_tolerance("the tolerance of the linear solver's residual",
                    options.linear.residual_tolerance);
    check(std::isfinite(options.velocity_error.alpha_per_s), "the velocity error's share of M",
          options.velocity_error.alpha_per_s);
    check(std::isfinite(options.velocity_error.beta_s), "the velocity error's share of K",
          options.velocity_error.beta_s);
}

void validate_checkpoint(const StepperCheckpoint& checkpoint, std::size_t nodes, bool touchable) {
    validate_state(checkpoint.nodes.positions_mm, checkpoint.nodes.velocities_mm_per_s, nodes);
    validate_grabs(checkpoint.grabs, nodes);
    validate_gravity(checkpoint.gravity_mm_per_s2);
    if (checkpoint.tool) validate_tool(checkpoint.tool->tool, touchable);
    if (checkpoint.solver.tool) validate_tool(checkpoint.solver.tool->tool, touchable);
}

}  // namespace hepatica
