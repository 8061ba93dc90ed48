// SPDX-License-Identifier: GPL-3.0-or-later
// An inlet whose pressure is given, where a vessel is torn: in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/flow/injection.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::make_tree;

// A pressure p at the open end of a tube: q = 0.6 A sqrt(2 p / rho) leaves there, and the rest runs
// through the tube. At an end with a bed of resistance R it is p / R.
TEST(PressureAtATear, FeedsTheOpeningTooAndABed) {
    FlowNetwork network;
    network.node_count = 2;
    network.root_nodes = {0};
    network.outlet_nodes = {1};
    network.cones = {{1.0, 1.0, 20.0}};
    network.segments = {{0, 1, 0, 1, 0}};
    FlowConditions conditions;
    conditions.resident = pure(blood());
    conditions.inlets = {{0, InletKind::pressure, 200.0, conditions.resident}};
    const double whole = solve_flow(network, conditions).inlet_flow_mm3_s[0];
    tear(network, {0, 0.0, 0.0});
    ASSERT_EQ(network.torn_nodes, std::vector<int>{0});
    EXPECT_THROW(solve_flow(network, conditions), InputError) << "nothing holds the flow up";
    conditions.torn_areas_mm2 = {3.0};
    const FlowSolution torn = solve_flow(network, conditions);
    const double q = 0.6 * 3.0 * std::sqrt(2.0 * 200.0 / conditions.resident.density_g_mm3);
    EXPECT_NEAR(torn.torn_flow_mm3_s[0], q, 1e-6 * q);
    EXPECT_NEAR(torn.outlet_flow_mm3_s[0], whole, 1e-9 * whole);
    EXPECT_NEAR(torn.inlet_flow_mm3_s[0], q + whole, 1e-6 * q);
    EXPECT_LE(torn.mass_error_relative, 1e-12);
    // The other end, with a bed: nothing flows back through the tube, whose root is closed.
    network.torn_nodes.clear();
    conditions.torn_areas_mm2.clear();
    conditions.inlets[0].node = 1;
    conditions.terminal_resistances = {4.0};
    const FlowSolution bed = solve_flow(network, conditions);
    EXPECT_NEAR(bed.outlet_flow_mm3_s[0], 50.0, 1e-9);
    EXPECT_NEAR(bed.inlet_flow_mm3_s[0], 50.0, 1e-9);
    EXPECT_LE(bed.mass_error_relative, 1e-12);
}

// By a pressure, into the open stump of a branch that was torn off its fork: from the first moment
// drug bleeds there, as the opening lets it.
TEST(PressureAtATear, LetsTheDrugBleedFromTheStump) {
    InjectionOptions options;
    options.tip = TreePoint{1, 0.0, 0.0};
    options.wedged = false;
    options.inlet_pressure_pa = 200.0;
    options.until_s = 0.1;
    options.tears = {{1, 0.0, 0.0}};
    Job job;
    EXPECT_THROW(inject(make_tree(71, 2), options, job), InputError);
    options.tear_areas_mm2 = {3.0};
    const InjectionResult result = inject(make_tree(71, 2), options, job);
    const double bled_mm3_s = 0.6 * 3.0 * std::sqrt(2.0 * 200.0 / result.drug.density_g_mm3);
    EXPECT_NEAR(result.balance.bled_mm3, 0.1 * bled_mm3_s, 1e-5 * bled_mm3_s);
    EXPECT_GT(result.balance.inside_mm3, 0.0);
    EXPECT_LE(result.balance.error_relative(), 1e-11);
}

}  // namespace
}  // namespace hepatica
