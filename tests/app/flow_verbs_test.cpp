// SPDX-License-Identifier: GPL-3.0-or-later
// The verbs about flow, through the real program: what they print, and the files they leave.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "core/flow/injection.h"
#include "core/patient/patient_case.h"
#include "core/tree/files/tree_io.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;

class FlowVerbs : public test::Tour {
  protected:
    static std::vector<std::string> lines_of(const std::string& text) {
        std::istringstream in(text);
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        return lines;
    }
    static std::vector<std::string> lines_in(const std::string& file) {
        std::ifstream in(file);
        return lines_of({std::istreambuf_iterator<char>(in), {}});
    }
    // Numbers of a row, between commas.
    static std::vector<double> numbers(const std::string& row) {
        std::istringstream in(row);
        std::vector<double> values;
        for (std::string cell; std::getline(in, cell, ',');) values.push_back(std::stod(cell));
        return values;
    }
};

TEST_F(FlowVerbs, InjectPrintsTheTenLargestFlowsAndJsonAllOfThem) {
    const std::size_t segments = read_tree_vtp(path("p/truth_tree.vtp")).segments.size();
    ASSERT_GT(segments, 20u);
    const Json all = answer({"inject", path("p/truth_tree.vtp")});
    ASSERT_EQ(all["flow_g_s"].size(), segments);
    ASSERT_EQ(all["arrival_s"].size(), segments);

    const Outcome run = run_cli({"inject", path("p/truth_tree.vtp")});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::vector<std::string> lines = lines_of(run.output);
    EXPECT_LT(lines.size(), 62u);
    const auto begin = std::ranges::find(lines, "largest_flows");
    ASSERT_NE(begin, lines.end()) << run.output;
    std::vector<double> flows;
    for (const auto& [segment, flow] : all["flow_g_s"].items())
        flows.push_back(std::abs(flow.get<double>()));
    std::ranges::sort(flows, std::greater());
    for (std::size_t i = 0; i < 10; ++i) {
        std::istringstream row(begin[static_cast<std::ptrdiff_t>(i) + 2]);
        std::string segment;
        double flow = 0.0;
        row >> segment >> flow;
        EXPECT_NEAR(std::abs(flow), flows[i], 1e-4 * flows[i]);
        EXPECT_NEAR(flow, all["flow_g_s"][segment].get<double>(), 1e-4 * flows[i]);
    }
    EXPECT_EQ(begin[12].substr(0, 2) == "  ", false) << "ten rows and no more";
}

