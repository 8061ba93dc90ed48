// SPDX-License-Identifier: GPL-3.0-or-later
// An audited ledger notices a force that is not the gradient of the energy which is booked: of
// every element, in each way that it is evaluated and in each branch it has, and of every
// potential, contact among them. What is measured here says how sensitive it is: 1 % of a force
// would leave at least ten times as much open as is allowed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/deform/step/backward_euler.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/element_choice.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

using test::random_field;

constexpr double allowed = 1e-5;  // of the energies handled, beside the quadrature's own error

struct AuditedChoice : test::ElementChoice {
    int newton_iterations;       // 1: rotated stiffness, else projected
    bool two_materials = false;  // of two Poisson's ratios: no factors
};

Body brick(const AuditedChoice& choice, double tether = 0.0) {
    BodyDescription d;
    const Vec3 size(30, 20, 20);
    if (choice.hexahedra) {
        const HexMesh mesh = hexahedral_brick(size, {3, 2, 2});
        d.mesh.vertices_mm = mesh.vertices_mm;
        d.hexahedra = mesh.hexahedra;
    } else {
        d.mesh = kuhn_brick(size, {3, 2, 2});
    }
    d.material = {.young_modulus_pa = 1e4, .poisson_ratio = 0.42, .density_g_mm3 = 1e-3};
    d.tether_pa_per_mm2 = tether;
    Body body = build_body(d, choice.model, choice.order);
    if (choice.two_materials) body.groups[0].tetrahedra[0].lambda *= 1.1;
    return body;
}

// A body that is let go out of shape and in random motion.
BodyState start_of(const Body& body, const Vec3& stretch, unsigned seed) {
    const std::size_t nodes = body.rest_positions_mm.size();
    const auto noise = random_field(nodes, 0.5, seed);
    BodyState state{body.rest_positions_mm, random_field(nodes, 50.0, seed + 1)};
    for (std::size_t i = 0; i < nodes; ++i)
        state.positions_mm[i] = (state.positions_mm[i] + noise[i]).cwiseProduct(stretch);
    return state;
}

// Steps with an audit; returns the largest change in a step of what `term` measures, in what was
// handled.
template <class Term>
double largest_change(BackwardEuler& integrator, BodyState& state, const PotentialList& potentials,
                      double dt_s, int steps, const Term& term, double first) {
    double largest = 0.0, before = first;
    for (int i = 0; i < steps; ++i) {
        const StepReport report = integrator.advance(state, dt_s, potentials);
        const double handled = energy_handled(report.energy);
        EXPECT_LT(report.audit_error_nj, allowed * handled) << "step " << i;
        EXPECT_LT(std::abs(report.energy.imbalance), allowed * handled) << "step " << i;
        largest = std::max(largest, std::abs(term(report.energy) - before) / handled);
        before = term(report.energy);
    }
    return largest;
}

class AuditedElement : public testing::TestWithParam<AuditedChoice> {};

