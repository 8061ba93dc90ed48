// SPDX-License-Identifier: GPL-3.0-or-later
// pressure-drop: loss of pressure along one conical vessel segment (core/flow/pressure_drop.h).
#include <memory>

#include "app/verbs/flow_options.h"
#include "app/verbs/verbs.h"

namespace hepatica {

namespace {

struct PressureDropChoices {
    Cone cone;
    double mass_flow_g_s = 0.0;
    double loss_coefficient = 0.0;
    FluidOptions fluid;
};

Json run_pressure_drop(const PressureDropChoices& options) {
    options.fluid.require_use_of_phase();
    const Cone& cone = options.cone;
    const double m = options.mass_flow_g_s;
    validate(cone);
    validate_mass_flow(m);
    const PressureLaw law = options.fluid.law();
    const Fluid fluid = options.fluid.fluid();
    const bool bubbly = law != PressureLaw::regime;
    const Drop total = total_pressure_drop(law, cone, fluid, m);
    Json answer;
    answer["model"] = name_of(law);
    answer["total_is"] = bubbly ? "kinematic + frictional"
                                : "frictional: wall friction, laminar part included, once";
    answer["kinematic_pa"] = kinematic_drop(cone, fluid, m).pressure_pa;
    answer["frictional_pa"] = frictional_drop(law, cone, fluid, m).pressure_pa;
    answer["total_pa"] = total.pressure_pa;
    answer["slope_pa_s_g"] = total.slope_pa_s_g;
    answer["bernoulli_pa"] = bernoulli_drop_pa(cone, fluid, m);
    answer["static_pa"] = static_pressure_drop_pa(law, cone, fluid, m);
    answer["loss_pa"] = bifurcation_loss(options.loss_coefficient, cone, fluid, m).pressure_pa;
    const auto reynolds = [&](double radius_mm) {
        return bubbly ? bubbly_reynolds_number(radius_mm, fluid, m)
                      : reynolds_number(radius_mm, fluid, m);
    };
    answer["reynolds"] = reynolds(cone.proximal_radius_mm);
    answer["reynolds_distal"] = reynolds(cone.distal_radius_mm);
    answer["fluid"] = to_json(fluid);
    answer["liquid_source"] = options.fluid.liquid().source;
    if (fluid.void_fraction > 0.0) {
        answer["phase"] = options.fluid.second().name;
        answer["phase_source"] = options.fluid.second().source;
    }
    return answer;
}

}  // namespace

void add_pressure_drop(CommandLine& line) {
    const auto options = std::make_shared<PressureDropChoices>();
    CLI::App& verb =
        line.add_verb("pressure-drop", "Loss of pressure along one conical vessel segment",
                      [options](Job&) { return run_pressure_drop(*options); });
    verb.add_option("--r1-mm", options->cone.proximal_radius_mm, "Radius at the inlet")->required();
    verb.add_option("--r2-mm", options->cone.distal_radius_mm, "Radius at the outlet")->required();
    verb.add_option("--length-mm", options->cone.length_mm, "Length")->required();
    verb.add_option("--mass-flow-g-s", options->mass_flow_g_s, "Mass flow, negative backwards")
        ->required();
    verb.add_option("--loss-coefficient", options->loss_coefficient,
                    "Head lost on leaving a bifurcation, as a share of the dynamic pressure")
        ->check(CLI::Range(0.0, 1e3));
    options->fluid.add_to(verb);
}

}  // namespace hepatica
