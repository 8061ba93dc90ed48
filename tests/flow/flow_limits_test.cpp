// SPDX-License-Identifier: GPL-3.0-or-later
// Options at the ends of their ranges: the end itself is taken, what lies beyond it is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/base/error.h"
#include "core/flow/embolization.h"
#include "core/flow/injection.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::make_tree;
using testing_flow::Random;
using testing_flow::random_tree;

// What lies beyond an end by a part in a thousand million.
double above(double value) {
    return value == 0.0 ? 1e-300 : value + 1e-9 * std::abs(value);
}
double below(double value) {
    return value == 0.0 ? -1e-300 : value - 1e-9 * std::abs(value);
}

void expect_range(const char* what, double low, double high,
                  const std::function<void(double)>& check) {
    for (const double value : {low, high}) EXPECT_NO_THROW(check(value)) << what << " " << value;
    EXPECT_THROW(check(below(low)), InputError) << what;
    if (std::isfinite(high)) {
        EXPECT_THROW(check(above(high)), InputError) << what;
    }
    EXPECT_THROW(check(std::nan("")), InputError) << what;
}

TEST(FlowLimits, OfAFluid) {
    expect_range("density", 1e-9, 1.0, [](double value) { validate(Fluid{value, 3.5e-3, 0.0}); });
    expect_range("viscosity", 1e-9, 1e6, [](double value) { validate(Fluid{1e-3, value, 0.0}); });
    expect_range("void fraction", 0.0, std::nextafter(1.0, 0.0), [](double value) {
        validate(Fluid{1e-3, 3.5e-3, value});
        mixture(blood(), gas(), value);
    });
    EXPECT_THROW(validate(Fluid{1e-3, 3.5e-3, 1.0}), InputError);
    EXPECT_THROW(mixture(blood(), gas(), 1.0), InputError);
    Phase broken = blood();
    broken.density_g_mm3 = 0.0;
    EXPECT_THROW(mixture(broken, gas(), 0.5), InputError);
    EXPECT_THROW(mixture(blood(), broken, 0.5), InputError);
}

TEST(FlowLimits, OfAConeAndItsFlow) {
    expect_range("proximal radius", 1e-9, 1e6, [](double value) {
        validate(Cone{value, 1.0, 1.0});
    });
    expect_range("distal radius", 1e-9, 1e6, [](double value) { validate(Cone{1.0, value, 1.0}); });
    expect_range("length", 0.0, 1e9, [](double value) { validate(Cone{1.0, 1.0, value}); });
    expect_range("mass flow", -1e15, 1e15, [](double value) { validate_mass_flow(value); });
}

TEST(FlowLimits, OfConditions) {
    Random random(921);
    FlowNetwork network = random_tree(random, 7);
    tear(network, {3, 0.5 * length_mm(network, 3), 0.0});
    FlowConditions good;
    good.inlets = {{0, InletKind::pressure, 5000.0, pure(blood())}};
    const auto with = [&](auto change) {
        return [&network, good, change](double value) {
            FlowConditions conditions = good;
            change(conditions, value);
            NetworkFlow flow(network, conditions);
        };
    };
    expect_range("outlet pressure", -1e12, 1e12,
                 with([](FlowConditions& c, double v) { c.outlet_pressure_pa = v; }));
    expect_range("ambient pressure", -1e12, 1e12,
                 with([](FlowConditions& c, double v) { c.ambient_pressure_pa = v; }));
    expect_range("inlet pressure", -1e12, 1e12,
                 with([](FlowConditions& c, double v) { c.inlets[0].value = v; }));
    expect_range("loss", 0.0, 1e3,
                 with([](FlowConditions& c, double v) { c.bifurcation_loss_coefficient = v; }));
    const std::size_t outlets = network.outlet_nodes.size();
    expect_range("resistance", 0.0, 1e30, with([=](FlowConditions& c, double v) {
                     c.terminal_resistances.assign(outlets, 0.1);
                     c.terminal_resistances[1] = v;
                 }));
    expect_range("pressures", -1e12, 1e12, with([=](FlowConditions& c, double v) {
                     c.outlet_pressures_pa.assign(outlets, 10.0);
                     c.outlet_pressures_pa[1] = v;
                 }));
    const std::size_t torn = network.torn_nodes.size();
    const auto opening = with([=](FlowConditions& c, double v) {
        c.torn_areas_mm2.assign(torn, 1.0);
        c.torn_areas_mm2[1] = v;
    });
    EXPECT_NO_THROW(opening(1e-9));
    for (const double wrong : {0.0, -1.0, HUGE_VAL, std::nan("")})
        EXPECT_THROW(opening(wrong), InputError) << wrong;
    for (const std::size_t wrong : {std::size_t{1}, outlets - 1, outlets + 1}) {
        EXPECT_THROW(with([=](FlowConditions& c, double) {
                         c.terminal_resistances.assign(wrong, 0.1);
                     })(0.0),
                     InputError);
        EXPECT_THROW(
            with([=](FlowConditions& c, double) { c.outlet_pressures_pa.assign(wrong, 0.1); })(0.0),
            InputError);
    }
    EXPECT_THROW(
        with([=](FlowConditions& c, double) { c.torn_areas_mm2.assign(torn + 1, 1.0); })(0.0),
        InputError);
}

