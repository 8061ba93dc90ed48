// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the flow through a tree: build/release/bin/flow_bench. The cost is linear in the number
// of segments.
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/flow/arrival_times.h"
#include "core/flow/drug_front.h"
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

// One solve from scratch: circuit, elimination order, Newton iterations.
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

// The catheter moves to another segment of a tree of a patient's size, and everything is solved
// anew.
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

// One step of the front, up to the next event; 0: a drug like blood, 1: lipiodol (two solves a
// step).
void front_event(benchmark::State& state) {
    Random random(4);
    const FlowNetwork network = random_tree(random, static_cast<int>(state.range(0)));
    FlowConditions conditions = injected(0, 2.0);
    if (state.range(1) == 1) conditions.inlets[0].fluid = pure(lipiodol());
    DrugFront front(network, conditions, 0);
    for (int i = 0; i < 20; ++i) front.step(1e3);
    for (auto _ : state) benchmark::DoNotOptimize(front.step(1e3).duration_s);
    state.SetLabel(state.range(1) == 1 ? "lipiodol" : "like blood");
}
BENCHMARK(front_event)
    ->ArgsProduct({{500, 100'000, 1'000'000}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(10);

// A whole injection of lipiodol into a tree of a patient's size, until every vessel is full.
void whole_injection(benchmark::State& state) {
    Random random(5);
    const FlowNetwork network = random_tree(random, 500);
    FlowConditions conditions = injected(0, 2.0);
    conditions.inlets[0].fluid = pure(lipiodol());
    std::uint64_t steps = 0;
    for (auto _ : state) {
        DrugFront front(network, conditions, 0);
        while (!front.at_rest()) front.step(1e3);
        steps = front.steps();
    }
    state.SetLabel(std::to_string(steps) + " steps");
}
BENCHMARK(whole_injection)->Unit(benchmark::kMillisecond);

// Accuracy against speed: the largest error of any segment's first arrival time, relative to the
// time in which the tree is filled, over the tolerance of a step. The reference is a run with a
// hundredth of the finest tolerance.
void step_tolerance(benchmark::State& state) {
    Random random(6);
    const FlowNetwork network = random_tree(random, 500);
    FlowConditions conditions = injected(0, 2.0);
    conditions.inlets[0].fluid = pure(lipiodol());
    const double filling_s = volume_mm3(network) / (2.0 / conditions.inlets[0].fluid.density_g_mm3);
    const auto arrivals = [&](double tolerance, std::uint64_t& steps) {
        FrontOptions options;
        options.step_tolerance = tolerance;
        DrugFront front(network, conditions, 0, options);
        while (!front.at_rest()) front.step(1e3);
        steps = front.steps();
        return front.arrival_times();
    };
    std::uint64_t steps = 0;
    static const ArrivalTimes exact = arrivals(1e-5, steps);
    const double tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
    ArrivalTimes times;
    for (auto _ : state) times = arrivals(tolerance, steps);
    double error = 0.0;
    for (int i = 0; i < 500; ++i)
        error = std::max(error, std::abs(times.first_s(i) - exact.first_s(i)) / filling_s);
    state.counters["error"] = error;
    state.counters["steps"] = static_cast<double>(steps);
    state.SetLabel("tolerance 1e-" + std::to_string(state.range(0)));
}
BENCHMARK(step_tolerance)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

// Cost of hovering over a tree of a patient's size: the territory of a point.
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
