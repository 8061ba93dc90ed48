// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/pressure_drop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "tests/flow/quadrature.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::integrate;
using testing_flow::Random;
using testing_flow::random_cone;
using testing_flow::random_fluid;
using testing_flow::Real;

constexpr std::array laws = {PressureLaw::published, PressureLaw::consistent, PressureLaw::regime};
constexpr Real pi = 3.141592653589793238462643383279503L;

// The pressure gradients as the physics states them, before anybody integrated anything.
struct Gradient {
    Cone cone;
    Fluid fluid;
    Real m;

    Real radius(Real x) const {
        const Real r1 = cone.proximal_radius_mm;
        return r1 + (cone.distal_radius_mm - r1) * x / cone.length_mm;
    }
    // (3)
    Real kinematic(Real x) const {
        const Real r = radius(x);
        return 8 * Real(fluid.viscosity_pa_s) * m / (pi * r * r * r * r * fluid.density_g_mm3);
    }
    // (6) to (8) for the mass flux g at a place
    Real bubbly(Real r, Real g) const {
        const Real re = 2 * g * (1 - Real(fluid.void_fraction)) * r / fluid.viscosity_pa_s;
        const Real f = 0.079L / std::pow(re, 0.25L);
        return f * g * g / (r * fluid.density_g_mm3);
    }
    Real published(Real x) const {
        const Real r1 = cone.proximal_radius_mm;
        return bubbly(radius(x), m / (pi * r1 * r1));
    }
    Real consistent(Real x) const {
        const Real r = radius(x);
        return bubbly(r, m / (pi * r * r));
    }
    // Fanning: dP/dx = f G^2 / (rho R)
    Real regime(Real x) const {
        const Real r = radius(x);
        const Real g = m / (pi * r * r);
        const Real re = 2 * g * r / fluid.viscosity_pa_s;
        const Real turbulent = 0.079L / std::pow(4000.0L, 0.25L);
        Real f = 16 / re;
        if (re > 4000)
            f = 0.079L / std::pow(re, 0.25L);
        else if (re > 2000)
            f = 0.008L + (turbulent - 0.008L) * (re - 2000) / 2000;
        return f * g * g / (r * fluid.density_g_mm3);
    }
    Real friction(PressureLaw law, Real x) const {
        if (law == PressureLaw::published) return published(x);
        if (law == PressureLaw::consistent) return consistent(x);
        return regime(x);
    }
};

Real oracle_friction(PressureLaw law, const Cone& cone, const Fluid& fluid, double m) {
    const Gradient gradient{cone, fluid, m};
    const auto integrand = [&](Real x) { return gradient.friction(law, x); };
    // A kink inside an interval can deceive the error estimate: integrate between the places where
    // the Reynolds number, which is monotone along a cone, crosses a border of regimes.
    std::vector<Real> borders = {0.0L, cone.length_mm};
    for (const double border : {2000.0, 4000.0}) {
        Real low = 0;
        Real high = cone.length_mm;
        const auto above = [&](Real x) {
            return 2 * Real(m) / (pi * gradient.radius(x) * fluid.viscosity_pa_s) > border;
        };
        if (above(low) == above(high)) continue;
        for (int i = 0; i < 70; ++i) {
            const Real middle = (low + high) / 2;
            (above(middle) == above(low) ? low : high) = middle;
        }
        borders.push_back(low);
    }
    std::ranges::sort(borders);
    Real sum = 0;
    for (std::size_t i = 1; i < borders.size(); ++i)
        sum += integrate(integrand, borders[i - 1], borders[i], 1e-15L);
    return sum;
}

Fluid reference_fluid(double void_fraction) {
    return mixture({"liquid", 1060e-6, 3.5e-3, ""}, {"gas", 1.2e-6, 1.8e-5, ""}, void_fraction);
}

TEST(Quadrature, IsExactForPolynomialsOfDegree22) {
    for (int n = 0; n <= 22; ++n) {
        const Real exact = (std::pow(3.0L, n + 1) - std::pow(-1.0L, n + 1)) / (n + 1);
        const Real found = integrate([n](Real x) { return std::pow(x, n); }, -1.0L, 3.0L, 1.0L, 0);
        EXPECT_NEAR(static_cast<double>(found / exact), 1.0, 1e-17) << n;
    }
}

