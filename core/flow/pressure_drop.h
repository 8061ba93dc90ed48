// SPDX-License-Identifier: GPL-3.0-or-later
// The pressure drop along a conical vessel segment, equations (1) to (10) of the paper, as printed
// and corrected. Pure functions of the flow with their derivative; docs/flow.md compares the forms.
#pragma once

#include <string>

#include "core/flow/fluid.h"

namespace hepatica {

// A straight segment whose radius changes linearly. Positive flow enters at the proximal end.
// Valid: radii 1e-9 to 1e6 mm, length 0 to 1e9 mm.
struct Cone {
    double proximal_radius_mm = 0.0;
    double distal_radius_mm = 0.0;
    double length_mm = 0.0;
};

// published:  (5) plus (10) as printed. (10) has the dimension of a pressure only if its flow is a
//             mass flux; it is taken at the proximal end and held constant along the cone.
// consistent: (5) plus (6)-(8) integrated with the flux that the local radius gives.
// regime:     one law of wall friction. Fanning's f is 16/Re below Re 2000, Blasius' 0.079/Re^0.25
//             above 4000, linear between; Re varies along the cone. Equals (5) where flow is
//             laminar.
// The first two add turbulent friction to a laminar drop at any Reynolds number.
enum class PressureLaw { published, consistent, regime };

// "published", "consistent", "regime". pressure_law() throws InputError that lists them.
std::string name_of(PressureLaw law);
PressureLaw pressure_law(const std::string& name);

// The drop from the proximal to the distal end and its derivative with respect to the mass flow.
struct Drop {
    double pressure_pa = 0.0;
    double slope_pa_s_g = 0.0;
};

// All functions below are odd in the mass flow (unless stated otherwise), finite for every valid
// cone and |mass flow| up to 1e15 g/s, need no special case for equal radii, and are pure. They do
// not check their arguments: call validate() on external input.

// (5): the viscous drop of laminar flow.
Drop kinematic_drop(const Cone& cone, const Fluid& fluid, double mass_flow_g_s);

// (10) under `published`; (6)-(8) integrated under `consistent`; the whole wall friction, including
// the laminar part, under `regime`.
Drop frictional_drop(PressureLaw law, const Cone& cone, const Fluid& fluid, double mass_flow_g_s);

// The drop of total pressure p + G^2/(2 rho): kinematic plus frictional, except under `regime`,
// where friction includes everything. Strictly increasing in the mass flow where length > 0.
Drop total_pressure_drop(PressureLaw law, const Cone& cone, const Fluid& fluid,
                         double mass_flow_g_s);

// (G2^2 - G1^2)/(2 rho): the static pressure that accelerates the flow in a taper. The paper leaves
// it out; in a tapering hepatic artery it is larger than the friction. Even in the mass flow.
double bernoulli_drop_pa(const Cone& cone, const Fluid& fluid, double mass_flow_g_s);

// Drop of the static pressure: total_pressure_drop + bernoulli_drop.
double static_pressure_drop_pa(PressureLaw law, const Cone& cone, const Fluid& fluid,
                               double mass_flow_g_s);

// G^2/(2 rho) at a radius.
double dynamic_pressure_pa(double radius_mm, const Fluid& fluid, double mass_flow_g_s);

// Head lost where a branch leaves a bifurcation, as a share of the dynamic pressure at the branch's
// proximal end. The paper names this loss (turbulent mixing of drug and blood) as future work and
// gives no number; the engineering range for a smooth branch is 0 to about 1. 0 is the default.
Drop bifurcation_loss(double coefficient, const Cone& cone, const Fluid& fluid,
                      double mass_flow_g_s);

// Reynolds number based on the diameter, 2 |mdot| / (pi R mu); and (8) with its factor (1 - void
// fraction).
double reynolds_number(double radius_mm, const Fluid& fluid, double mass_flow_g_s);
double bubbly_reynolds_number(double radius_mm, const Fluid& fluid, double mass_flow_g_s);

// The largest mass flow at which the whole cone is laminar (Re <= 2000).
double laminar_limit_g_s(const Cone& cone, const Fluid& fluid);

// The two coefficients of linear * m + power * m |m|^0.75, which holds for `published` and
// `consistent`, and for `regime` up to laminar_limit_g_s, with power = 0.
struct DropCoefficients {
    double linear = 0.0;
    double power = 0.0;
};
DropCoefficients drop_coefficients(PressureLaw law, const Cone& cone, const Fluid& fluid);

// Throw InputError that names the value and the valid range.
void validate(const Cone& cone);
void validate_mass_flow(double mass_flow_g_s);

}  // namespace hepatica
