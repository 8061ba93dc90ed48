// SPDX-License-Identifier: GPL-3.0-or-later
// When a drug arrives where its flow stops or turns on the way, as where vessels tear in a loop.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "core/flow/drug_front.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::add_loops;
using testing_flow::Random;
using testing_flow::random_tree;

constexpr double never = std::numeric_limits<double>::infinity();

// The drug enters at one end of a bridge and blood at the other, each beside a way out. Where the
// drug's inlet closes, the blood turns the flow in the bridge, and the drug goes back.
TEST(TurnedFlow, ADrugThatGoesBackReachesNothingMore) {
    FlowNetwork network;
    network.node_count = 4;
    network.root_nodes = {0, 1};
    network.outlet_nodes = {2, 3};
    network.cones = {{1, 1, 40}, {1, 1, 20}, {1, 1, 20}};
    network.segments = {{0, 1, 0, 1, 0}, {0, 2, 1, 1, 1}, {1, 3, 2, 1, 2}};
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::mass_flow, 2e-2, pure(blood())},
                         {1, InletKind::mass_flow, 1e-2, pure(blood())}};
    const double volume = 40.0 * std::numbers::pi;
    const double flow = DrugFront(network, conditions, 0).flow().volume_flow_mm3_s[0];
    ASSERT_GT(flow, 0.0);
    FrontOptions options;
    options.injection_end_s = 0.4 * volume / flow;
    DrugFront front(network, conditions, 0, options);
    front.advance_to(options.injection_end_s);
    const double back = front.flow().volume_flow_mm3_s[0];
    ASSERT_LT(back, 0.0);
    front.advance_to(options.injection_end_s + 0.2 * volume / std::abs(back));
    EXPECT_NEAR(front.filled_fraction(0), 0.2, 1e-9);
    const ArrivalTimes times = front.arrival_times();
    for (int mm = 1; mm < 40; mm += 2) {
        if (mm < 16)
            EXPECT_NEAR(times.arrival_s(0, mm), mm * std::numbers::pi / flow, 1e-9) << mm;
        else
            EXPECT_EQ(times.arrival_s(0, mm), never) << mm;
    }
}

// When drug is first seen in each tenth of each segment.
class FirstSeen {
  public:
    void look(const DrugFront& front) {
        for (int s = 0; s < static_cast<int>(front.network().segments.size()); ++s) {
            const double volume = volume_mm3(front.network(), s);
            for (int tenth = 0; tenth < 10; ++tenth) {
                const double drug = front.drug_up_to_mm3(s, 0.1 * (tenth + 1) * volume) -
                                    front.drug_up_to_mm3(s, 0.1 * tenth * volume);
                if (drug > 1e-8 * volume) seen_s_.try_emplace({s, tenth}, front.time_s());
            }
        }
    }
    double at_s(int segment, int tenth) const {
        const auto found = seen_s_.find({segment, tenth});
        return found != seen_s_.end() ? found->second : never;
    }

  private:
    std::map<std::pair<int, int>, double> seen_s_;
};

// The times against where the drug is seen, in loops whose flows another inlet turns to and fro.
void expect_arrivals_as_seen(Random& random, int& turned) {
    FlowNetwork network = random_tree(random, 20, 2.0);
    add_loops(random, network, 5);
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::mass_flow, 0.2, pure(blood())},
                         {random.integer(1, 20), InletKind::mass_flow, 0.1, pure(blood())}};
    FrontOptions options;
    options.concentration_tolerance = 0.0;
    DrugFront front(network, conditions, 0, options);
    const double step_s = 0.005 * volume_mm3(network) / (0.2 / blood().density_g_mm3);
    FirstSeen seen;
    std::vector<double> flow = front.flow().volume_flow_mm3_s;
    for (int step = 1; step <= 120; ++step) {
        front.advance_to(step * step_s);
        seen.look(front);
        if (step % 15 != 0) continue;
        conditions.inlets[1].value = random.logarithmic(0.01, 2.0);
        front.rejoin(network, conditions);
        for (std::size_t s = 0; s < flow.size(); ++s)
            turned += flow[s] * front.flow().volume_flow_mm3_s[s] < 0.0 ? 1 : 0;
        flow = front.flow().volume_flow_mm3_s;
    }
    const ArrivalTimes times = front.arrival_times();
    for (int s = 0; s < static_cast<int>(network.segments.size()); ++s) {
        const double volume = volume_mm3(network, s);
        for (int tenth = 0; tenth < 10; ++tenth) {
            SCOPED_TRACE(testing::Message() << "segment " << s << ", tenth " << tenth);
            const double first_s = std::min(
                times.arrival_s(s, arclength_at_mm(network, s, (0.1 * tenth + 1e-6) * volume)),
                times.arrival_s(s,
                                arclength_at_mm(network, s, (0.1 * tenth + 0.1 - 1e-6) * volume)));
            const double seen_s = seen.at_s(s, tenth);
            if (first_s > 118.0 * step_s) {
                EXPECT_GT(seen_s, 117.0 * step_s);
                continue;
            }
            EXPECT_GE(seen_s, first_s - 1e-3 * step_s);
            EXPECT_LE(seen_s, first_s + 1.1 * step_s);
        }
    }
}

TEST(TurnedFlow, TimesAreThoseAtWhichTheDrugIsSeen) {
    Random random(57);
    int turned = 0;
    for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(i);
        expect_arrivals_as_seen(random, turned);
    }
    EXPECT_GT(turned, 20) << "otherwise nothing was tested";
}

}  // namespace
}  // namespace hepatica
