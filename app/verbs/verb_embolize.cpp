// SPDX-License-Identifier: GPL-3.0-or-later
// embolize: injects beads until the flow stops (core/flow/embolization.h).
#include <filesystem>
#include <memory>
#include <numeric>
#include <string>

#include "app/chart_file.h"
#include "app/output_place.h"
#include "app/verbs/flow_options.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/base/units.h"
#include "core/flow/flow_export.h"

namespace hepatica {

namespace {

struct EmbolizeChoices {
    std::filesystem::path place;
    TreeFileOptions tree_file;
    std::string at_mm;
    std::string beads = "100-300";
    EmbolizationOptions embolization;
    double blood_flow_ml_min = 245.0;
    double inlet_pressure_mmhg = 90.0;
    double outlet_pressure_mmhg = 5.0;
    FluidOptions fluid;
    std::filesystem::path csv;
    std::filesystem::path plot;
};

// A pressure at the tip, and terminal resistances that let the given flow of blood through.
FlowConditions conditions_of(const EmbolizeChoices& options, const FlowNetwork& network, int tip) {
    FlowConditions conditions;
    conditions.law = options.fluid.law();
    conditions.resident = pure(options.fluid.liquid());
    conditions.outlet_pressure_pa = options.outlet_pressure_mmhg * units::millimetre_of_mercury;
    const double pressure_pa = options.inlet_pressure_mmhg * units::millimetre_of_mercury;
    const double flow_mm3_s = options.blood_flow_ml_min * units::millilitre_per_minute;
    if (!(flow_mm3_s > 0.0) || !(pressure_pa > conditions.outlet_pressure_pa))
        throw InputError("no blood flows at these pressures and this flow", "embolization",
                         "Give a flow above 0 and an inlet pressure above the outlets'");
    const double mass_flow_g_s = flow_mm3_s * conditions.resident.density_g_mm3;
    conditions.inlets = {{tip, InletKind::mass_flow, mass_flow_g_s, conditions.resident}};
    const double without_beds_pa = solve_flow(network, conditions).inlet_pressure_pa[0];
    const double beds_pa = pressure_pa - without_beds_pa;
    if (!(beds_pa > 0.0))
        throw InputError("the resolved vessels alone take " +
                             std::to_string(without_beds_pa - conditions.outlet_pressure_pa) +
                             " Pa",
                         "embolization", "Give a smaller flow or a higher inlet pressure");
    conditions.terminal_resistances = murray_terminal_resistances(network, beds_pa / flow_mm3_s);
    conditions.inlets = {{tip, InletKind::pressure, pressure_pa, conditions.resident}};
    return conditions;
}

Chart chart_of(const Embolization& result) {
    Curve flow{"flow at the tip / first", {}, {}};
    Curve open{"outlets that carry flow", {}, {}};
    const double outlets = static_cast<double>(result.network.outlet_nodes.size());
    for (const EmbolizationSample& s : result.series) {
        flow.x.push_back(s.injected);
        flow.y.push_back(s.flow_mm3_s / result.series.front().flow_mm3_s);
        open.x.push_back(s.injected);
        open.y.push_back(outlets > 0.0 ? s.open_outlets / outlets : 0.0);
    }
    return {"Embolization", "Beads injected", "Share", {flow, open}};
}

Json run_embolize(EmbolizeChoices options, Job& job) {
    require_different({options.csv, options.plot});
    if (!options.csv.empty()) require_writable_file(options.csv, ".csv");
    if (!options.plot.empty()) {
        require_chart_file(options.plot);
        require_writable_file(options.plot, extension_of(options.plot));
    }
    job.expect_stages(2);
    job.begin_stage("reading the tree");
    const VesselTree tree = read_any_tree(options.place, options.tree_file);
    FlowNetwork network = network_of(tree);
    const TreePoint point =
        options.at_mm.empty() ? main_root(tree) : parse_point("--at-mm", options.at_mm, tree);
    const int tip = place_catheter(network, point, true);
    const FlowConditions conditions = conditions_of(options, network, tip);
    options.embolization.beads = bead_preset(options.beads);
    const Embolization result = embolize(network, conditions, 0, options.embolization, job);
    if (!options.csv.empty()) write_series_csv(options.csv, result);
    if (!options.plot.empty()) write_chart(options.plot, chart_of(result));
    const auto total = [](const std::vector<int>& counts) {
        return std::accumulate(counts.begin(), counts.end(), 0);
    };
    Json answer;
    answer["beads"] = {{"name", options.embolization.beads.name},
                       {"mean_diameter_um", options.embolization.beads.mean_diameter_um},
                       {"source", options.embolization.beads.source}};
    answer["injected"] = result.injected;
    answer["injected_g"] = result.injected_mass_g;
    answer["lodged_in_vessels"] = total(result.lodged_in_segment);
    answer["lodged_beyond_outlets"] = total(result.lodged_beyond_outlet);
    answer["passed"] = result.passed;
    answer["mass_error_relative"] = result.mass_error_relative();
    answer["stasis"] = result.stasis;
    answer["flow_begin_ml_min"] = result.series.front().flow_mm3_s / units::millilitre_per_minute;
    answer["flow_end_ml_min"] = result.series.back().flow_mm3_s / units::millilitre_per_minute;
    answer["plugged_segments"] = Json::array();
    for (std::size_t i = 0; i < result.lodged_in_segment.size(); ++i)
        if (result.lodged_in_segment[i] > 0)
            answer["plugged_segments"].push_back(
                {{"segment", result.network.segments[i].tree_segment},
                 {"at_mm", result.network.segments[i].offset_mm + result.lodged_at_mm[i]},
                 {"beads", result.lodged_in_segment[i]}});
    return answer;
}

}  // namespace

void add_embolize(CommandLine& line) {
    const auto options = std::make_shared<EmbolizeChoices>();
    EmbolizationOptions& embolization = options->embolization;
    CLI::App& verb = line.add_verb("embolize", "Inject beads until the flow stands still",
                                   [options](Job& job) { return run_embolize(*options, job); });
    verb.add_option("CASE", options->place, "A case's folder, or a tree (.vtp, .swc, .json)")
        ->required();
    options->tree_file.add_to(verb);
    verb.add_option("--at-mm", options->at_mm,
                    "X,Y,Z of the catheter's tip; default: the root of the largest system");
    verb.add_option("--beads", options->beads, "100-300, 300-500, 500-700 (um) or gelatin")
        ->capture_default_str();
    verb.add_option("--count", embolization.bead_count, "At most this many")->capture_default_str();
    verb.add_option("--batch", embolization.batch, "Beads between two solutions of the flow")
        ->capture_default_str();
    verb.add_option("--seed", embolization.seed, "Of the beads' choices at bifurcations")
        ->check(whole_number_from(0))
        ->capture_default_str();
    verb.add_option("--stasis-fraction", embolization.stasis_fraction,
                    "Share of the first flow that counts as stasis")
        ->capture_default_str();
    verb.add_option("--blood-flow-ml-min", options->blood_flow_ml_min,
                    "Before the first bead (245: hepatic artery at 70 kg)")
        ->capture_default_str();
    verb.add_option("--inlet-pressure-mmhg", options->inlet_pressure_mmhg, "At the tip")
        ->capture_default_str();
    verb.add_option("--outlet-pressure-mmhg", options->outlet_pressure_mmhg, "Beyond the beds")
        ->capture_default_str();
    verb.add_option("--csv", options->csv, "Series over the beads");
    verb.add_option("--plot", options->plot, "Curves: .png or .csv");
    options->fluid.add_liquid_to(verb);
}

}  // namespace hepatica