#ifdef HEPATICA_WINDOW_PROGRAM
// A stub before all other segments, so that the main root is not that of the first segment.
TEST_F(FlowVerbs, RenderInjectsWhereInjectDoes) {
    PatientCase patient = read_case(path("p.hep"));
    VesselTree& tree = patient.tree;
    const Vec3 root = tree.segments[main_root(tree).segment].points_mm.front();
    const Vec3 end = tree.segments.back().points_mm.back();
    VesselSegment stub;
    stub.proximal_node = 0;
    stub.distal_node = 1;
    stub.points_mm = {end, end + Vec3(1, 0, 0)};
    stub.radii_mm = {0.2, 0.2};
    for (VesselSegment& segment : tree.segments) {
        segment.proximal_node += 2;
        segment.distal_node += 2;
        if (segment.parent >= 0) ++segment.parent;
    }
    tree.segments.insert(tree.segments.begin(), stub);
    tree.nodes.insert(tree.nodes.begin(), {{stub.points_mm[0], 0.2}, {stub.points_mm[1], 0.2}});
    write_case(path("stub.hep"), patient);
    const auto picture = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> call{"render", path("stub.hep"), "--out", path(name),
                                      "--size", "96,72",          "--bare"};
        call.insert(call.end(), more.begin(), more.end());
        answer(call);
        std::ifstream in(path(name), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    const std::string at =
        std::to_string(root.x()) + "," + std::to_string(root.y()) + "," + std::to_string(root.z());
    const std::string injected = picture("default.png", {"--time-s", "1"});
    EXPECT_EQ(injected, picture("root.png", {"--time-s", "1", "--at-mm", at}));
    EXPECT_NE(injected, picture("without.png", {}));
}
#endif

// Total less dynamic pressure, G^2/(2 rho), of the root's lumen.
TEST_F(FlowVerbs, InjectPrintsTheStaticPressureBesideTheTotal) {
    VesselTree tube;
    tube.nodes = {{Vec3(0, 0, 0), 2.0}, {Vec3(0, 0, 30), 2.0}};
    tube.segments.resize(1);
    tube.segments[0].proximal_node = 0;
    tube.segments[0].distal_node = 1;
    tube.segments[0].points_mm = {Vec3(0, 0, 0), Vec3(0, 0, 15), Vec3(0, 0, 30)};
    tube.segments[0].radii_mm = {2.0, 2.0, 2.0};
    write_tree_json(path("tube.json"), tube);
    constexpr double blood_g_mm3 = 1.06e-3, g_s = 2.0;
    const double flux = g_s / (std::numbers::pi * 4.0);
    for (const char* at : {"0,0,0", "0,0,15"}) {
        const Json found =
            answer({"inject", path("tube.json"), "--at-mm", at, "--mass-flow-g-s", "2"});
        const double total_pa = found["inlet_pressure_begin_pa"];
        const double static_pa = found["inlet_static_begin_pa"];
        EXPECT_NEAR(total_pa - static_pa, flux * flux / (2.0 * blood_g_mm3), 1e-9) << at;
    }
}

TEST_F(FlowVerbs, InjectWritesSeriesThatKeepTheMass) {
    const VesselTree tree = read_tree_vtp(path("p/truth_tree.vtp"));
    const Json found = answer({"inject", path("p/truth_tree.vtp"), "--void-fraction", "0.5",
                               "--csv", path("series.csv"), "--lengths-csv", path("lengths.csv"),
                               "--svzerod", path("model.json"), "--plot", path("plot.csv")});
    EXPECT_NEAR(found["drug"]["void_fraction"], 0.5, 1e-12);
    EXPECT_LT(found["volume_error_relative"], 1e-9);

    const std::vector<std::string> series = lines_in(path("series.csv"));
    ASSERT_GT(series.size(), 10u);
    std::vector<std::string> names;
    std::istringstream header(series[0]);
    for (std::string name; std::getline(header, name, ',');) names.push_back(name);
    const auto column = [&](const std::string& name) {
        const auto at = std::ranges::find(names, name);
        EXPECT_NE(at, names.end()) << name << " in " << series[0];
        return static_cast<std::size_t>(at - names.begin());
    };
    const std::size_t time = column("time_s"), in = column("injected_g"),
                      inside = column("inside_g"), out = column("delivered_g");
    double before = -1.0;
    for (std::size_t i = 1; i < series.size(); ++i) {
        const std::vector<double> row = numbers(series[i]);
        ASSERT_EQ(row.size(), names.size());
        EXPECT_GT(row[time], before);
        before = row[time];
        EXPECT_NEAR(row[in], row[inside] + row[out], 1e-9 * (1.0 + row[in])) << series[i];
    }
    EXPECT_NEAR(numbers(series.back())[in], found["injected_g"], 1e-9);

    // One column per segment beside the time, no more filled than its length.
    const std::vector<std::string> lengths = lines_in(path("lengths.csv"));
    ASSERT_EQ(lengths.size(), series.size());
    const std::vector<double> end = numbers(lengths.back());
    ASSERT_EQ(end.size(), tree.segments.size() + 1);
    for (std::size_t i = 0; i < tree.segments.size(); ++i)
        EXPECT_LE(end[i + 1], length_mm(tree.segments[i]) * (1.0 + 1e-6)) << i;

    std::ifstream model(path("model.json"));
    const Json network = Json::parse(model, nullptr, false);
    for (const char* key : {"boundary_conditions", "junctions", "vessels"})
        EXPECT_TRUE(network.contains(key)) << key;
    EXPECT_FALSE(lines_in(path("plot.csv")).empty());
}

TEST_F(FlowVerbs, InjectFollowsTerritoriesTearsAndClosedVessels) {
    const VesselTree tree = read_tree_vtp(path("p/truth_tree.vtp"));
    const auto middle = [&](int segment) {
        const std::vector<Vec3>& points = tree.segments[segment].points_mm;
        const Vec3 at = points[points.size() / 2];
        return std::to_string(at.x()) + "," + std::to_string(at.y()) + "," + std::to_string(at.z());
    };
    const Json whole = answer({"inject", path("p/truth_tree.vtp"), "--territory-mm", middle(0)});
    ASSERT_EQ(whole["territories"].size(), 1u);
    EXPECT_NEAR(whole["territories"][0]["share_of_outflow"], 1.0, 1e-9) << "all hangs on the root";

    const Json torn = answer({"inject", path("p/truth_tree.vtp"), "--tear-mm", middle(1)});
    EXPECT_GT(torn["bled_g"], 0.0);
    EXPECT_EQ(whole["bled_g"], 0.0);

    const Json closed = answer({"inject", path("p/truth_tree.vtp"), "--close", "1"});
    EXPECT_EQ(closed["flow_g_s"]["1"], 0.0);
    EXPECT_TRUE(closed["arrival_s"]["1"].is_null());
    EXPECT_GT(closed["inlet_pressure_begin_pa"], whole["inlet_pressure_begin_pa"]);

    const Json driven = answer({"inject", path("p/truth_tree.vtp"), "--pressure-pa",
                                std::to_string(whole["inlet_pressure_begin_pa"].get<double>())});
    EXPECT_NEAR(driven["flow_g_s"]["0"], 2.0, 1e-3) << "the pressure that 2 g/s took drives 2 g/s";
}

TEST_F(FlowVerbs, RefuseWhatIsNotThere) {
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"inject", path("p/truth_tree.vtp"), "--close", "99999"},
          {"inject", path("p/truth_tree.vtp"), "--at-mm", "9000,0,0"},
          {"inject", path("p/truth_tree.vtp"), "--model", "guessed"},
          {"inject", path("p/truth_tree.vtp"), "--void-fraction", "1"},
          {"embolize", path("p/truth_tree.vtp"), "--beads", "marbles"},
          {"embolize", path("p/truth_tree.vtp"), "--inlet-pressure-mmhg", "1"},
          {"pressure-drop", "--r1-mm=0", "--r2-mm=1", "--length-mm=10", "--mass-flow-g-s=1"},
          {"flow-curves", path("curves"), "--r1-mm=-1"}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 1) << call[0] << " " << call.back() << ": " << run.errors;
        EXPECT_EQ(run.output, "");
    }
    const Outcome closed = run_cli({"inject", path("p/truth_tree.vtp"), "--close", "99999"});
    EXPECT_NE(closed.errors.find("--close 99999: there is no such segment: the tree has "),
              std::string::npos)
        << closed.errors;
}

