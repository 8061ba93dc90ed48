// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/fluid.h"
#include "core/base/number_text.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/units.h"

namespace hepatica {

namespace {

constexpr double kg_m3 = units::kilogram_per_cubic_metre;

double linear_rule(double first, double second, double share) {
    return first * (1.0 - share) + second * share;
}

}  // namespace

Phase blood() {
    return {"blood", 1060.0 * kg_m3, 3.5e-3,
            "whole blood at 37 C and high shear, as in most studies of hepatic arteries"};
}

Phase gas() {
    return {"gas", 1.2 * kg_m3, 1.8e-5,
            "air at 20 C and 101 kPa; the paper's second phase (its reference 5)"};
}

Phase lipiodol() {
    return {"lipiodol", 1280.0 * kg_m3, 25e-3,
            "Lipiodol Ultra-Fluide, product monograph: 25 mPa s at 37 C, relative density 1.280"};
}

Phase carrier() {
    return {"carrier", 993.3 * kg_m3, 0.692e-3,
            "water at 37 C, IAPWS R6-95 and R12-08; isotonic saline is within 2 per cent of it"};
}

std::vector<Phase> second_phases() {
    return {gas(), lipiodol(), carrier()};
}

std::string names_of_second_phases() {
    std::string names;
    for (const Phase& phase : second_phases()) names += (names.empty() ? "" : ", ") + phase.name;
    return names;
}

Phase second_phase(const std::string& name) {
    for (const Phase& phase : second_phases())
        if (phase.name == name) return phase;
    throw InputError("there is no second phase called '" + name + "'", "phase",
                     "Choose one of: " + names_of_second_phases());
}

Fluid mixture(const Phase& liquid, const Phase& second, double void_fraction) {
    if (!(void_fraction >= 0.0 && void_fraction < 1.0))
        throw InputError("the void fraction is " + number_text(void_fraction), "void fraction",
                         "Give a value from 0 up to, but not including, 1");
    validate(pure(liquid));
    validate(pure(second));
    return {linear_rule(liquid.density_g_mm3, second.density_g_mm3, void_fraction),
            linear_rule(liquid.viscosity_pa_s, second.viscosity_pa_s, void_fraction),
            void_fraction};
}

Fluid pure(const Phase& phase) {
    return {phase.density_g_mm3, phase.viscosity_pa_s, 0.0};
}

Fluid blend(const Fluid& first, const Fluid& second, double share) {
    return {linear_rule(first.density_g_mm3, second.density_g_mm3, share),
            linear_rule(first.viscosity_pa_s, second.viscosity_pa_s, share),
            linear_rule(first.void_fraction, second.void_fraction, share)};
}

void validate(const Fluid& fluid) {
    const auto check = [](const char* what, double value, double low, double high) {
        if (!(value >= low && value <= high))
            throw InputError(std::string("the ") + what + " is " + number_text(value), "fluid",
                             "Give a positive value in g/mm3 for density, in Pa s for viscosity");
    };
    check("density", fluid.density_g_mm3, 1e-9, 1.0);
    check("viscosity", fluid.viscosity_pa_s, 1e-9, 1e6);
    if (!(fluid.void_fraction >= 0.0 && fluid.void_fraction < 1.0))
        throw InputError("the void fraction is " + number_text(fluid.void_fraction), "fluid",
                         "Give a value from 0 up to, but not including, 1");
}

}  // namespace hepatica
