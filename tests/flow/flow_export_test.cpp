// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_export.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/error.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using Json = nlohmann::json;
using testing_flow::Random;
using testing_flow::random_tree;

// Solves a steady svZeroDSolver model by that program's own rules (its documentation): every vessel
// has inlet pressure P0, outlet pressure P1 and flow Q with P0 - P1 = R Q; a junction has equal
// pressures and conserves flow; a boundary gives Q, P, or P - Pd = R Q. Returns per vessel (P0, P1,
// Q).
std::map<std::string, std::array<double, 3>> solve_svzerod(const Json& model) {
    const Json& vessels = model.at("vessels");
    const int n = static_cast<int>(vessels.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(3 * n);
    int row = 0;
    std::map<std::string, Json> boundaries;
    for (const Json& boundary : model.at("boundary_conditions"))
        boundaries[boundary.at("bc_name")] = boundary;
    for (int v = 0; v < n; ++v) {
        EXPECT_EQ(vessels[v].at("vessel_id"), v);
        EXPECT_EQ(vessels[v].at("zero_d_element_type"), "BloodVessel");
        a(row, 3 * v) = 1;
        a(row, 3 * v + 1) = -1;
        a(row++, 3 * v + 2) = -vessels[v]["zero_d_element_values"].at("R_poiseuille").get<double>();
        if (!vessels[v].contains("boundary_conditions")) continue;
        for (const auto& [end, name] : vessels[v]["boundary_conditions"].items()) {
            const Json& boundary = boundaries.at(name);
            const int pressure = 3 * v + (end == "inlet" ? 0 : 1);
            const Json& values = boundary.at("bc_values");
            if (boundary.at("bc_type") == "FLOW") {
                a(row, 3 * v + 2) = 1;
                b[row++] = values.at("Q")[0];
            } else if (boundary.at("bc_type") == "PRESSURE") {
                a(row, pressure) = 1;
                b[row++] = values.at("P")[0];
            } else {
                EXPECT_EQ(boundary.at("bc_type"), "RESISTANCE");
                a(row, pressure) = 1;
                a(row, 3 * v + 2) = -values.at("R").get<double>();
                b[row++] = values.at("Pd");
            }
        }
    }
    for (const Json& junction : model.at("junctions")) {
        EXPECT_EQ(junction.at("junction_type"), "NORMAL_JUNCTION");
        int first = -1;
        const int balance = row++;
        const auto join = [&](int vessel, bool inlet_of_junction) {
            const int pressure = 3 * vessel + (inlet_of_junction ? 1 : 0);
            a(balance, 3 * vessel + 2) = inlet_of_junction ? 1 : -1;
            if (first >= 0) {
                a(row, first) = 1;
                a(row++, pressure) = -1;
            }
            if (first < 0) first = pressure;
        };
        for (const int vessel : junction.at("inlet_vessels")) join(vessel, true);
        for (const int vessel : junction.at("outlet_vessels")) join(vessel, false);
    }
    EXPECT_EQ(row, 3 * n);
    const Eigen::VectorXd x = a.fullPivLu().solve(b);
    std::map<std::string, std::array<double, 3>> solution;
    for (int v = 0; v < n; ++v)
        solution[vessels[v].at("vessel_name")] = {x[3 * v], x[3 * v + 1], x[3 * v + 2]};
    return solution;
}

// The published test case "steadyFlow_bifurcationR_R1": Q = 5, all resistances 100, Pd = 100 give
// outlet flows 2.5, junction 600 and inlet 1100, all in centimetre, gram, second.
TEST(SvZeroDExport, OurNetworkMeetsItsPublishedBifurcation) {
    FlowNetwork network;
    network.node_count = 4;
    network.root_nodes = {0};
    network.outlet_nodes = {2, 3};
    const double resistance = 100 / 1e4;  // in Pa s/mm3
    const double length = resistance * 3.14159265358979323846 * 81 / (8 * 3.5e-3);
    network.cones.assign(3, {3.0, 3.0, length});
    network.segments = {{0, 1, 0, 1, 0}, {1, 2, 1, 1, 1}, {1, 3, 2, 1, 2}};
    FlowConditions conditions;
    conditions.resident.density_g_mm3 = 1e-6;  // no turbulence
    conditions.inlets = {{0, InletKind::mass_flow, 5e3 * 1e-6, conditions.resident}};
    conditions.outlet_pressure_pa = 10.0;
    conditions.terminal_resistances = {resistance, resistance};
    const FlowSolution ours = solve_flow(network, conditions);
    EXPECT_NEAR(ours.outlet_flow_mm3_s[0], 2500.0, 1e-8);
    EXPECT_NEAR(ours.total_pressure_pa[0], 110.0, 1e-10);
    EXPECT_NEAR(ours.total_pressure_pa[1], 60.0, 1e-10);
    EXPECT_NEAR(ours.total_pressure_pa[2], 35.0, 1e-10);
    const auto theirs = solve_svzerod(Json::parse(svzerod_json(network, conditions)));
    EXPECT_NEAR(theirs.at("segment0_0")[0], 1100.0, 1e-8);
    EXPECT_NEAR(theirs.at("segment0_0")[1], 600.0, 1e-8);
    EXPECT_NEAR(theirs.at("segment1_1")[2], 2.5, 1e-10);
}

TEST(SvZeroDExport, GivesTheSamePressuresAndFlows) {
    Random random(81);
    for (int i = 0; i < 10; ++i) {
        FlowNetwork network = random_tree(random, 21);
        FlowConditions conditions;
        conditions.outlet_pressure_pa = 800.0;
        int tip = 0;
        if (i >= 5)
            tip = place_catheter(network, {1, 0.4 * length_mm(network, 1), 0.0}, i % 2 == 0);
        if (i % 3 == 0)
            conditions.terminal_resistances = murray_terminal_resistances(network, 0.01);
        if (i == 7) set_open(network, 2, false);
        if (i == 8) tear(network, {2, 1.0, 0.0});
        conditions.inlets = {{tip, InletKind::mass_flow, 0.3, pure(blood())}};
        if (i == 9) conditions.inlets.push_back({0, InletKind::pressure, 900.0, pure(blood())});
        const FlowSolution ours = solve_flow(network, conditions);
        const auto theirs = solve_svzerod(Json::parse(svzerod_json(network, conditions)));
        for (std::size_t s = 0; s < network.segments.size(); ++s) {
            const auto found =
                theirs.find("segment" + std::to_string(network.segments[s].tree_segment) + "_" +
                            std::to_string(s));
            if (found == theirs.end()) {
                EXPECT_EQ(ours.volume_flow_mm3_s[s], 0.0);
                continue;
            }
            const auto& [p0, p1, q] = found->second;
            EXPECT_NEAR(q * 1e3, ours.volume_flow_mm3_s[s], 1e-9 * 300) << i << " " << s;
            EXPECT_NEAR(p0 / 10, ours.total_pressure_pa[network.segments[s].proximal_node], 1e-8);
            EXPECT_NEAR(p1 / 10, ours.total_pressure_pa[network.segments[s].distal_node], 1e-8);
        }
    }
}

std::vector<std::vector<std::string>> read_csv(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(in, line);) {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
}

TEST(FlowCsv, HoldsOneRowPerSampleAndComesBackToTheBit) {
    VesselTree tree;
    tree.nodes = {{Vec3::Zero(), 1.0}, {Vec3(10, 0, 0), 0.8}};
    VesselSegment s;
    s.proximal_node = 0;
    s.distal_node = 1;
    s.points_mm = {Vec3::Zero(), Vec3(10, 0, 0)};
    s.radii_mm = {1.0, 0.8};
    tree.segments = {s};
    Job job;
    InjectionOptions options;
    options.record_filled_lengths = true;
    options.territories = {{0, 5.0, 0.0}};
    const InjectionResult injection = inject(tree, options, job);
    const auto folder = std::filesystem::temp_directory_path() / "hepatica_flow_csv_test";
    std::filesystem::create_directories(folder);
    write_series_csv(folder / "series.csv", injection);
    write_filled_lengths_csv(folder / "lengths.csv", injection);
    const auto series = read_csv(folder / "series.csv");
    const auto lengths = read_csv(folder / "lengths.csv");
    ASSERT_EQ(series.size(), injection.series.size() + 1);
    ASSERT_EQ(lengths.size(), injection.series.size() + 1);
    EXPECT_EQ(series[0][0], "time_s");
    EXPECT_EQ(series[0].back(), "outlet_node_1_g");
    for (std::size_t i = 0; i < injection.series.size(); ++i) {
        ASSERT_EQ(series[i + 1].size(), series[0].size());
        EXPECT_EQ(std::stod(series[i + 1][0]), injection.series[i].time_s);
        EXPECT_EQ(std::stod(series[i + 1][1]), injection.series[i].inlet_pressure_pa);
        EXPECT_EQ(std::stof(lengths[i + 1][1]), injection.series[i].filled_length_mm[0]);
    }
    // A file is not a folder.
    EXPECT_THROW(write_series_csv(folder / "series.csv" / "x.csv", injection), InputError);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace hepatica
