// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/flow_options.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/patient/patient_case.h"

namespace hepatica {

void FluidOptions::add_liquid_to(CLI::App& verb) {
    verb.add_option("--model", model,
                    "Pressure law: published, consistent or regime (default regime)");
    verb.add_option("--liquid-density-kg-m3", liquid_density_kg_m3, "Density of the liquid")
        ->capture_default_str();
    verb.add_option("--liquid-viscosity-pa-s", liquid_viscosity_pa_s, "Viscosity of the liquid")
        ->capture_default_str();
}

void FluidOptions::add_to(CLI::App& verb) {
    add_liquid_to(verb);
    verb.add_option("--void-fraction", void_fraction,
                    "Share of the second phase by volume, 0 to below 1 (default 0; 0.40 with "
                    "--model published)");
    verb.add_option("--phase", phase,
                    "Second phase: gas, lipiodol or carrier (default lipiodol; gas with --model "
                    "published)");
    verb.add_option("--phase-density-kg-m3", phase_density_kg_m3, "Density of the second phase");
    verb.add_option("--phase-viscosity-pa-s", phase_viscosity_pa_s,
                    "Viscosity of the second phase");
}

void FluidOptions::require_use_of_phase() const {
    const bool described = !phase.empty() || phase_density_kg_m3 || phase_viscosity_pa_s;
    if (!described || void_fraction || share() > 0.0) return;
    throw UsageError("nothing of the second phase is in the fluid",
                     !phase.empty()        ? "--phase"
                     : phase_density_kg_m3 ? "--phase-density-kg-m3"
                                           : "--phase-viscosity-pa-s",
                     "Say how much of it: --void-fraction, above 0");
}

double FluidOptions::share() const {
    const double otherwise = law() == PressureLaw::published ? published_void_fraction
                                                             : default_injection::void_fraction;
    return void_fraction.value_or(otherwise);
}

Phase FluidOptions::second() const {
    const char* otherwise = law() == PressureLaw::published ? "gas" : "lipiodol";
    Phase second = second_phase(phase.empty() ? otherwise : phase);
    if (phase_density_kg_m3)
        second.density_g_mm3 = *phase_density_kg_m3 * units::kilogram_per_cubic_metre;
    if (phase_viscosity_pa_s) second.viscosity_pa_s = *phase_viscosity_pa_s;
    if (phase_density_kg_m3 || phase_viscosity_pa_s) second.source = "as given";
    return second;
}

Phase FluidOptions::liquid() const {
    Phase liquid = blood();
    const double density = liquid_density_kg_m3 * units::kilogram_per_cubic_metre;
    if (density != liquid.density_g_mm3 || liquid_viscosity_pa_s != liquid.viscosity_pa_s)
        liquid.source = "as given";
    liquid.density_g_mm3 = density;
    liquid.viscosity_pa_s = liquid_viscosity_pa_s;
    return liquid;
}

Json to_json(const Fluid& fluid) {
    return {{"density_kg_m3", fluid.density_g_mm3 / units::kilogram_per_cubic_metre},
            {"viscosity_pa_s", fluid.viscosity_pa_s},
            {"void_fraction", fluid.void_fraction}};
}

void TreeFileOptions::add_to(CLI::App& verb) {
    verb.add_option("--tree-space", space,
                    "Axes of a tree's file that does not state them: lps or ras")
        ->check(CLI::IsMember({"lps", "ras"}));
    verb.add_option("--radius-mm", radius_mm, "Radius of all vessels, for a .vtp without radii")
        ->check(CLI::Range(0.001, 1000.0));
}

TreeFileFacts TreeFileOptions::facts() const {
    TreeFileFacts facts;
    if (!space.empty()) facts.space = space == "ras" ? PatientSpace::ras : PatientSpace::lps;
    facts.radius_mm = radius_mm;
    return facts;
}

VesselTree read_any_tree(const std::filesystem::path& place, const TreeFileOptions& options) {
    if (!std::filesystem::exists(place))
        throw InputError("does not exist", place.string(),
                         "Name a case's folder, or a tree in a .vtp, .swc or .json file");
    const bool in_case = std::filesystem::is_directory(place) || is_case(place);
    if (in_case && (!options.space.empty() || options.radius_mm))
        throw UsageError("is of no use for a case, which knows its axes and its radii",
                         options.space.empty() ? "--radius-mm" : "--tree-space", "Leave it out");
    if (in_case) return read_case_without_voxels(place).tree;
    return read_tree(place, options.facts());
}

TreePoint parse_point(const std::string& option, const std::string& text, const VesselTree& tree) {
    const auto [x, y, z] = parse_triple(option, text);
    return point_of_vessel(option, Vec3(x, y, z), tree);
}

TreePoint point_of_vessel(const std::string& option, const Vec3& position_mm,
                          const VesselTree& tree) {
    constexpr double reach_mm = 10.0;
    const TreePoint place = nearest_point(tree, position_mm);
    if (!(place.distance_mm <= reach_mm))
        throw InputError("the nearest vessel is " + std::to_string(place.distance_mm) + " mm away",
                         option, "Give a place within 10 mm of a vessel, X,Y,Z in LPS [mm]");
    return place;
}

}  // namespace hepatica
