// SPDX-License-Identifier: GPL-3.0-or-later
// inject: injects a drug and follows its front through the tree (core/flow/injection.h).
#include <spdlog/spdlog.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/as_published.h"
#include "app/chart_file.h"
#include "app/output_place.h"
#include "app/verbs/flow_options.h"
#include "app/verbs/injection_summary.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/flow/flow_export.h"
#include "core/flow/flow_shares.h"
#include "core/flow/injection.h"

namespace hepatica {

namespace {

struct InjectChoices {
    std::filesystem::path place;
    TreeFileOptions tree_file;
    InjectionOptions injection;
    FluidOptions fluid;
    std::string at_mm;
    std::vector<std::string> territories_mm;
    std::vector<std::string> tears_mm;
    bool free_tip = false;
    bool as_published = false;
    std::string shape = "one-cone";
    std::filesystem::path csv;
    std::filesystem::path lengths_csv;
    std::filesystem::path svzerod;
    std::filesystem::path plot;
};

Json number_or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// Pressure at the tip, vessels filled and drug delivered, over time.
Chart chart_of(const InjectionResult& result) {
    Chart chart{"Injection", "Time (s)", "Share", {}};
    double highest = 0.0;
    for (const InjectionSample& s : result.series)
        highest = std::max(highest, std::abs(s.inlet_pressure_pa));
    Curve pressure{"inlet pressure / " + std::to_string(std::lround(highest)) + " Pa", {}, {}};
    Curve filled{"vessels filled", {}, {}};
    Curve delivered{"injected fluid delivered", {}, {}};
    for (const InjectionSample& s : result.series) {
        for (Curve* curve : {&pressure, &filled, &delivered}) curve->x.push_back(s.time_s);
        pressure.y.push_back(highest > 0.0 ? s.inlet_pressure_pa / highest : 0.0);
        filled.y.push_back(s.filled_fraction);
        delivered.y.push_back(s.injected_g > 0.0 ? s.delivered_g / s.injected_g : 0.0);
    }
    chart.curves = {pressure, filled, delivered};
    return chart;
}

// At the tip, in its own vessel, while all vessels hold blood; the catheter divides them there.
double static_begin_pa(const InjectionResult& result, const TreePoint& tip) {
    const auto [segment, at_mm] = locate(result.network, tip);
    const SegmentPressures ends =
        static_pressures(result.network, result.begin, result.conditions.resident, segment);
    const bool begins_here = at_mm < 0.5 * length_mm(result.network, segment);
    return begins_here ? ends.proximal_static_pa : ends.distal_static_pa;
}

Json to_json(const InjectionResult& result, const Territory& territory, double mass_g) {
    Json outlets = Json::array();
    for (const int o : territory.outlets) outlets.push_back(result.network.outlet_nodes[o]);
    return {{"segment", result.network.segments[territory.segment].tree_segment},
            {"share_of_flow", territory.share_of_flow},
            {"share_of_outflow", territory.share_of_outflow},
            {"volume_mm3", territory.volume_mm3},
            {"outlet_nodes", outlets},
            {"drug_g", mass_g}};
}

Json answer_of(const VesselTree& tree, const InjectChoices& options, const TreePoint& tip,
               const InjectionResult& result) {
    const InjectionSample& begin = result.series.front();
    const InjectionSample& end = result.series.back();
    Json answer;
    answer["model"] = name_of(result.conditions.law);
    answer["drug"] = to_json(result.drug);
    answer["resident"] = to_json(result.conditions.resident);
    if (result.drug.void_fraction > 0.0) {
        answer["drug"]["phase"] = options.fluid.second().name;
        answer["drug"]["phase_source"] = options.fluid.second().source;
    }
    const VascularSystem system = tree.segments[tip.segment].system;
    answer["tip"] = {{"segment", tip.segment},
                     {"why", options.at_mm.empty()
                                 ? "the root of the " + title_of(system) + ": no place was given"
                                 : "the place that was given, in the " + title_of(system)},
                     {"arclength_mm", tip.arclength_mm},
                     {"distance_mm", tip.distance_mm},
                     {"wedged", options.injection.wedged}};
    answer["inlet_pressure_pa"] = end.inlet_pressure_pa;
    answer["inlet_pressure_begin_pa"] = begin.inlet_pressure_pa;
    answer["inlet_static_begin_pa"] = static_begin_pa(result, tip);
    answer["volume_error_relative"] = result.balance.error_relative();
    answer["mass_error_relative"] =
        std::max(result.begin.mass_error_relative, result.end.mass_error_relative);
    answer["injected_g"] = end.injected_g;
    answer["delivered_g"] = end.delivered_g;
    answer["bled_g"] = result.balance.bled_mm3 * result.drug.density_g_mm3;
    answer["delivered_fraction"] = end.injected_g > 0.0 ? end.delivered_g / end.injected_g : 0.0;
    answer["end_s"] = end.time_s;
    answer["steps"] = result.steps;
    answer["arrival_s"] = Json::object();
    answer["flow_g_s"] = Json::object();
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        const int id = static_cast<int>(i);
        answer["arrival_s"][std::to_string(i)] = number_or_null(first_arrival_s(result, id));
        answer["flow_g_s"][std::to_string(i)] = end_flow_g_s(result, id);
    }
    answer["outlet_g"] = Json::object();
    for (std::size_t o = 0; o < result.outlet_nodes.size(); ++o)
        answer["outlet_g"][std::to_string(result.outlet_nodes[o])] = end.outlet_mass_g[o];
    answer["filled_fraction"] = Json::array();
    for (const InjectionSample& s : result.series)
        answer["filled_fraction"].push_back(
            {{"time_s", s.time_s}, {"fraction", s.filled_fraction}});
    if (!result.territories.empty()) {
        answer["territories"] = Json::array();
        for (std::size_t i = 0; i < result.territories.size(); ++i)
            answer["territories"].push_back(
                to_json(result, result.territories[i], end.territory_mass_g[i]));
    }
    return answer;
}

Json run_inject(InjectChoices options, Job& job) {
    require_different(
        {options.place, options.csv, options.lengths_csv, options.svzerod, options.plot});
    for (const auto* file : {&options.csv, &options.lengths_csv})
        if (!file->empty()) require_writable_file(*file, ".csv");
    if (!options.svzerod.empty()) require_writable_file(options.svzerod, ".json");
    if (!options.plot.empty()) {
        require_chart_file(options.plot);
        require_writable_file(options.plot, extension_of(options.plot));
    }
    InjectionOptions& injection = options.injection;
    if (!options.as_published) options.fluid.require_use_of_phase();
    job.expect_stages(2);
    job.begin_stage("reading the tree");
    const VesselTree tree = read_any_tree(options.place, options.tree_file);
    const TreePoint tip =
        options.at_mm.empty() ? main_root(tree) : parse_point("--at-mm", options.at_mm, tree);
    injection.tip = tip;
    for (const std::string& point : options.territories_mm)
        injection.territories.push_back(parse_point("--territory-mm", point, tree));
    for (const std::string& point : options.tears_mm)
        injection.tears.push_back(parse_point("--tear-mm", point, tree));
    if (options.as_published) options.fluid.model = published_pressure_model;
    for (const int closed : injection.closed_segments)
        if (closed < 0 || closed >= static_cast<int>(tree.segments.size()))
            throw InputError("there is no such segment: the tree has " +
                                 std::to_string(tree.segments.size()) + ", numbered from 0",
                             "--close " + std::to_string(closed), "Close one of these");
    injection.wedged = !options.free_tip;
    injection.law = options.fluid.law();
    injection.liquid = options.fluid.liquid();
    injection.second_phase = options.fluid.second();
    injection.void_fraction = options.fluid.share();
    injection.shape =
        options.shape == "centreline" ? SegmentShape::centreline : SegmentShape::one_cone;
    injection.record_filled_lengths = !options.lengths_csv.empty();
    const InjectionResult result = inject(tree, injection, job);
    if (!options.csv.empty()) write_series_csv(options.csv, result);
    if (!options.lengths_csv.empty()) write_filled_lengths_csv(options.lengths_csv, result);
    if (!options.svzerod.empty())
        write_svzerod_json(options.svzerod, result.network, result.conditions);
    if (!options.plot.empty()) write_chart(options.plot, chart_of(result));
    Json answer = answer_of(tree, options, tip, result);
    answer["warnings"] = warnings_of_ends(tree, flow_shares(tree));
    for (const Json& warning : answer["warnings"]) spdlog::warn("{}", warning.get<std::string>());
    return answer;
}

void add_fluid(CLI::App& verb, InjectChoices& options) {
    options.fluid.add_to(verb);
    CLI::Option* as_published =
        verb.add_flag("--as-published", options.as_published,
                      "As the paper has it: --model published, gas at a void fraction of 0.40");
    for (const char* other : {"--model", "--void-fraction", "--phase"})
        as_published->excludes(verb.get_option(other));
}

}  // namespace

