// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/body/material.h"

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/base/error.h"

namespace hepatica {

Lame lame_of(const Material& material) {
    const double e = material.young_modulus_pa, nu = material.poisson_ratio;
    return {e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), e / (2.0 * (1.0 + nu))};
}

RayleighDamping rayleigh_of(const Material& material) {
    const double low = 2.0 * std::numbers::pi * material.damping_low_hz;
    const double high = 2.0 * std::numbers::pi * material.damping_high_hz;
    const double twice = 2.0 * material.damping_ratio / (low + high);
    return {twice * low * high, twice};
}

void validate(const Material& material) {
    const auto check = [](bool good, const char* name, double value, const char* range) {
        if (good) return;
        std::ostringstream problem;
        problem << name << " is " << value;
        throw InputError(problem.str(), "material", std::string("Give a value ") + range);
    };
    const Material& m = material;
    check(m.young_modulus_pa > 0 && std::isfinite(m.young_modulus_pa), "Young's modulus [Pa]",
          m.young_modulus_pa, "greater than 0");
    check(m.poisson_ratio >= 0 && m.poisson_ratio <= 0.49999, "Poisson's ratio", m.poisson_ratio,
          "from 0 to 0.49999");
    check(m.density_g_mm3 > 0 && std::isfinite(m.density_g_mm3), "density [g/mm3]", m.density_g_mm3,
          "greater than 0");
    check(m.damping_ratio >= 0 && std::isfinite(m.damping_ratio), "damping ratio", m.damping_ratio,
          "of 0 or more");
    check(m.damping_low_hz > 0 && std::isfinite(m.damping_low_hz), "lower damping frequency [Hz]",
          m.damping_low_hz, "greater than 0");
    check(m.damping_high_hz >= m.damping_low_hz && std::isfinite(m.damping_high_hz),
          "upper damping frequency [Hz]", m.damping_high_hz, "not below the lower frequency");
}

std::span<const MaterialPreset> material_presets() {
    // No tests to failure were found for these vessels.
    constexpr const char* guess_of_strength =
        "guesses: a strength of one to two times the modulus, as of soft tissue that fails at "
        "stretches "
        "of two to three; the fracture energy is that of bovine liver, 164 +- 6 J/m2 (Med Eng Phys "
        "2012;34:882)";
    static const std::array<MaterialPreset, 4> presets{{
        {"hepatic vein",
         "porcine hepatic veins, 0.62 +- 0.41 MPa at small strain (Umale et al., uniaxial, fresh "
         "tissue); Poisson's ratio is a guess below 1/2, since venous walls lose volume under load "
         "(J Biomech Eng 2019;141:091005)",
         {.young_modulus_pa = 0.62e6},
         1.0e6,
         164.0,
         guess_of_strength},
        {"portal vein",
         "taken like the hepatic vein's, rounded down: a guess within Umale's 0.62 +- 0.41 MPa",
         {.young_modulus_pa = 0.5e6},
         1.0e6,
         164.0,
         guess_of_strength},
        {"hepatic artery",
         "a guess: stiffer than the vein and nearly incompressible, since arterial walls keep "
         "their "
         "volume (J Biomech Eng 2019;141:091005)",
         {.young_modulus_pa = 1.0e6, .poisson_ratio = 0.49},
         2.0e6,
         164.0,
         guess_of_strength},
        {"vein at large strain",
         "porcine hepatic veins, 2.81 +- 2.23 MPa at large strain (Umale et al.)",
         {.young_modulus_pa = 2.81e6},
         2.8e6,
         164.0,
         guess_of_strength},
    }};
    return presets;
}

}  // namespace hepatica
