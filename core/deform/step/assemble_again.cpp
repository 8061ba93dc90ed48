// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/assemble_again.h"

#include <string>

#include "core/base/error.h"
#include "core/deform/step/step_input.h"
#include "core/deform/step/velocity_error.h"

namespace hepatica {

void assemble_again(const Body& body, IncrementalPotential& potential,
                    const SolverCheckpoint& checkpoint) {
    const MatrixOrigin& origin = *checkpoint.made_from;
    const std::optional<ToolOrigin>& with = checkpoint.tool;
    validate_time_step(origin.dt_s);
    const std::size_t nodes = body.rest_positions_mm.size();
    validate_state(origin.first_mm, origin.first_mm, nodes);
    const bool first = origin.iterate_mm.empty();
    if (!first) validate_state(origin.iterate_mm, origin.iterate_mm, nodes);
    const bool taut = !origin.taut_mm.empty();
    if (taut) validate_state(origin.taut_mm, origin.taut_mm, nodes);
    if (origin.held.size() != nodes)
        throw InputError("holds " + std::to_string(origin.held.size()) + " nodes instead of " +
                             std::to_string(nodes),
                         "the checkpoint of a body",
                         "Make the stepper of the body that it was taken of");
    PotentialList potentials(body);
    potentials.set_grabs(origin.grabs);
    potentials.set_gravity(origin.gravity_mm_per_s2);
    potentials.surfaces().set_overlaps(checkpoint.overlaps);
    std::vector<Vec3> began_mm = origin.first_mm;
    if (with) {
        potentials.set_tool(with->tool);
        began_mm = with->start_mm;
    }
    if (!checkpoint.began_mm.empty()) began_mm = checkpoint.began_mm;
    validate_state(began_mm, began_mm, nodes);
    potentials.begin_step({began_mm, {}}, origin.dt_s, origin.held);
    VelocityError error;
    error.set(origin.velocity_error);
    const BodyState start{origin.first_mm, std::vector<Vec3>(nodes, Vec3::Zero())};
    StepUnderway step{.potentials = potentials,
                      .start = start,
                      .dt_s = origin.dt_s,
                      .before = {},
                      .velocity = {},
                      .positions = origin.first_mm};
    potential.freeze(origin.held);
    potential.forget_matrix();
    potential.count_collapse(origin.collapse);
    if (taut) {
        potential.evaluate_forces(origin.taut_mm);
        potential.find_tension();
    }
    potential.evaluate(step.positions);
    potential.find_force(step);
    potential.assemble(step);
    if (taut) potential.add_tension(step.dt_s);
    if (error.any()) error.add_to(potential, body, step.dt_s);
    if (first) return;
    if (body.damping.beta_s > 0.0)
        potential.keep_damping(step, origin.first_mm, error.any() ? &error.matrix() : nullptr);
    step.iterate = 1;
    step.positions = origin.iterate_mm;
    potential.evaluate(step.positions);
    potential.find_force(step);
    potential.assemble(step);
}

}  // namespace hepatica
