// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of injections, drug fronts and embolizations as they are today.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/flow/flow_export.h"
#include "tests/flow/figures.h"

namespace hepatica {
namespace {

using namespace testing_flow;
using test::expect_recorded;
using test::Figures;

void add_injection(Figures& figures, const std::string& name, const InjectionResult& injection) {
    std::vector<double> series, lengths;
    for (const InjectionSample& s : injection.series) {
        series.insert(series.end(), {s.time_s, s.inlet_pressure_pa, s.inlet_flow_g_s, s.injected_g,
                                     s.inside_g, s.delivered_g, s.filled_fraction});
        series.insert(series.end(), s.outlet_mass_g.begin(), s.outlet_mass_g.end());
        series.insert(series.end(), s.territory_mass_g.begin(), s.territory_mass_g.end());
        lengths.insert(lengths.end(), s.filled_length_mm.begin(), s.filled_length_mm.end());
    }
    figures.add(name + ".series", series).add(name + ".lengths", lengths);
    figures.add(name + ".samples", static_cast<double>(injection.series.size()))
        .add(name + ".steps", static_cast<double>(injection.steps))
        .add(name + ".tip", injection.tip_node)
        .add(name + ".density", injection.drug.density_g_mm3)
        .add(name + ".viscosity", injection.drug.viscosity_pa_s)
        .add(name + ".balance",
             std::vector{injection.balance.injected_mm3, injection.balance.inside_mm3,
                         injection.balance.left_mm3, injection.balance.bled_mm3});
    add_solution(figures, name + ".begin", injection.begin);
    add_solution(figures, name + ".end", injection.end);
    add_arrivals(figures, name + ".arrivals", injection.network, injection.arrival);
}

TEST(FlowFigures, OfInjectionsWithTheOptionsAsTheyCome) {
    const VesselTree tree = uneven_tree(911, 4);
    Figures figures;
    Job job;
    add_injection(figures, "default", inject(tree, {}, job));
    InjectionOptions options;
    options.void_fraction = published_void_fraction;
    add_injection(figures, "lipiodol", inject(tree, options, job));
    options.second_phase = gas();
    options.shape = SegmentShape::centreline;
    options.mass_flow_g_s = 0.7;
    add_injection(figures, "gas", inject(tree, options, job));
    expect_recorded("flow", "injections", figures);
}

TEST(FlowFigures, OfInjectionsThroughCatheters) {
    const VesselTree tree = uneven_tree(912, 4);
    Figures figures;
    Job job;
    InjectionOptions options;
    options.tip = TreePoint{1, 1.3, 0.0};
    options.wedged = false;
    options.blood_flow_g_s = 3.0;
    options.mass_flow_g_s = 0.6;
    options.void_fraction = 0.3;
    options.terminal_resistance_pa_s_mm3 = 0.3;
    options.outlet_pressure_pa = 500.0;
    options.bifurcation_loss_coefficient = 0.4;
    options.injection_s = 0.8;
    options.territories = {{1, 2.0, 0.0}, {2, 0.0, 0.0}};
    options.record_filled_lengths = true;
    add_injection(figures, "free", inject(tree, options, job));
    options.wedged = true;
    options.law = PressureLaw::consistent;
    options.drug_viscosity_pa_s = 0.01;
    options.closed_segments = {5};
    options.tears = {{8, 1.0, 0.0}};
    options.until_s = 1.7;
    options.step_s = 0.06;
    add_injection(figures, "wedged", inject(tree, options, job));
    options.wedged = false;
    options.injection_s = std::numeric_limits<double>::infinity();
    options.inlet_pressure_pa = 2500.0;
    options.until_s.reset();
    options.front.step_tolerance = 0.03;
    const InjectionResult injection = inject(tree, options, job);
    add_injection(figures, "pressure", injection);
    std::vector<double> ends;
    for (int s = 0; s < static_cast<int>(tree.segments.size()); ++s) {
        ends.push_back(end_flow_g_s(injection, s));
        ends.push_back(finite(first_arrival_s(injection, s)));
    }
    figures.add("ends", ends);
    expect_recorded("flow", "catheters", figures);
}

// Pieces of many shares that run both ways.
TEST(FlowFigures, OfFrontsInLoops) {
    Figures figures;
    for (const int variant : {0, 1, 2}) {
        Random random(913);
        FlowNetwork network = random_tree(random, 20, 1.8);
        add_loops(random, network, 5);
        FlowConditions conditions;
        conditions.inlets = {
            {0, InletKind::mass_flow, 0.9, pure(blood())},
            {3, InletKind::mass_flow, 0.4, variant == 0 ? pure(blood()) : pure(lipiodol())}};
        FrontOptions options;
        options.injection_end_s = 1.5;
        if (variant == 2) {
            options.step_tolerance = 0.05;
            options.concentration_tolerance = 0.02;
        }
        DrugFront front(network, conditions, 1, options);
        std::vector<double> numbers;
        for (const double time : {0.3, 1.0, 1.5, 2.5}) {
            front.advance_to(time);
            for (int s = 0; s < static_cast<int>(network.segments.size()); ++s)
                numbers.insert(numbers.end(), {front.drug_mm3(s), front.filled_fraction(s),
                                               front.filled_length_mm(s)});
            numbers.insert(numbers.end(), front.outlet_mass_g().begin(),
                           front.outlet_mass_g().end());
        }
        const std::string name = "variant" + std::to_string(variant);
        figures.add(name, numbers).add(name + ".steps", static_cast<double>(front.steps()));
        add_arrivals(figures, name + ".arrivals", network, front.arrival_times());
    }
    expect_recorded("flow", "loops", figures);
}

TEST(FlowFigures, OfEmbolizations) {
    Figures figures;
    for (const Beads& beads : bead_presets()) {
        Random random(914);
        FlowNetwork network = random_tree(random, 40, 1.6);
        add_loops(random, network, 2);
        tear(network, {9, 0.5 * length_mm(network, 9), 0.0});
        FlowConditions conditions;
        conditions.inlets = {{0, InletKind::pressure, 5000.0, pure(blood())}};
        conditions.terminal_resistances = murray_terminal_resistances(network, 0.05);
        EmbolizationOptions options;
        options.beads = beads;
        options.bead_count = 1500;
        Job job;
        const Embolization result = embolize(network, conditions, 0, options, job);
        std::vector<double> numbers{static_cast<double>(result.injected),
                                    static_cast<double>(result.passed), result.injected_mass_g,
                                    result.passed_mass_g, result.stasis ? 1.0 : 0.0};
        for (const EmbolizationSample& s : result.series)
            numbers.insert(numbers.end(),
                           {static_cast<double>(s.injected), s.flow_mm3_s, s.inlet_pressure_pa,
                            static_cast<double>(s.lodged), static_cast<double>(s.passed),
                            static_cast<double>(s.open_outlets)});
        figures.add(beads.name + ".run", numbers)
            .add(beads.name + ".diameter", beads.mean_diameter_um)
            .add(beads.name + ".spread", beads.diameter_sd_um)
            .add(beads.name + ".density", beads.density_g_mm3);
        numbers.assign(result.lodged_in_segment.begin(), result.lodged_in_segment.end());
        numbers.insert(numbers.end(), result.lodged_beyond_outlet.begin(),
                       result.lodged_beyond_outlet.end());
        for (const double place : result.lodged_at_mm) numbers.push_back(finite(place));
        figures.add(beads.name + ".where", numbers)
            .add(beads.name + ".segment_mass", result.segment_mass_g)
            .add(beads.name + ".outlet_mass", result.outlet_mass_g)
            .add(beads.name + ".open", result.bed_open_share);
        add_solution(figures, beads.name + ".end", result.end);
    }
    const EmbolizationOptions options;
    figures.add("options",
                std::vector{static_cast<double>(options.bead_count),
                            static_cast<double>(options.batch), options.stasis_fraction,
                            options.capillary_radius_um, static_cast<double>(options.seed)});
    expect_recorded("flow", "embolizations", figures);
}

}  // namespace
}  // namespace hepatica
