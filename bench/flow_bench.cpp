// SPDX-License-Identifier: GPL-3.0-or-later
// How long the flow through a tree takes: build/release/bin/flow_bench. Linear in segments.
#include <benchmark/benchmark.h>

#include "core/flow/arrival_times.h"
#include "core/flow/flow_solution.h"
#include "core/flow/territory.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::Random;
using testing_flow::random_tree;

FlowConditions injected(int node, double mass_flow_g_s, PressureLaw law = PressureLaw::regime) {
    FlowConditions conditions;
    conditions.law = law;
    conditions.inlets = {{node, InletKind::mass_flow, mass_flow_g_s, pure(blood())}};
    return conditions;
}

// One solve from nothing: circuit, elimination order, Newton.
void solve_tree(benchmark::State& state) {
    Random random(1);
    const FlowNetwork network = random_tree(random, static_cast<int>(state.range(0)));
    const auto law = static_cast<PressureLaw>(state.range(1));
    int steps = 0;
    for (auto _ : state) {
        const FlowSolution solution = solve_flow(network, injected(0, 2.0, law));
        steps = solution.newton_steps;
        benchmark::DoNotOptimize(solution.volume_flow_mm3_s.data());
    }
    state.SetLabel(name_of(law) + ", " + std::to_string(steps) + " Newton steps");
    state.SetComplexityN(state.range(0));
}
BENCHMARK(solve_tree)
    ->ArgsProduct({{10'000, 100'000, 1'000'000}, {0, 1, 2}})
    ->Unit(benchmark::kMillisecond);

// A patient's tree: the catheter moves to another segment; everything is solved anew.
void move_catheter(benchmark::State& state) {
    Random random(2);
    const FlowNetwork whole = random_tree(random, 500);
    int segment = 0;
    for (auto _ : state) {
        segment = (segment + 7) % 200;
        FlowNetwork network = whole;
        const int tip =
            place_catheter(network, {segment, 0.5 * length_mm(whole, segment), 0.0}, true);
        const FlowSolution solution = solve_flow(network, injected(tip, 0.2));
        const ArrivalTimes times = arrival_times(network, solution, {tip});
        benchmark::DoNotOptimize(times.end_s());
    }
}
BENCHMARK(move_catheter)->Unit(benchmark::kMillisecond);

// What hovering over a patient's tree costs.
void hover(benchmark::State& state) {
    Random random(3);
    const FlowNetwork network = random_tree(random, 500);
    const FlowSolution solution = solve_flow(network, injected(0, 2.0));
    int segment = 0;
    for (auto _ : state) {
        segment = (segment + 7) % 500;
        benchmark::DoNotOptimize(territory_of(network, solution, {segment, 0.0, 0.0}).volume_mm3);
    }
}
BENCHMARK(hover)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hepatica

BENCHMARK_MAIN();