void add_inject(CommandLine& line) {
    const auto options = std::make_shared<InjectChoices>();
    InjectionOptions& injection = options->injection;
    injection.mass_flow_g_s = default_injection::mass_flow_g_s;
    CLI::App& verb = line.add_verb(
        "inject", "Inject a drug and follow its front through the tree",
        [options](Job& job) { return run_inject(*options, job); }, summary_of_injection);
    verb.add_option("CASE", options->place, "A case's folder, or a tree (.vtp, .swc, .json)")
        ->required();
    options->tree_file.add_to(verb);
    CLI::Option* mass_flow =
        verb.add_option("--mass-flow-g-s", injection.mass_flow_g_s, "Of the injected fluid")
            ->capture_default_str();
    verb.add_option("--pressure-pa", injection.inlet_pressure_pa,
                    "Total pressure at the tip, instead of a mass flow; above the outlets'")
        ->excludes(mass_flow);
    verb.add_option("--at-mm", options->at_mm,
                    "X,Y,Z of the catheter's tip; default: the root of the largest system");
    CLI::Option* free_tip =
        verb.add_flag("--free", options->free_tip,
                      "The tip does not fill the lumen: blood passes it (see --blood-flow-g-s)");
    verb.add_option("--blood-flow-g-s", injection.blood_flow_g_s,
                    "Blood that enters at the root, with --free")
        ->needs(free_tip);
    verb.add_option("--drug-viscosity-pa-s", injection.drug_viscosity_pa_s,
                    "Viscosity of the injected fluid, instead of the mixture's");
    verb.add_option(
        "--close", injection.closed_segments,
        "Number of a segment that is clamped or plugged, from 0 as in the answer (branch 1 of "
        "a warning is segment 0); may be repeated");
    verb.add_option("--tear-mm", options->tears_mm,
                    "X,Y,Z where a vessel is torn through; may be repeated");
    verb.add_option("--injection-s", injection.injection_s, "Then nothing more is injected");
    verb.add_option("--until-s", injection.until_s, "End; default: until nothing changes any more");
    verb.add_option("--step-s", injection.step_s, "Time between two rows of the series");
    verb.add_option("--step-tolerance", injection.front.step_tolerance,
                    "Change of flow allowed within one step, where the fluids differ: smaller is "
                    "more accurate and slower")
        ->check(CLI::Range(1e-9, 1.0))
        ->capture_default_str();
    verb.add_option("--outlet-pressure-pa", injection.outlet_pressure_pa, "Beyond every outlet");
    verb.add_option("--terminal-resistance", injection.terminal_resistance_pa_s_mm3,
                    "Of all vessels too small to see, in Pa s/mm3, shared by Murray's law");
    verb.add_option("--loss-coefficient", injection.bifurcation_loss_coefficient,
                    "Head lost at bifurcations, as a share of the dynamic pressure");
    verb.add_option("--shape", options->shape, "Lumen of a segment: one-cone or centreline")
        ->check(CLI::IsMember({"one-cone", "centreline"}));
    verb.add_option("--territory-mm", options->territories_mm,
                    "X,Y,Z of a point whose territory is followed; may be repeated");
    verb.add_option("--csv", options->csv, "Series over time");
    verb.add_option("--lengths-csv", options->lengths_csv,
                    "Filled length of each segment over time");
    verb.add_option("--svzerod", options->svzerod, "The network for svZeroDSolver");
    verb.add_option("--plot", options->plot, "Curves over time: .png or .csv");
    add_fluid(verb, *options);
}

}  // namespace hepatica
