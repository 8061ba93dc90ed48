// SPDX-License-Identifier: GPL-3.0-or-later
// A clamped beam of square section under its own weight, whose deflection is known from beam theory
// (Timoshenko 1921, with Cowper's 1966 shear coefficient), for the studies of error.
#pragma once

#include "core/deform/body/body.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// How a study discretises a body.
struct Discretisation {
    ElementModel model = ElementModel::corotated;
    ElementOrder order = ElementOrder::linear;
    bool hexahedra = false;
};

// "spring", "corotated", "neohookean", with "-10" for quadratic order; "hexahedron".
std::string name_of(const Discretisation& discretisation);
// Throws UsageError for any other name.
Discretisation discretisation_of(const std::string& name);

struct BeamSpec {
    double length_mm = 200.0;  // along x; clamped at x = 0
    double section_mm = 40.0;  // square
    Index3 cells{20, 3, 3};
    Material material{
        .young_modulus_pa = 1e6, .poisson_ratio = 0.3, .density_g_mm3 = 1e-3, .damping_ratio = 0.3};
    double gravity_mm_s2 = 9810.0;  // along -z
};

// A coarse beam of 100 mm by 20 mm, for tests with many time steps and elements.
BeamSpec short_beam(const Discretisation& discretisation);

// The beam as a body, of Kuhn bricks or of one hexahedron per cell.
BodyDescription clamped_beam(const BeamSpec& spec, const Discretisation& discretisation);

// Share of a rectangular section that carries shear (Cowper 1966).
double shear_coefficient(const Material& material);
// Tip deflection by linear theory: bending and shear.
double timoshenko_tip_mm(const BeamSpec& spec);
// Period of the first bending mode (Euler-Bernoulli).
double first_period_s(const BeamSpec& spec);

// Mean deflection of the end face.
double tip_deflection_mm(const BeamSpec& spec, std::span<const Vec3> rest_mm,
                         std::span<const Vec3> positions_mm);

}  // namespace hepatica