TEST_P(AuditedElement, ForcesAreTheGradientOfWhatIsBooked) {
    const AuditedChoice& choice = GetParam();
    const Body body = brick(choice);
    struct Shape {
        const char* name;
        Vec3 stretch;
    };
    for (const Shape& shape :
         {Shape{"near rest", Vec3(1, 1, 1)}, Shape{"crushed", Vec3(1, 1, 0.15)},
          Shape{"inverted", Vec3(1, 1.2, -0.5)}, Shape{"stretched", Vec3(3, 2, 2.5)}}) {
        SCOPED_TRACE(shape.name);
        const PotentialList none(body);
        BackwardEuler integrator(body,
                                 {.iterations = choice.newton_iterations,
                                  .linear = {.energy_tolerance = 1e-6},
                                  .audit = true},
                                 make_block_jacobi_solver());
        BodyState state = start_of(body, shape.stretch, 3);
        const double elastic = integrator.elastic_energy(state.positions_mm);
        const double change = largest_change(
            integrator, state, none, 5e-4, 6,
            [](const EnergyLedger& ledger) { return ledger.elastic; }, elastic);
        EXPECT_GT(0.01 * change, 10.0 * allowed);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, AuditedElement,
    testing::Values(
        AuditedChoice{{"spring", ElementModel::spring, ElementOrder::linear, false}, 1},
        AuditedChoice{
            {"corotated_in_factors", ElementModel::corotated, ElementOrder::linear, false}, 1},
        AuditedChoice{
            {"corotated_in_lanes", ElementModel::corotated, ElementOrder::linear, false}, 1, true},
        AuditedChoice{{"corotated_projected", ElementModel::corotated, ElementOrder::linear, false},
                      4},
        AuditedChoice{
            {"corotated10_in_lanes", ElementModel::corotated, ElementOrder::quadratic, false}, 1},
        AuditedChoice{
            {"corotated10_projected", ElementModel::corotated, ElementOrder::quadratic, false}, 4},
        AuditedChoice{{"neohookean", ElementModel::neohookean, ElementOrder::linear, false}, 4},
        AuditedChoice{{"neohookean10", ElementModel::neohookean, ElementOrder::quadratic, false},
                      4},
        AuditedChoice{{"hexahedron", ElementModel::corotated, ElementOrder::linear, true}, 1},
        AuditedChoice{{"hexahedron_newton", ElementModel::corotated, ElementOrder::linear, true},
                      4}),
    [](const auto& test) { return std::string(test.param.name); });

struct Pull {
    const char* name;
    double EnergyLedger::*term;
    double tether_pa_per_mm2;
    Vec3 displaced_mm;
    Vec3 gravity_mm_per_s2;
    double grab_limit_un;  // 0: none
};

// One potential at a time, in charge of a soft body: weight, tissue, a grab within its limit and
// one beyond it.
TEST(AuditedPotential, ForcesAreTheGradientOfWhatIsBooked) {
    const AuditedChoice choice{{"", ElementModel::corotated, ElementOrder::linear, false}, 1};
    const Vec3 none = Vec3::Zero();
    for (const Pull& pull :
         {Pull{"weight", &EnergyLedger::gravity_work, 0.0, none, Vec3(1e4, -2e4, 3e4), 0.0},
          Pull{"tissue", &EnergyLedger::tether, 10.0, Vec3(5, -3, 2), none, 0.0},
          Pull{"grab within", &EnergyLedger::grab, 0.0, none, none, 1e9},
          Pull{"grab beyond", &EnergyLedger::grab, 0.0, none, none, 5e4}}) {
        SCOPED_TRACE(pull.name);
        const Body body = brick(choice, pull.tether_pa_per_mm2);
        PotentialList potentials(body);
        potentials.set_gravity(pull.gravity_mm_per_s2);
        Grab grab{.vertices = {3, 4, 7, -1}, .weights = {0.5, 0.3, 0.2, 0.0}};
        grab.target_mm = Vec3(70, 30, -20);
        grab.stiffness_un_per_mm = 2e3;
        grab.force_limit_un = pull.grab_limit_un;
        if (pull.grab_limit_un > 0.0) potentials.set_grabs(std::span(&grab, 1));
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
        for (Vec3& x : state.positions_mm) x += pull.displaced_mm;
        EnergyLedger first;
        potentials.book(state.positions_mm, state.positions_mm, first);
        BackwardEuler integrator(body, {.linear = {.energy_tolerance = 1e-6}, .audit = true},
                                 make_block_jacobi_solver());
        const double change = largest_change(
            integrator, state, potentials, 2e-3, 20,
            [&](const EnergyLedger& ledger) { return ledger.*pull.term; }, first.*pull.term);
        EXPECT_GT(0.01 * change, 10.0 * allowed);
    }
}

// What is stored in pads, or taken by friction, in the course of the steps of a body that is
// pressed against something when it is let go.
struct Touch {
    double largest_change = 0.0;  // of the energy in a step, in what was handled
    int touched = 0;              // steps
};

template <class Taken>
Touch audit_touching(const Body& body, BodyState state, const PotentialList& potentials,
                     double dt_s, int steps, const Taken& taken) {
    BackwardEuler integrator(body, {.linear = {.energy_tolerance = 1e-6}, .audit = true},
                             make_block_jacobi_solver());
    EnergyLedger before;
    potentials.book(state.positions_mm, state.positions_mm, before);
    Touch touch;
    for (int i = 0; i < steps; ++i) {
        const StepReport report = integrator.advance(state, dt_s, potentials);
        potentials.end_step();
        const double handled = energy_handled(report.energy);
        EXPECT_LT(report.audit_error_nj, allowed * handled) << "step " << i;
        EXPECT_LT(std::abs(report.energy.imbalance), allowed * handled) << "step " << i;
        touch.largest_change =
            std::max(touch.largest_change, std::abs(taken(before, report.energy)) / handled);
        touch.touched += report.tool.contacts + report.self.contacts > 0 ? 1 : 0;
        before = report.energy;
    }
    return touch;
}

double from_pads(const EnergyLedger& before, const EnergyLedger& after) {
    return after.contact - before.contact;
}

// A ball or a capsule that stands in for a finger: the brick springs away from it.
TEST(AuditedContact, AToolsPadIsTheGradientOfWhatIsBooked) {
    BodyDescription description;
    description.mesh = kuhn_brick(Vec3(12, 12, 6), {4, 4, 2});
    description.material = {.young_modulus_pa = 1e4, .poisson_ratio = 0.42, .density_g_mm3 = 1e-3};
    description.touchable = true;
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    for (const bool capsule : {false, true}) {
        SCOPED_TRACE(capsule ? "capsule" : "ball");
        Tool tool =
            single_tool({.centre_mm = Vec3(6.3, 5.6, 6.0 + 4.0 + 0.4),
                         .half_axis_mm = capsule ? Vec3(2.5, 1.0, 0.05) : Vec3(Vec3::Zero()),
                         .radius_mm = 4.0});
        tool.pad_mm = 1.0;
        tool.pressure_pa = 3e4;
        tool.target_mm = tool.centre_mm();
        PotentialList potentials(body);
        potentials.set_tool(tool);
        const BodyState state{body.rest_positions_mm,
                              std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
        const Touch touch = audit_touching(body, state, potentials, 1e-4, 20, from_pads);
        EXPECT_GT(touch.touched, 5);
        EXPECT_GT(0.01 * touch.largest_change, 10.0 * allowed);
    }
}

// The brick slides along under a tool that was led aside.
TEST(AuditedContact, AToolsFrictionTakesWhatIsBooked) {
    BodyDescription description;
    description.mesh = kuhn_brick(Vec3(12, 12, 6), {4, 4, 2});
    description.material = {.young_modulus_pa = 1e5, .poisson_ratio = 0.42, .density_g_mm3 = 1e-3};
    description.touchable = true;
    description.fixed.assign(description.mesh.vertices_mm.size(), 0);
    for (std::size_t v = 0; v < description.fixed.size(); ++v)
        description.fixed[v] = description.mesh.vertices_mm[v].z() < 0.1 ? 1 : 0;
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    Tool tool = single_tool({.centre_mm = Vec3(6.3, 5.6, 6.0 + 4.0 + 0.5), .radius_mm = 4.0});
    tool.pad_mm = 1.0;
    tool.pressure_pa = 3e4;
    tool.friction = 0.8;
    tool.target_mm = tool.centre_mm();
    PotentialList potentials(body);
    potentials.set_tool(tool);
    BodyState state{body.rest_positions_mm, std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
    for (std::size_t v = 0; v < description.fixed.size(); ++v)
        state.velocities_mm_per_s[v].x() = 30.0 * body.rest_positions_mm[v].z();
    const auto by_friction = [](const EnergyLedger&, const EnergyLedger& after) {
        return after.friction_loss - after.tool_work;
    };
    const Touch touch = audit_touching(body, state, potentials, 1e-4, 20, by_friction);
    EXPECT_GT(touch.touched, 10);
    EXPECT_GT(0.01 * touch.largest_change, 10.0 * allowed);
}

// Two bars that are let go pressed against each other: across, and so nearly along each other that
// edges are parallel and their pads fade out.
TEST(AuditedContact, ThePadsBetweenSurfacesAreTheGradientOfWhatIsBooked) {
    for (const double angle_rad : {1.4, 0.02}) {
        SCOPED_TRACE(angle_rad);
        BodyDescription bars = test::crossed_bars(1.0, angle_rad);
        bars.material.damping_ratio = 0.0;
        const Body body = build_body(bars, ElementModel::corotated, ElementOrder::linear);
        const PotentialList potentials(body);
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
        for (std::size_t i = body.mass_g.size() / 2; i < body.mass_g.size(); ++i)
            state.positions_mm[i].z() -= 0.85;
        const Touch touch = audit_touching(body, state, potentials, 1e-4, 20, from_pads);
        EXPECT_GT(touch.touched, 0);
        EXPECT_GT(0.01 * touch.largest_change, 10.0 * allowed);
    }
}

// Without an audit the nonlinear loss is what the energies say; with one it is what the forces say.
// Both see the same motion.
TEST(Audit, ChangesNothingButTheNonlinearLossAndThatByRoundingOnly) {
    const Body body = brick({{"", ElementModel::corotated, ElementOrder::linear, false}, 1});
    const PotentialList none(body);
    BodyState plain = start_of(body, Vec3(1, 1, 1), 5), audited = plain;
    const NewtonSettings settings{.linear = {.energy_tolerance = 1e-6}};
    NewtonSettings with_audit = settings;
    with_audit.audit = true;
    BackwardEuler one(body, settings, make_block_jacobi_solver());
    BackwardEuler other(body, with_audit, make_block_jacobi_solver());
    double largest = 0.0;
    for (int i = 0; i < 10; ++i) {
        const EnergyLedger a = one.advance(plain, 1e-3, none).energy;
        const EnergyLedger b = other.advance(audited, 1e-3, none).energy;
        EXPECT_EQ(plain.positions_mm, audited.positions_mm);
        EXPECT_EQ(plain.velocities_mm_per_s, audited.velocities_mm_per_s);
        EXPECT_EQ(a.integrator_loss, b.integrator_loss);
        EXPECT_NEAR(a.nonlinear_loss, b.nonlinear_loss, 1e-6 * energy_handled(a));
        largest = std::max(largest, std::abs(a.nonlinear_loss) / energy_handled(a));
    }
    EXPECT_GT(largest, 1e-5);
}

// Of higher order in the step than the motion itself: over the same time, steps half as long lose
// less than half.
TEST(Audit, NonlinearLossFallsWithTheStep) {
    const Body body = brick({{"", ElementModel::neohookean, ElementOrder::linear, false}, 1});
    const PotentialList none(body);
    double before = 0.0;
    for (const int steps : {10, 20, 40}) {
        BackwardEuler integrator(
            body, {.iterations = 20, .tolerance = 1e-9, .linear = {.energy_tolerance = 1e-9}},
            make_block_jacobi_solver());
        BodyState state = start_of(body, Vec3(1, 1, 1), 5);
        double loss = 0.0;
        for (int i = 0; i < steps; ++i)
            loss += std::abs(integrator.advance(state, 2e-3 / steps, none).energy.nonlinear_loss);
        if (before > 0.0) {
            EXPECT_LT(loss, 0.35 * before) << steps << " steps";
        }
        before = loss;
    }
}

}  // namespace
}  // namespace hepatica
