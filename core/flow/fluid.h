// SPDX-License-Identifier: GPL-3.0-or-later
// The fluid in the vessels: the homogeneous mixture of a liquid and a second phase, equations (2)
// and (9) of the paper, and presets for both with their sources.
#pragma once

#include <string>
#include <vector>

namespace hepatica {

// One substance. `source` says where the two numbers come from and is displayed beside them.
struct Phase {
    std::string name;
    double density_g_mm3 = 0.0;
    double viscosity_pa_s = 0.0;
    std::string source;
};

// Whole blood at high shear: 1060 kg/m3, 3.5 mPa s.
Phase blood();
// The paper's second phase. Forty per cent of gas in blood is an air embolus, not a treatment.
Phase gas();
// Iodised oil at body temperature, the clinical default of chemoembolization.
Phase lipiodol();
// A water-soluble carrier of the drug.
Phase carrier();

// "gas", "lipiodol" or "carrier", as on the command line and in the window; throws InputError that
// lists these for any other name.
Phase second_phase(const std::string& name);
std::vector<Phase> second_phases();
// Their names, for messages: "gas, lipiodol, carrier".
std::string names_of_second_phases();

// Default volume fraction of the second phase: within the 0.386 to 0.433 that the paper quotes.
inline constexpr double published_void_fraction = 0.40;

// A homogeneous fluid as the pressure laws see it.
struct Fluid {
    double density_g_mm3 = 1.06e-3;
    double viscosity_pa_s = 3.5e-3;
    double void_fraction = 0.0;  // of the second phase by volume, in [0, 1)

    bool operator==(const Fluid&) const = default;
};

// Density by (2), viscosity by (9). void_fraction is in [0, 1); 0 gives the liquid alone. Throws
// InputError that names the value where a property is not positive and finite.
Fluid mixture(const Phase& liquid, const Phase& second, double void_fraction);

// The phase alone.
Fluid pure(const Phase& phase);

// A blend by the same two rules, where `share` in [0, 1] is the volume fraction of the second
// fluid.
Fluid blend(const Fluid& first, const Fluid& second, double share);

// Throws InputError that names the offending property. The pressure laws rely on this check.
void validate(const Fluid& fluid);

}  // namespace hepatica