TEST(FlowLimits, OfAnInletsNode) {
    Random random(921);
    const FlowNetwork network = random_tree(random, 7);
    const auto inlet_at = [&](int node) {
        FlowConditions conditions;
        conditions.inlets = {{node, InletKind::pressure, 5000.0, pure(blood())}};
        NetworkFlow flow(network, conditions);
    };
    EXPECT_NO_THROW(inlet_at(0));
    EXPECT_NO_THROW(inlet_at(network.node_count - 1));
    EXPECT_THROW(inlet_at(-1), InputError);
    EXPECT_THROW(inlet_at(network.node_count), InputError);
}

TEST(FlowLimits, OfTheTotalResistance) {
    Random random(921);
    const FlowNetwork network = random_tree(random, 7);
    EXPECT_NO_THROW(murray_terminal_resistances(network, 1e-300));
    EXPECT_NO_THROW(murray_terminal_resistances(network, 1e12));
    EXPECT_THROW(murray_terminal_resistances(network, above(1e12)), InputError);
    EXPECT_THROW(murray_terminal_resistances(network, 0.0), InputError);
    double conductance = 0.0;  // all in parallel are the total
    for (const double r : murray_terminal_resistances(network, 0.25)) conductance += 1.0 / r;
    EXPECT_NEAR(conductance, 4.0, 1e-12);
}

TEST(FlowLimits, OfANetwork) {
    Random random(922);
    const FlowNetwork good = random_tree(random, 3);
    const auto refused = [&](auto change) {
        FlowNetwork network = good;
        change(network);
        EXPECT_THROW(validate(network), InputError);
    };
    EXPECT_NO_THROW(validate(good));
    refused([](FlowNetwork& n) { n.segments[1].proximal_node = -1; });
    refused([](FlowNetwork& n) { n.segments[1].proximal_node = n.node_count; });
    refused([](FlowNetwork& n) { n.segments[1].distal_node = -1; });
    refused([](FlowNetwork& n) { n.segments[1].distal_node = n.node_count; });
    refused([](FlowNetwork& n) { n.segments[1].distal_node = n.segments[1].proximal_node; });
    refused([](FlowNetwork& n) { n.segments[1].cone_count = 0; });
    refused([](FlowNetwork& n) { n.segments[1].first_cone = -1; });
    refused([](FlowNetwork& n) { n.segments[2].cone_count = 2; });
    refused([](FlowNetwork& n) { n.cones[2].length_mm = -1.0; });
    refused([](FlowNetwork& n) { n.root_nodes.push_back(n.node_count); });
    refused([](FlowNetwork& n) { n.outlet_nodes.push_back(-1); });
    refused([](FlowNetwork& n) { n.torn_nodes.push_back(n.node_count); });
    FlowNetwork last = good;
    last.torn_nodes = {0, last.node_count - 1};
    EXPECT_NO_THROW(validate(last));
}

