// SPDX-License-Identifier: GPL-3.0-or-later
// The verbs about flow, through the real program: what they print, and the files they leave.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "core/anatomy/tree_files/tree_io.h"
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
    EXPECT_LT(lines.size(), 60u);
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

}  // namespace
}  // namespace hepatica
