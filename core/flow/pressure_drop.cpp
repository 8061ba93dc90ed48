// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/pressure_drop.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/base/error.h"

namespace hepatica {

namespace {

using std::numbers::pi;

constexpr double laminar_reynolds = 2000.0;
constexpr double turbulent_reynolds = 4000.0;
constexpr double blasius = 0.079;

// |m|^0.75 by square roots: three times as fast as std::pow, and exact at 0.
double power_three_quarters(double m) {
    return std::sqrt(m) * std::sqrt(std::sqrt(m));
}

// Mean of R^-n over a cone for the exponents that occur, in forms without a difference of radii. a
// and b are the reciprocals of the end radii.
double mean_r4(double a, double b) {
    return a * b * (a * a + a * b + b * b) / 3.0;
}
double mean_r5(double a, double b) {
    return a * b * (a + b) * (a * a + b * b) / 4.0;
}
double mean_r6(double a, double b) {
    const double a2 = a * a;
    const double b2 = b * b;
    return a * b * (a2 * a2 + a * b * (a2 + a * b + b2) + b2 * b2) / 5.0;
}

// (r1^-n - r2^-n) / (n (r2 - r1)), the mean of R^-(n+1). Taken from the narrower end the relative
// difference d is never negative, so that log1p and expm1 keep every digit for any taper.
double mean_power(double n, double r1, double r2) {
    const double narrow = std::min(r1, r2);
    const double d = (std::max(r1, r2) - narrow) / narrow;
    const double quotient = d > 0.0 ? -std::expm1(-n * std::log1p(d)) / (n * d) : 1.0;
    return std::pow(narrow, -(n + 1.0)) * quotient;
}

struct RegimeLine {
    double a;
    double k;
};

// The straight line that joins f(2000) = 16/2000 to f(4000) = 0.079/4000^0.25.
RegimeLine transition_line() {
    static const double turbulent_end = blasius / std::pow(turbulent_reynolds, 0.25);
    const double laminar_end = 16.0 / laminar_reynolds;
    const double k = (turbulent_end - laminar_end) / (turbulent_reynolds - laminar_reynolds);
    return {laminar_end - laminar_reynolds * k, k};
}

// The part of the cone's length whose radius is in [low, high], with its end radii.
struct Stretch {
    double narrow;
    double wide;
    double length_mm;
};

Stretch stretch_between(const Cone& cone, double low, double high) {
    const double narrow = std::min(cone.proximal_radius_mm, cone.distal_radius_mm);
    const double wide = std::max(cone.proximal_radius_mm, cone.distal_radius_mm);
    if (narrow >= low && wide <= high) return {narrow, wide, cone.length_mm};
    const double from = std::clamp(low, narrow, wide);
    const double to = std::clamp(high, narrow, wide);
    const double share = wide > narrow ? std::max(0.0, to - from) / (wide - narrow) : 0.0;
    return {from, to, cone.length_mm * share};
}

// Friction where part of the cone is no longer laminar. Requires m > 0.
Drop regime_friction(const Cone& cone, const Fluid& fluid, double m) {
    const double mu = fluid.viscosity_pa_s;
    const double rho = fluid.density_g_mm3;
    const double reynolds_times_radius = 2.0 * m / (pi * mu);
    const double laminar_radius = reynolds_times_radius / laminar_reynolds;
    const double turbulent_radius = reynolds_times_radius / turbulent_reynolds;
    Drop drop;
    const Stretch laminar = stretch_between(cone, laminar_radius, HUGE_VAL);
    if (laminar.length_mm > 0.0) {
        const double c = 8.0 * mu / (pi * rho) * laminar.length_mm *
                         mean_r4(1.0 / laminar.narrow, 1.0 / laminar.wide);
        drop.pressure_pa += c * m;
        drop.slope_pa_s_g += c;
    }
    const Stretch middle = stretch_between(cone, turbulent_radius, laminar_radius);
    if (middle.length_mm > 0.0 && middle.narrow < laminar_radius) {
        const auto [line_a, line_k] = transition_line();
        const double a = 1.0 / middle.narrow;
        const double b = 1.0 / middle.wide;
        const double scale = m * middle.length_mm / (pi * pi * rho);
        const double constant = line_a * mean_r5(a, b);
        const double rising = line_k * reynolds_times_radius * mean_r6(a, b);
        drop.pressure_pa += scale * m * (constant + rising);
        drop.slope_pa_s_g += scale * (2.0 * constant + 3.0 * rising);
    }
    const Stretch turbulent = stretch_between(cone, 0.0, turbulent_radius);
    if (turbulent.length_mm > 0.0 && turbulent.narrow < turbulent_radius) {
        const double c = blasius * std::pow(0.5 * mu, 0.25) * std::pow(pi, -1.75) / rho *
                         turbulent.length_mm * mean_power(3.75, turbulent.narrow, turbulent.wide);
        const double p = power_three_quarters(m);
        drop.pressure_pa += c * p * m;
        drop.slope_pa_s_g += 1.75 * c * p;
    }
    return drop;
}

double kinematic_coefficient(const Cone& cone, const Fluid& fluid) {
    return 8.0 * fluid.viscosity_pa_s * cone.length_mm / (pi * fluid.density_g_mm3) *
           mean_r4(1.0 / cone.proximal_radius_mm, 1.0 / cone.distal_radius_mm);
}

// The factor of m |m|^0.75 in the paper's turbulent friction.
double friction_coefficient(PressureLaw law, const Cone& cone, const Fluid& fluid) {
    const double common = blasius * std::pow(fluid.viscosity_pa_s, 0.25) * std::pow(pi, -1.75) *
                          cone.length_mm /
                          (fluid.density_g_mm3 * std::pow(2.0 - 2.0 * fluid.void_fraction, 0.25));
    const double r1 = cone.proximal_radius_mm;
    const double r2 = cone.distal_radius_mm;
    if (law == PressureLaw::published)
        return common * std::pow(r1, -3.5) * mean_power(0.25, r1, r2);
    return common * mean_power(3.75, r1, r2);
}

Drop evaluate(const DropCoefficients& c, double mass_flow_g_s) {
    const double p = c.power > 0.0 ? c.power * power_three_quarters(std::abs(mass_flow_g_s)) : 0.0;
    return {mass_flow_g_s * (c.linear + p), c.linear + 1.75 * p};
}

}  // namespace

std::string name_of(PressureLaw law) {
    switch (law) {
        case PressureLaw::published:
            return "published";
        case PressureLaw::consistent:
            return "consistent";
        case PressureLaw::regime:
            break;
    }
    return "regime";
}

PressureLaw pressure_law(const std::string& name) {
    for (const PressureLaw law :
         {PressureLaw::published, PressureLaw::consistent, PressureLaw::regime})
        if (name_of(law) == name) return law;
    throw InputError("there is no pressure law called '" + name + "'", "model",
                     "Choose one of: published, consistent, regime");
}

Drop kinematic_drop(const Cone& cone, const Fluid& fluid, double mass_flow_g_s) {
    return evaluate({kinematic_coefficient(cone, fluid), 0.0}, mass_flow_g_s);
}

Drop frictional_drop(PressureLaw law, const Cone& cone, const Fluid& fluid, double mass_flow_g_s) {
    if (law != PressureLaw::regime)
        return evaluate({0.0, friction_coefficient(law, cone, fluid)}, mass_flow_g_s);
    const double m = std::abs(mass_flow_g_s);
    if (m <= laminar_limit_g_s(cone, fluid)) return kinematic_drop(cone, fluid, mass_flow_g_s);
    const Drop drop = regime_friction(cone, fluid, m);
    return {std::copysign(drop.pressure_pa, mass_flow_g_s), drop.slope_pa_s_g};
}

Drop total_pressure_drop(PressureLaw law, const Cone& cone, const Fluid& fluid,
                         double mass_flow_g_s) {
    if (law == PressureLaw::regime) return frictional_drop(law, cone, fluid, mass_flow_g_s);
    return evaluate(drop_coefficients(law, cone, fluid), mass_flow_g_s);
}

double dynamic_pressure_pa(double radius_mm, const Fluid& fluid, double mass_flow_g_s) {
    const double flux = mass_flow_g_s / (pi * radius_mm * radius_mm);
    return flux * flux / (2.0 * fluid.density_g_mm3);
}

double bernoulli_drop_pa(const Cone& cone, const Fluid& fluid, double mass_flow_g_s) {
    const double a = 1.0 / cone.distal_radius_mm;
    const double b = 1.0 / cone.proximal_radius_mm;
    // (a^4 - b^4) from the difference of the radii, which is exact where they are close.
    const double difference = (cone.proximal_radius_mm - cone.distal_radius_mm) * a * b;
    const double fourth_powers = difference * (a + b) * (a * a + b * b);
    const double m = mass_flow_g_s / pi;
    return m * m / (2.0 * fluid.density_g_mm3) * fourth_powers;
}

double static_pressure_drop_pa(PressureLaw law, const Cone& cone, const Fluid& fluid,
                               double mass_flow_g_s) {
    return total_pressure_drop(law, cone, fluid, mass_flow_g_s).pressure_pa +
           bernoulli_drop_pa(cone, fluid, mass_flow_g_s);
}

Drop bifurcation_loss(double coefficient, const Cone& cone, const Fluid& fluid,
                      double mass_flow_g_s) {
    const double per_flow = coefficient * dynamic_pressure_pa(cone.proximal_radius_mm, fluid, 1.0);
    return {per_flow * mass_flow_g_s * std::abs(mass_flow_g_s),
            2.0 * per_flow * std::abs(mass_flow_g_s)};
}

double reynolds_number(double radius_mm, const Fluid& fluid, double mass_flow_g_s) {
    return 2.0 * std::abs(mass_flow_g_s) / (pi * radius_mm * fluid.viscosity_pa_s);
}

double bubbly_reynolds_number(double radius_mm, const Fluid& fluid, double mass_flow_g_s) {
    return reynolds_number(radius_mm, fluid, mass_flow_g_s) * (1.0 - fluid.void_fraction);
}

double laminar_limit_g_s(const Cone& cone, const Fluid& fluid) {
    const double narrow = std::min(cone.proximal_radius_mm, cone.distal_radius_mm);
    return 0.5 * laminar_reynolds * pi * fluid.viscosity_pa_s * narrow;
}

DropCoefficients drop_coefficients(PressureLaw law, const Cone& cone, const Fluid& fluid) {
    return {kinematic_coefficient(cone, fluid),
            law == PressureLaw::regime ? 0.0 : friction_coefficient(law, cone, fluid)};
}

namespace {

void check_range(const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    std::ostringstream problem;
    std::ostringstream remedy;
    problem << "the " << what << " is " << value;
    remedy << "Give a value from " << low << " to " << high;
    throw InputError(problem.str(), "vessel segment", remedy.str());
}

}  // namespace

void validate(const Cone& cone) {
    check_range("proximal radius in mm", cone.proximal_radius_mm, 1e-9, 1e6);
    check_range("distal radius in mm", cone.distal_radius_mm, 1e-9, 1e6);
    check_range("length in mm", cone.length_mm, 0.0, 1e9);
}

void validate_mass_flow(double mass_flow_g_s) {
    check_range("mass flow in g/s", mass_flow_g_s, -1e15, 1e15);
}

}  // namespace hepatica