// The table of the design notes, six digits as printed.
TEST(PressureDrop, MeetsTheReferenceValues) {
    const Cone cone{2.5, 1.8, 20.0};
    const Fluid bubbly = reference_fluid(0.4);
    EXPECT_NEAR(kinematic_drop(cone, bubbly, 2.0).pressure_pa, 17.257585, 5e-7);
    EXPECT_NEAR(frictional_drop(PressureLaw::published, cone, bubbly, 2.0).pressure_pa, 3.63009,
                5e-6);
    EXPECT_NEAR(frictional_drop(PressureLaw::consistent, cone, bubbly, 2.0).pressure_pa, 6.864119,
                5e-7);
    EXPECT_NEAR(frictional_drop(PressureLaw::regime, cone, bubbly, 2.0).pressure_pa, 17.257585,
                5e-7);
    EXPECT_NEAR(bernoulli_drop_pa(cone, bubbly, 2.0), 22.1783, 5e-5);

    const Fluid liquid = reference_fluid(0.0);
    EXPECT_NEAR(kinematic_drop(cone, liquid, 2.0).pressure_pa, 17.2116, 5e-5);
    EXPECT_NEAR(frictional_drop(PressureLaw::consistent, cone, liquid, 2.0).pressure_pa, 4.1181,
                5e-5);
    EXPECT_NEAR(bernoulli_drop_pa(cone, liquid, 2.0), 13.317, 5e-4);

    EXPECT_NEAR(total_pressure_drop(PressureLaw::regime, cone, bubbly, 50.0).pressure_pa, 1688.6,
                5e-2);
    EXPECT_NEAR(reynolds_number(2.5, bubbly, 50.0), 6042, 0.5);
    EXPECT_NEAR(reynolds_number(1.8, bubbly, 50.0), 8392, 0.5);
    EXPECT_NEAR(
        total_pressure_drop(PressureLaw::regime, {2.5, 1.0, 20.0}, liquid, 15.0).pressure_pa, 613.5,
        5e-2);
}

// The notes' published friction "at the mean radius": the same formula with the flux of R = 2.15.
TEST(PressureDrop, PublishedTakesItsFluxAtTheProximalEnd) {
    const Cone cone{2.5, 1.8, 20.0};
    const Fluid fluid = reference_fluid(0.4);
    const double at_inlet = frictional_drop(PressureLaw::published, cone, fluid, 2.0).pressure_pa;
    EXPECT_NEAR(at_inlet * std::pow(2.5 / 2.15, 3.5), 6.15421, 5e-6);
    const Cone turned{1.8, 2.5, 20.0};
    const double turned_drop =
        frictional_drop(PressureLaw::published, turned, fluid, 2.0).pressure_pa;
    EXPECT_NEAR(turned_drop / at_inlet, std::pow(2.5 / 1.8, 3.5), 1e-12);
}

TEST(PressureDrop, AgreesWithQuadratureOnTenThousandCones) {
    Random random(1);
    double worst = 0.0;
    for (int i = 0; i < 10'000; ++i) {
        const Cone cone = random_cone(random);
        const Fluid fluid = random_fluid(random);
        const double m = random.logarithmic(1e-6, 100.0);
        const Gradient gradient{cone, fluid, m};
        const Real kinematic =
            integrate([&](Real x) { return gradient.kinematic(x); }, 0.0L, cone.length_mm, 1e-15L);
        const auto error = [&](double found, Real exact) {
            return std::abs(static_cast<double>((found - exact) / exact));
        };
        worst = std::max(worst, error(kinematic_drop(cone, fluid, m).pressure_pa, kinematic));
        for (const PressureLaw law : laws) {
            const Real friction = oracle_friction(law, cone, fluid, m);
            const Real total = law == PressureLaw::regime ? friction : kinematic + friction;
            worst =
                std::max({worst, error(frictional_drop(law, cone, fluid, m).pressure_pa, friction),
                          error(total_pressure_drop(law, cone, fluid, m).pressure_pa, total)});
        }
        ASSERT_LE(worst, 1e-12) << "case " << i << ": R " << cone.proximal_radius_mm << ", "
                                << cone.distal_radius_mm << " mm, L " << cone.length_mm << " mm, "
                                << m << " g/s";
    }
    RecordProperty("worst_relative_error", std::to_string(worst * 1e15) + "e-15");
}