// An option that would change nothing is refused, and named: who gave it believes that it counts.
TEST_F(FlowVerbs, RefuseOptionsThatWouldChangeNothing) {
    const std::vector<std::string> cone{"--r1-mm=1", "--r2-mm=1", "--length-mm=10",
                                        "--mass-flow-g-s=1"};
    const auto with = [](std::vector<std::string> call, const std::vector<std::string>& more) {
        call.insert(call.end(), more.begin(), more.end());
        return call;
    };
    const std::string tree = path("p/truth_tree.vtp");
    for (const auto& [call, named] :
         {std::pair<std::vector<std::string>, std::string>{
              {"inject", tree, "--blood-flow-g-s", "5"}, "--free"},
          {{"inject", tree, "--pressure-pa", "100", "--mass-flow-g-s", "3"}, "--mass-flow-g-s"},
          {{"inject", tree, "--phase", "gas"}, "--phase"},
          {{"inject", tree, "--step-tolerance", "0"}, "--step-tolerance"},
          {{"inject", tree, "--phase-viscosity-pa-s", "1"}, "--phase-viscosity-pa-s"},
          {with({"pressure-drop", "--phase-density-kg-m3=900"}, cone), "--phase-density-kg-m3"},
          {with({"pressure-drop", "--loss-coefficient=-3"}, cone), "--loss-coefficient"},
          {{"inject", path("p.hep"), "--tree-space", "ras"}, "--tree-space"},
          {{"embolize", path("p.hep"), "--radius-mm", "2"}, "--radius-mm"},
          {{"embolize", tree, "--void-fraction", "0.4"}, "--void-fraction"},
          {{"embolize", tree, "--phase", "gas"}, "--phase"}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << call[0] << " " << named << ": " << run.errors;
        EXPECT_EQ(run.output, "");
        EXPECT_NE(run.errors.find(named), std::string::npos) << run.errors;
    }
    EXPECT_NE(run_cli({"inject", "--help"}).output.find("from 0 as in the answer"),
              std::string::npos);
    // A series of void fractions may begin with none.
    EXPECT_EQ(run_cli(with({"pressure-drop", "--phase=gas", "--void-fraction=0"}, cone)).exit_code,
              0);
    EXPECT_EQ(
        run_cli(with({"pressure-drop", "--phase=lipiodol", "--model=published"}, cone)).exit_code,
        0);
}

// Laminar flow through a cylinder: Hagen and Poiseuille's 8 mu L Q / (pi r^4).
TEST_F(FlowVerbs, PressureDropOfASlowCylinderIsPoiseuilles) {
    constexpr double viscosity_pa_s = 3.5e-3, length_mm = 40.0, radius_mm = 2.0, flow_g_s = 0.1;
    constexpr double density_g_mm3 = 1.06e-3, pi = 3.14159265358979323846;
    const double expected = 8.0 * viscosity_pa_s * length_mm * (flow_g_s / density_g_mm3) /
                            (pi * std::pow(radius_mm, 4));
    const Json found = answer({"pressure-drop", "--r1-mm", "2", "--r2-mm", "2", "--length-mm", "40",
                               "--mass-flow-g-s", "0.1"});
    EXPECT_NEAR(found["total_pa"], expected, 1e-3 * expected);
    EXPECT_NEAR(found["bernoulli_pa"], 0.0, 1e-12);
}

TEST_F(FlowVerbs, EmbolizeKeepsItsBeadsAndTheFlowFalls) {
    const Json found =
        answer({"embolize", path("p/truth_tree.vtp"), "--count", "20000", "--blood-flow-ml-min",
                "945", "--inlet-pressure-mmhg", "10", "--outlet-pressure-mmhg", "4", "--csv",
                path("beads.csv"), "--plot", path("beads_plot.csv")});
    EXPECT_EQ(found["injected"].get<int>(), found["lodged_in_vessels"].get<int>() +
                                                found["lodged_beyond_outlets"].get<int>() +
                                                found["passed"].get<int>());
    EXPECT_LT(found["flow_end_ml_min"], found["flow_begin_ml_min"]);
    EXPECT_LT(found["mass_error_relative"], 1e-9);
    EXPECT_GT(lines_in(path("beads.csv")).size(), 2u);
    EXPECT_GT(lines_in(path("beads_plot.csv")).size(), 2u);
}

// What vessels take of a pressure is that of their flow, whatever the pressure behind them.
TEST_F(FlowVerbs, EmbolizeSaysWhatTheVesselsTake) {
    std::vector<double> taken_pa;
    for (const char* outlet_mmhg : {"0", "15"}) {
        const Outcome run =
            run_cli({"embolize", path("p/truth_tree.vtp"), "--blood-flow-ml-min", "100000",
                     "--inlet-pressure-mmhg", "16", "--outlet-pressure-mmhg", outlet_mmhg});
        const std::string before = "the resolved vessels alone take ";
        const std::size_t at = run.errors.find(before);
        ASSERT_NE(at, std::string::npos) << run.errors;
        taken_pa.push_back(std::stod(run.errors.substr(at + before.size())));
    }
    EXPECT_GT(taken_pa[0], 0.0);
    EXPECT_NEAR(taken_pa[1], taken_pa[0], 1e-3 * taken_pa[0]);
}

TEST_F(FlowVerbs, FlowCurvesLeaveTheNumbersBesideThePlots) {
    const Json found = answer({"flow-curves", path("curves"), "--format", "csv"});
    for (const auto& file : found["files"]) {
        const std::vector<std::string> rows = lines_in(file.get<std::string>());
        ASSERT_GT(rows.size(), 10u);
        EXPECT_EQ(rows[0], "curve,x,y");
    }
    EXPECT_GE(found["hepatic_arteries"].size(), 3u);
}

TEST_F(FlowVerbs, FlowCurvesWriteAllFilesOrNone) {
    std::filesystem::create_directories(path("half/flow_forms_ratio.csv/in_the_way"));
    std::ofstream(path("half/flow_forms.csv")) << "older";
    const Outcome run = run_cli({"flow-curves", path("half"), "--format", "csv"});
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_NE(run.errors.find("flow_forms_ratio.csv"), std::string::npos) << run.errors;
    EXPECT_EQ(lines_in(path("half/flow_forms.csv")), std::vector<std::string>{"older"});
}

}  // namespace
}  // namespace hepatica
