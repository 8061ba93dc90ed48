// SPDX-License-Identifier: GPL-3.0-or-later
// Every element on the clamped beam against figures from CalculiX (large deformation, same meshes)
// and beam theory.
#include "core/study/reference_beam.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/deform/stepper/cpu_stepper.h"

namespace hepatica {
namespace {

double tip_at_rest(BeamSpec spec, const std::string& element, double dt_s = 0.1,
                   int newton_iterations = 1) {
    spec.material.damping_ratio = 0.5;
    const Discretisation d = discretisation_of(element);
    const BodyDescription body = clamped_beam(spec, d);
    const auto stepper = make_cpu_stepper(body, {.model = d.model,
                                                 .order = d.order,
                                                 .linear = {.energy_tolerance = 1e-3},
                                                 .newton_iterations = newton_iterations});
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    for (int i = 0; i < 60; ++i) stepper->step(dt_s);
    return tip_deflection_mm(spec, body.mesh.vertices_mm, stepper->positions_mm());
}

TEST(ReferenceBeam, TimoshenkoGivesTheKnownFigure) {
    EXPECT_NEAR(timoshenko_tip_mm(BeamSpec{}), 15.315, 1e-3);
}

TEST(ReferenceBeam, LinearTetrahedraMatchTheIndependentProgram) {
    EXPECT_NEAR(tip_at_rest({.cells = {20, 3, 3}}, "corotated") / 10.811, 1.0, 3e-3);
    EXPECT_NEAR(tip_at_rest({.cells = {35, 7, 7}}, "corotated") / 13.759, 1.0, 3e-3);
}

TEST(ReferenceBeam, QuadraticTetrahedraMatchTheIndependentProgram) {
    EXPECT_NEAR(tip_at_rest({.cells = {20, 3, 3}}, "corotated-10") / 14.944, 1.0, 3e-3);
}

TEST(ReferenceBeam, NeoHookeanTetrahedraMatchTheIndependentProgram) {
    EXPECT_NEAR(tip_at_rest({.cells = {20, 3, 3}}, "neohookean", 0.1, 10) / 10.811, 1.0, 3e-3);
    EXPECT_NEAR(tip_at_rest({.cells = {20, 3, 3}}, "neohookean-10", 0.2, 10) / 14.944, 1.0, 3e-3);
}

// 15.0 mm is where refinement leads with large deformation.
TEST(ReferenceBeam, FewHexahedraBendLikeManyTetrahedra) {
    EXPECT_NEAR(tip_at_rest({.cells = {20, 4, 4}}, "hexahedron") / 15.0, 1.0, 0.01);
}

// A beam close to incompressible bends within 6 % of Timoshenko's figure, on few cells: what locks
// stays far above (linear tetrahedra sink less than a fifth as far).
TEST(ReferenceBeam, NearlyIncompressibleBeamsDoNotLock) {
    BeamSpec spec{.cells = {16, 2, 2}};
    spec.material.poisson_ratio = 0.499;
    EXPECT_NEAR(tip_at_rest(spec, "corotated-10") / timoshenko_tip_mm(spec), 1.0, 0.07);
    spec.cells = {20, 4, 4};
    EXPECT_NEAR(tip_at_rest(spec, "hexahedron") / timoshenko_tip_mm(spec), 1.0, 0.08);
    EXPECT_LT(tip_at_rest(spec, "corotated"), 0.6 * timoshenko_tip_mm(spec));
}

TEST(ReferenceBeam, NamesAreUnderstood) {
    for (const char* name :
         {"spring", "corotated", "neohookean", "corotated-10", "neohookean-10", "hexahedron"})
        EXPECT_EQ(name_of(discretisation_of(name)), name);
    EXPECT_THROW(discretisation_of("brick"), UsageError);
}

}  // namespace
}  // namespace hepatica