TEST(PressureDrop, IsContinuousThroughEqualRadii) {
    Random random(2);
    for (int i = 0; i < 10'000; ++i) {
        const double r = random.logarithmic(0.05, 10.0);
        const double length = random.logarithmic(0.1, 200.0);
        const Fluid fluid = random_fluid(random);
        const double m = random.logarithmic(1e-6, 100.0);
        for (const PressureLaw law : laws) {
            const double cylinder = total_pressure_drop(law, {r, r, length}, fluid, m).pressure_pa;
            for (const double taper : {-1e-14, 1e-14, -1e-13, 1e-13}) {
                const double cone =
                    total_pressure_drop(law, {r, r * (1.0 + taper), length}, fluid, m).pressure_pa;
                ASSERT_NEAR(cone / cylinder, 1.0, 1e-12) << i;
            }
            // Further out against the oracle: no digit is lost where the radii nearly agree.
            const double taper = random.logarithmic(1e-12, 1e-3);
            const Cone cone{r, r * (1.0 + taper), length};
            const double exact = static_cast<double>(oracle_friction(law, cone, fluid, m));
            if (i % 10 == 0) {
                ASSERT_NEAR(frictional_drop(law, cone, fluid, m).pressure_pa / exact, 1.0, 1e-12);
            }
        }
        ASSERT_EQ(bernoulli_drop_pa({r, r, length}, fluid, m), 0.0);
    }
}

TEST(PressureDrop, IsOddAndStrictlyIncreasing) {
    Random random(3);
    for (int i = 0; i < 10'000; ++i) {
        const Cone cone = random_cone(random);
        const Fluid fluid = random_fluid(random);
        // Around the change of regime as often as anywhere.
        const double m = i % 2 == 0 ? random.logarithmic(1e-6, 100.0)
                                    : laminar_limit_g_s(cone, fluid) * random.uniform(0.9, 2.2);
        const double more = m * (1.0 + random.logarithmic(1e-9, 1.0));
        for (const PressureLaw law : laws) {
            const Drop here = total_pressure_drop(law, cone, fluid, m);
            const Drop there = total_pressure_drop(law, cone, fluid, more);
            const Drop back = total_pressure_drop(law, cone, fluid, -m);
            ASSERT_GT(there.pressure_pa, here.pressure_pa) << i << " " << name_of(law);
            ASSERT_EQ(back.pressure_pa, -here.pressure_pa);
            ASSERT_EQ(back.slope_pa_s_g, here.slope_pa_s_g);
            ASSERT_GT(here.slope_pa_s_g, 0.0);
            ASSERT_EQ(total_pressure_drop(law, cone, fluid, 0.0).pressure_pa, 0.0);
        }
    }
}

// Central differences of the value, in steps that balance truncation against rounding.
TEST(PressureDrop, HasTheRightDerivative) {
    Random random(4);
    for (int i = 0; i < 10'000; ++i) {
        const Cone cone = random_cone(random);
        const Fluid fluid = random_fluid(random);
        const double m = i % 2 == 0 ? random.logarithmic(1e-6, 100.0)
                                    : laminar_limit_g_s(cone, fluid) * random.uniform(0.9, 2.2);
        const double step = 1e-6 * m;
        for (const PressureLaw law : laws) {
            const double slope = total_pressure_drop(law, cone, fluid, m).slope_pa_s_g;
            const double above = total_pressure_drop(law, cone, fluid, m + step).pressure_pa;
            const double below = total_pressure_drop(law, cone, fluid, m - step).pressure_pa;
            const double difference = (above - below) / (2.0 * step);
            // The slope of the regime form jumps where a cylinder leaves a regime.
            const double re = reynolds_number(cone.proximal_radius_mm, fluid, m);
            const bool at_kink = law == PressureLaw::regime &&
                                 (std::abs(re / 4000 - 1) < 1e-5 || std::abs(re / 2000 - 1) < 1e-5);
            if (!at_kink) {
                ASSERT_NEAR(difference / slope, 1.0, 1e-6) << i << " " << name_of(law);
            }
        }
        const Drop loss = bifurcation_loss(0.7, cone, fluid, m);
        const double above = bifurcation_loss(0.7, cone, fluid, m + step).pressure_pa;
        const double below = bifurcation_loss(0.7, cone, fluid, m - step).pressure_pa;
        ASSERT_NEAR((above - below) / (2.0 * step) / loss.slope_pa_s_g, 1.0, 1e-8);
        ASSERT_EQ(bifurcation_loss(0.7, cone, fluid, -m).pressure_pa, -loss.pressure_pa);
    }
}