// Beside a node the node itself is meant.
TEST(FlowLimits, APointNextToANodeDividesNothing) {
    FlowNetwork good;
    good.node_count = 2;
    good.cones = {{1.0, 0.5, 10.0}};
    good.segments = {{0, 1, 0, 1, 0}};
    const auto divided = [&](double at_mm) {
        FlowNetwork network = good;
        const int node = divide(network, {0, at_mm, 0.0});
        EXPECT_EQ(network.segments.size(), node < 2 ? 1u : 2u);
        return node;
    };
    EXPECT_EQ(divided(0.99e-6), 0);
    EXPECT_EQ(divided(1.01e-6), 2);
    EXPECT_EQ(divided(10.0 - 1.01e-6), 2);
    EXPECT_EQ(divided(10.0 - 0.99e-6), 1);
    good.cones[0].length_mm = 1e5;
    EXPECT_EQ(divided(0.99e-4), 0);
    EXPECT_EQ(divided(1.01e-4), 2);
}

TEST(FlowLimits, OfAnEmbolization) {
    Random random(923);
    const FlowNetwork network = random_tree(random, 5);
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::pressure, 5000.0, pure(blood())}};
    conditions.terminal_resistances = murray_terminal_resistances(network, 0.05);
    EmbolizationOptions good;
    good.beads = {"sample", 100.0, 10.0, 1.2e-3, ""};
    good.bead_count = 3;
    const auto with = [&](auto change) {
        return [&, change](double value) {
            EmbolizationOptions options = good;
            change(options, value);
            Job job;
            embolize(network, conditions, 0, options, job);
        };
    };
    expect_range("diameter", 1.0, 1e5, with([](EmbolizationOptions& o, double v) {
                     o.beads.mean_diameter_um = v;
                     o.beads.diameter_sd_um = 0.0;
                 }));
    expect_range("spread", 0.0, 100.0 / 3.0,
                 with([](EmbolizationOptions& o, double v) { o.beads.diameter_sd_um = v; }));
    expect_range("density", 1e-6, 1.0,
                 with([](EmbolizationOptions& o, double v) { o.beads.density_g_mm3 = v; }));
    expect_range("stasis", 0.0, 1.0,
                 with([](EmbolizationOptions& o, double v) { o.stasis_fraction = v; }));
    expect_range("capillaries", 0.0, 1e3,
                 with([](EmbolizationOptions& o, double v) { o.capillary_radius_um = v; }));
    const auto batch =
        with([](EmbolizationOptions& o, double v) { o.batch = static_cast<int>(v); });
    EXPECT_NO_THROW(batch(1));
    EXPECT_NO_THROW(batch(100'000'000));
    EXPECT_THROW(batch(0), InputError);
    EXPECT_THROW(batch(100'000'001), InputError);
    const auto count =
        with([](EmbolizationOptions& o, double v) { o.bead_count = static_cast<int>(v); });
    EXPECT_NO_THROW(count(0));
    EXPECT_THROW(count(-1), InputError);
    EXPECT_THROW(count(100'000'001), InputError);
}

TEST(FlowLimits, OfAnInjection) {
    const VesselTree tree = make_tree(924, 1);
    const auto with = [&](auto change) {
        return [&, change](double value) {
            InjectionOptions options;
            options.until_s = 0.0;
            change(options, value);
            Job job;
            inject(tree, options, job);
        };
    };
    expect_range("mass flow", 1e-12, 1e15,
                 with([](InjectionOptions& o, double v) { o.mass_flow_g_s = v; }));
    expect_range("blood", 0.0, 1e15,
                 with([](InjectionOptions& o, double v) { o.blood_flow_g_s = v; }));
    expect_range("step", 1e-9, 1e9, with([](InjectionOptions& o, double v) { o.step_s = v; }));
    const auto until = with([](InjectionOptions& o, double v) { o.until_s = v; });
    EXPECT_NO_THROW(until(0.0));
    EXPECT_THROW(until(below(0.0)), InputError);
    EXPECT_THROW(until(above(1e9)), InputError);
    expect_range("duration", 0.0, HUGE_VAL,
                 with([](InjectionOptions& o, double v) { o.injection_s = v; }));
    expect_range("resistance", 0.0, 1e12,
                 with([](InjectionOptions& o, double v) { o.terminal_resistance_pa_s_mm3 = v; }));
    // Under a pressure the mass flow is not asked for.
    EXPECT_NO_THROW(with([](InjectionOptions& o, double v) {
        o.inlet_pressure_pa = 1000.0;
        o.mass_flow_g_s = v;
    })(0.0));
}

}  // namespace
}  // namespace hepatica
