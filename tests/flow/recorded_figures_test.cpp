// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the laws, networks and steady flows as they are today.
#include <gtest/gtest.h>

#include <limits>

#include "core/flow/flow_export.h"
#include "core/flow/flow_shares.h"
#include "core/flow/territory.h"
#include "tests/flow/figures.h"

namespace hepatica {
namespace {

using namespace testing_flow;
using test::expect_recorded;
using test::Figures;

constexpr std::array every_law = {PressureLaw::published, PressureLaw::consistent,
                                  PressureLaw::regime};

TEST(FlowFigures, OfThePressureLaws) {
    Figures figures;
    for (const PressureLaw law : every_law) {
        Random random(901);
        std::vector<double> numbers;
        for (int i = 0; i < 300; ++i) {
            const Cone cone = random_cone(random);
            const Fluid fluid = random_fluid(random);
            const double flow = (i % 2 ? 1.0 : -1.0) * laminar_limit_g_s(cone, fluid) *
                                random.logarithmic(0.1, 30.0);
            const Drop drop = total_pressure_drop(law, cone, fluid, flow);
            const Drop loss = bifurcation_loss(0.7, cone, fluid, flow);
            const DropCoefficients c = drop_coefficients(law, cone, fluid);
            // Of equal weight, whatever their sizes are.
            for (const double value :
                 {drop.pressure_pa, drop.slope_pa_s_g, loss.pressure_pa, loss.slope_pa_s_g,
                  static_pressure_drop_pa(law, cone, fluid, flow),
                  frictional_drop(law, cone, fluid, flow).pressure_pa,
                  kinematic_drop(cone, fluid, flow).pressure_pa, c.linear, c.power,
                  reynolds_number(cone.distal_radius_mm, fluid, flow),
                  bubbly_reynolds_number(cone.distal_radius_mm, fluid, flow)})
                numbers.push_back(std::copysign(std::log1p(std::abs(value)), value));
        }
        figures.add(name_of(law), numbers);
    }
    expect_recorded("flow", "laws", figures);
}

TEST(FlowFigures, OfSteadyFlow) {
    Figures figures;
    for (const PressureLaw law : every_law)
        for (const int loops : {0, 6}) {
            Random random(902);
            FlowNetwork network = random_tree(random, 40, 1.8);
            add_loops(random, network, loops);
            divide(network, {3, 0.4 * length_mm(network, 3), 0.0});
            tear(network, {7, 0.3 * length_mm(network, 7), 0.0});
            const int tip = place_catheter(network, {2, 1.0, 0.0}, false);
            set_open(network, 11, false);
            FlowConditions conditions;
            conditions.law = law;
            conditions.resident = mixture(blood(), lipiodol(), 0.1);
            conditions.inlets = {{0, InletKind::pressure, 9000.0, pure(blood())},
                                 {tip, InletKind::mass_flow, 0.8, pure(gas())},
                                 {tip, InletKind::mass_flow, 0.3, pure(carrier())}};
            conditions.outlet_pressure_pa = 400.0;
            conditions.ambient_pressure_pa = 150.0;
            conditions.bifurcation_loss_coefficient = 0.6;
            if (law != PressureLaw::published)
                conditions.terminal_resistances = murray_terminal_resistances(network, 0.2, 2.7);
            if (law == PressureLaw::regime) {
                conditions.torn_areas_mm2.assign(network.torn_nodes.size(), 0.4);
                for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o)
                    conditions.outlet_pressures_pa.push_back(300.0 + 7.0 * static_cast<double>(o));
                conditions.terminal_resistances[1] = std::numeric_limits<double>::infinity();
                conditions.terminal_resistances[2] = 0.0;
            }
            const std::string name = name_of(law) + std::to_string(loops);
            const FlowSolution solution = solve_flow(network, conditions);
            add_network(figures, name + ".network", network);
            add_solution(figures, name, solution);
            figures.add(name + ".newton", solution.newton_steps);
            add_arrivals(figures, name + ".arrivals", network,
                         arrival_times(network, solution, {0, tip}));
            std::vector<double> numbers;
            for (const int segment : {0, 2, 5}) {
                const Territory territory = territory_of(network, solution, {segment, 0.5, 0.0});
                numbers.insert(numbers.end(), territory.passed_share.begin(),
                               territory.passed_share.end());
                numbers.insert(numbers.end(), territory.outlets.begin(), territory.outlets.end());
                numbers.insert(numbers.end(), territory.outlet_shares.begin(),
                               territory.outlet_shares.end());
                numbers.insert(numbers.end(), {territory.begins_mm, territory.share_of_flow,
                                               territory.share_of_outflow, territory.flow_mm3_s,
                                               territory.volume_mm3});
            }
            figures.add(name + ".territories", numbers);
        }
    expect_recorded("flow", "steady", figures);
}

// As the drug front uses it: fillings that cut cones anywhere, and a driving value that changes.
TEST(FlowFigures, OfFilledSegments) {
    Figures figures;
    const VesselTree tree = uneven_tree(903, 3);
    const FlowNetwork network = network_of(tree, SegmentShape::centreline);
    add_network(figures, "centreline", network);
    add_network(figures, "one_cone", network_of(tree));
    FlowConditions conditions;
    conditions.bifurcation_loss_coefficient = 0.5;
    conditions.inlets = {{0, InletKind::mass_flow, 3.0, pure(blood())}};
    NetworkFlow flow(network, conditions);
    add_solution(figures, "begin", flow.solve());
    for (int s = 0; s < static_cast<int>(network.segments.size()); s += 2) {
        const double volume = volume_mm3(network, s);
        flow.fill(s, {{0.3 * volume, pure(lipiodol())},
                      {0.25 * volume, pure(gas())},
                      {0.45 * volume, conditions.resident}});
    }
    add_solution(figures, "filled", flow.solve());
    flow.drive(0, 1.1);
    add_solution(figures, "slower", flow.solve());
    figures.add("shares", flow_shares(tree));
    std::vector<double> numbers;
    for (int s = 0; s < static_cast<int>(network.segments.size()); ++s) {
        const SegmentPressures pressures =
            static_pressures(network, flow.solution(), conditions.resident, s);
        numbers.insert(numbers.end(),
                       {pressures.proximal_static_pa, pressures.distal_static_pa,
                        smallest_radius_mm(network, s), volume_up_to_mm3(network, s, 2.3),
                        arclength_at_mm(network, s, 0.4 * volume_mm3(network, s)),
                        proximal_radius_mm(network, s), distal_radius_mm(network, s)});
    }
    figures.add("segments", numbers);
    expect_recorded("flow", "filled", figures);
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(FlowFigures, OfTheSvZeroDModel) {
    Figures figures;
    for (const bool resistive : {false, true}) {
        Random random(904);
        FlowNetwork network = random_tree(random, 12);
        tear(network, {4, 0.5 * length_mm(network, 4), 0.0});
        const int tip = place_catheter(network, {1, 1.0, 0.0}, false);
        set_open(network, 6, false);
        FlowConditions conditions;
        conditions.law = resistive ? PressureLaw::regime : PressureLaw::consistent;
        conditions.bifurcation_loss_coefficient = resistive ? 0.5 : 0.0;
        conditions.outlet_pressure_pa = 200.0;
        conditions.ambient_pressure_pa = 30.0;
        conditions.inlets = {{0, InletKind::pressure, 4000.0, pure(blood())},
                             {tip, InletKind::mass_flow, 0.5, pure(lipiodol())}};
        if (resistive) {
            conditions.terminal_resistances = murray_terminal_resistances(network, 0.1);
            conditions.terminal_resistances[0] = 0.0;
            conditions.terminal_resistances[1] = std::numeric_limits<double>::infinity();
        } else {
            for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o)
                conditions.outlet_pressures_pa.push_back(10.0 * static_cast<double>(o));
        }
        figures.add(resistive ? "resistive" : "pressures",
                    bytes_of(svzerod_json(network, conditions)));
    }
    expect_recorded("flow", "svzerod", figures);
}

}  // namespace
}  // namespace hepatica