// Hagen and Poiseuille: dP = 8 mu L Q / (pi R^4); Blasius at Re 1e5 from the Darcy factor
// 0.316/Re^0.25: dP = f (L/D) rho v^2 / 2; both in SI.
TEST(PressureDrop, RegimeEqualsTheTextbookInCylinders) {
    const Fluid fluid = pure(blood());
    const double radius_m = 2e-3;
    const double length_m = 0.05;
    const auto flow_at = [&](double re) { return re * 3.14159265358979 * radius_m * 3.5e-3 / 2.0; };
    const double slow_kg_s = flow_at(500);
    const double slow =
        8 * 3.5e-3 * length_m * slow_kg_s / 1060 / (3.14159265358979 * std::pow(radius_m, 4));
    EXPECT_NEAR(
        total_pressure_drop(PressureLaw::regime, {2, 2, 50}, fluid, slow_kg_s * 1e3).pressure_pa /
            slow,
        1.0, 1e-12);
    const double fast_kg_s = flow_at(1e5);
    const double speed = fast_kg_s / (1060 * 3.14159265358979 * radius_m * radius_m);
    const double fast =
        0.316 / std::pow(1e5, 0.25) * length_m / (2 * radius_m) * 1060 * speed * speed / 2;
    EXPECT_NEAR(
        total_pressure_drop(PressureLaw::regime, {2, 2, 50}, fluid, fast_kg_s * 1e3).pressure_pa /
            fast,
        1.0, 1e-12);
}

// Cutting a cone in two must not change its drop, except under `published`, whose flux is not
// local.
TEST(PressureDrop, AddsUpOverTheTwoHalvesOfACone) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Cone cone = random_cone(random);
        const double share = random.uniform(0.01, 0.99);
        const double middle =
            cone.proximal_radius_mm + share * (cone.distal_radius_mm - cone.proximal_radius_mm);
        const Cone first{cone.proximal_radius_mm, middle, share * cone.length_mm};
        const Cone second{middle, cone.distal_radius_mm, (1.0 - share) * cone.length_mm};
        const Fluid fluid = random_fluid(random);
        const double m = random.logarithmic(1e-6, 100.0);
        for (const PressureLaw law : {PressureLaw::consistent, PressureLaw::regime}) {
            const double whole = static_pressure_drop_pa(law, cone, fluid, m);
            const double halves = static_pressure_drop_pa(law, first, fluid, m) +
                                  static_pressure_drop_pa(law, second, fluid, m);
            const double size =
                total_pressure_drop(law, cone, fluid, m).pressure_pa +
                dynamic_pressure_pa(std::min(cone.proximal_radius_mm, cone.distal_radius_mm), fluid,
                                    m);
            ASSERT_NEAR(whole, halves, 1e-11 * size);
        }
    }
}

TEST(PressureDrop, IsFiniteAtTheExtremes) {
    for (const double void_fraction : {0.0, 1e-12, 0.4, 0.999})
        for (const double r1 : {1e-9, 1e-6, 1.0, 1e6})
            for (const double r2 : {1e-9, 1e-6, 1.0, 1e6})
                for (const double length : {0.0, 1e-12, 1e9})
                    for (const double m : {0.0, -2.0, 1e-300, 1e15, -1e15})
                        for (const PressureLaw law : laws) {
                            const Fluid fluid = mixture(blood(), gas(), void_fraction);
                            const Drop drop = total_pressure_drop(law, {r1, r2, length}, fluid, m);
                            ASSERT_TRUE(std::isfinite(drop.pressure_pa));
                            ASSERT_TRUE(std::isfinite(drop.slope_pa_s_g));
                            ASSERT_TRUE(std::isfinite(
                                static_pressure_drop_pa(law, {r1, r2, length}, fluid, m)));
                            if (length == 0.0) {
                                ASSERT_EQ(drop.pressure_pa, 0.0);
                            }
                        }
}

TEST(PressureDrop, RefusesWhatItCannotAnswer) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, 1e-10, 1e7, nan, infinity}) {
        EXPECT_THROW(validate(Cone{bad, 1.0, 1.0}), InputError);
        EXPECT_THROW(validate(Cone{1.0, bad, 1.0}), InputError);
    }
    for (const double bad : {-1.0, 1e10, nan, infinity})
        EXPECT_THROW(validate(Cone{1.0, 1.0, bad}), InputError);
    for (const double bad : {1e16, -infinity, nan})
        EXPECT_THROW(validate_mass_flow(bad), InputError);
    EXPECT_NO_THROW(validate(Cone{1e-9, 1e6, 0.0}));
    EXPECT_THROW(pressure_law("laminar"), InputError);
    for (const PressureLaw law : laws) EXPECT_EQ(pressure_law(name_of(law)), law);
}

}  // namespace
}  // namespace hepatica
