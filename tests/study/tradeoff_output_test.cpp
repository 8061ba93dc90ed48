// SPDX-License-Identifier: GPL-3.0-or-later
// The front of a trade-off, what a measured frame is booked as, and the two files that show them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/study/frame_meter.h"
#include "core/study/tradeoff.h"
#include "tests/session/failing_stepper.h"
#include "tests/support/emulated_back_end.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

TradeoffPoint point(const std::string& element, double frame_ms, double error) {
    TradeoffPoint made;
    made.element = element;
    made.elements = 77;
    made.frame_ms = frame_ms;
    made.error_relative = error;
    return made;
}

// From the cheapest to the most accurate; the second is beaten by the first in both.
Tradeoff four_points() {
    Tradeoff tradeoff;
    tradeoff.reference = "words of the reference";
    tradeoff.points = {point("spring", 1.0, 0.5), point("corotated", 2.0, 0.6),
                       point("corotated-10", 10.0, 0.01), point("hexahedron", 100.0, 0.001)};
    TradeoffPoint unmeasured = point("neohookean", std::nan(""), std::nan(""));
    unmeasured.not_measured = "no time, none, was left";
    tradeoff.points.push_back(unmeasured);
    tradeoff.points[0].options.substeps = 4;
    tradeoff.points[0].options.newton_iterations = 5;
    tradeoff.points[2].options.solver = LinearSolverKind::block_jacobi;
    tradeoff.points[2].options.linear.energy_tolerance = 0.0;
    tradeoff.points[2].options.linear.max_iterations = 20;
    tradeoff.points[3].own_mesh = false;
    tradeoff.points[3].back_end = "cuda";
    tradeoff.points[3].device = "NVIDIA X, 80 GB";
    mark_front(tradeoff);
    return tradeoff;
}

TEST(MarkFront, GivesTheLogarithmOfCostAsQuality) {
    const Tradeoff tradeoff = four_points();
    const bool on_front[] = {true, false, true, true, false};
    for (int i = 0; i < 5; ++i) EXPECT_EQ(tradeoff.points[i].on_front, on_front[i]) << i;
    EXPECT_EQ(tradeoff.points[0].quality, 0.0);
    EXPECT_NEAR(tradeoff.points[2].quality, 0.5, 1e-12);
    EXPECT_EQ(tradeoff.points[3].quality, 1.0);
}

TEST(MarkFront, TakesASinglePointAsTheBestAndNoneAsNone) {
    Tradeoff one;
    one.points = {point("spring", 3.0, 0.1)};
    mark_front(one);
    EXPECT_TRUE(one.points[0].on_front);
    EXPECT_EQ(one.points[0].quality, 1.0);
    Tradeoff none;
    mark_front(none);
    EXPECT_TRUE(none.points.empty());
}

// A motion that diverged has an error that is no number, or none that is finite: the first in order
// was the front's best, and nothing could beat it.
TEST(MarkFront, LeavesOutWhatHasNoPlaceInThePlane) {
    const double nan = std::nan(""), infinite = HUGE_VAL;
    Tradeoff tradeoff;
    tradeoff.points = {point("spring", 0.5, nan), point("corotated", 0.6, infinite),
                       point("corotated", infinite, 0.1), point("spring", 0.0, 0.1),
                       point("corotated", 2.0, 0.2)};
    mark_front(tradeoff);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(tradeoff.points[i].on_front, i == 4) << i;
    const fs::path folder = fs::path(testing::TempDir()) / "tradeoff_out_of_the_plane";
    write_tradeoff(tradeoff, folder);
    std::ostringstream picture;
    picture << std::ifstream(folder / "tradeoff.svg").rdbuf();
    fs::remove_all(folder);
    EXPECT_EQ(picture.str().find("nan"), std::string::npos) << picture.str();
    EXPECT_EQ(picture.str().find("inf"), std::string::npos) << picture.str();
    EXPECT_NE(picture.str().find("corotated, 77 elements"), std::string::npos) << picture.str();
}

class TradeoffFiles : public testing::Test {
  protected:
    void SetUp() override { write_tradeoff(four_points(), folder_); }
    void TearDown() override { fs::remove_all(folder_.parent_path()); }

    std::string text_of(const char* name) const {
        std::ostringstream text;
        text << std::ifstream(folder_ / name).rdbuf();
        return text.str();
    }
    // All matches of two numbers in the picture.
    std::vector<std::array<double, 2>> pairs(const std::string& pattern) const {
        const std::string picture = text_of("tradeoff.svg");
        const std::regex regex(pattern);
        std::vector<std::array<double, 2>> found;
        for (std::sregex_iterator i(picture.begin(), picture.end(), regex), end; i != end; ++i)
            found.push_back({std::stod((*i)[1]), std::stod((*i)[2])});
        return found;
    }

    fs::path folder_ =
        fs::path(testing::TempDir()) /
        (std::string("tradeoff_") + testing::UnitTest::GetInstance()->current_test_info()->name()) /
        "made";
};

TEST_F(TradeoffFiles, ListEveryPointWithItsReason) {
    std::istringstream lines(text_of("tradeoff.csv"));
    std::string line;
    std::getline(lines, line);
    const auto columns = std::ranges::count(line, ',');
    EXPECT_EQ(line.rfind("element,elements,", 0), 0u);
    std::vector<std::string> rows;
    while (std::getline(lines, line)) rows.push_back(line);
    ASSERT_EQ(rows.size(), 5u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(std::ranges::count(rows[i], ','), columns);
    EXPECT_EQ(rows[0].rfind("spring,77,whole,cpu,\"\",", 0), 0u) << rows[0];
    EXPECT_EQ(rows[3].rfind("hexahedron,77,whole,cuda,\"NVIDIA X, 80 GB\",", 0), 0u) << rows[3];
    EXPECT_NE(text_of("tradeoff.svg").find("hexahedron, cuda"), std::string::npos);
    EXPECT_NE(rows[2].find(",0.5,\"\""), std::string::npos) << rows[2];
    EXPECT_NE(rows[4].find("\"no time, none, was left\""), std::string::npos);
}

TEST_F(TradeoffFiles, SayWhatTheErrorIsOf) {
    EXPECT_NE(text_of("tradeoff.svg").find(">error of the motion</text>"), std::string::npos);
    write_tradeoff(four_points(), folder_, "error of the force");
    EXPECT_NE(text_of("tradeoff.svg").find(">error of the force</text>"), std::string::npos);
    EXPECT_EQ(text_of("tradeoff.svg").find("error of the motion"), std::string::npos);
}

// Costs of 1 to 100 ms and errors of 0.001 to 1: two and three whole decades, evenly wide.
TEST_F(TradeoffFiles, PlacePointsOnLogarithmicAxes) {
    const auto circles = pairs("<circle cx='([-0-9.]+)' cy='([-0-9.]+)' r='[46]'");
    ASSERT_EQ(circles.size(), 4u);
    const double left = circles[0][0], right = circles[3][0];  // 1 ms and 100 ms
    EXPECT_GT(right, left);
    EXPECT_NEAR(circles[2][0], 0.5 * (left + right), 0.01);
    EXPECT_NEAR(circles[1][0], left + (right - left) * std::log10(2.0) / 2.0, 0.01);
    const double decade = circles[3][1] - circles[2][1];  // from 1 % down to 0.1 %
    EXPECT_GT(decade, 0.0);
    EXPECT_NEAR(circles[2][1] - circles[0][1], decade * std::log10(50.0), 0.01);
    // Lines of the axes at 1, 10 and 100 ms and at 0.1, 1, 10 and 100 %, and inside the picture.
    const std::string picture = text_of("tradeoff.svg");
    const std::regex vertical("<line x1='([-0-9.]+)' y1='([-0-9.]+)' x2='\\1' y2='([-0-9.]+)'");
    std::vector<double> at;
    for (std::sregex_iterator i(picture.begin(), picture.end(), vertical), end; i != end; ++i) {
        at.push_back(std::stod((*i)[1]));
        EXPECT_LE(std::stod((*i)[2]), circles[0][1] - decade * std::log10(2.0) + 0.01);  // 100 %
        EXPECT_NEAR(std::stod((*i)[3]), circles[3][1], 0.01);                            // 0.1 %
    }
    ASSERT_EQ(at.size(), 3u);
    EXPECT_NEAR(at[0], left, 0.01);
    EXPECT_NEAR(at[1], circles[2][0], 0.01);
    EXPECT_NEAR(at[2], right, 0.01);
    const auto horizontal = pairs("<line x1='[-0-9.]+' y1='([-0-9.]+)' x2='[-0-9.]+' y2='(\\1)'");
    ASSERT_EQ(horizontal.size(), 4u);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(horizontal[i][0], circles[3][1] - i * decade, 0.01);
    for (const char* label : {">1<", ">10<", ">100<", ">0.1 %<", ">1 %<", ">10 %<", ">100 %<"})
        EXPECT_NE(picture.find(label), std::string::npos) << label;
    for (const auto& [x, y] : circles) {
        EXPECT_GE(x, 0.0);
        EXPECT_LE(x, 960.0);
        EXPECT_GE(y, 0.0);
        EXPECT_LE(y, 620.0);
    }
}

TEST_F(TradeoffFiles, JoinTheFrontAndNameItsPoints) {
    const std::string picture = text_of("tradeoff.svg");
    const auto circles = pairs("<circle cx='([-0-9.]+)' cy='([-0-9.]+)' r='[46]'");
    std::ostringstream line;
    for (const int i : {0, 2, 3}) line << circles[i][0] << ',' << circles[i][1] << ' ';
    EXPECT_NE(picture.find("points='" + line.str() + "'"), std::string::npos) << line.str();
    EXPECT_EQ(pairs("<circle cx='([-0-9.]+)' cy='([-0-9.]+)' r='6'").size(), 3u);  // larger
    EXPECT_NE(picture.find(">spring x4 N5</text>"), std::string::npos);
    EXPECT_NE(picture.find(">corotated-10 block-jacobi 20</text>"), std::string::npos) << picture;
    EXPECT_EQ(picture.find("font-size='11'>corotated</text>"), std::string::npos);
    EXPECT_NE(picture.find("words of the reference"), std::string::npos);
    EXPECT_EQ(pairs("<circle cx='([-0-9.]+)' cy='([-0-9.]+)' r='[46]' fill='none'").size(), 1u);
    EXPECT_NE(picture.find("ring: another mesh"), std::string::npos);
}

// One colour an element, the same in the picture and in the legend, one line of legend under the
// other.
TEST_F(TradeoffFiles, ExplainTheColours) {
    const std::string picture = text_of("tradeoff.svg");
    const std::regex entry("r='5' fill='(#[0-9a-f]+)'/>\n<text x='[0-9.]+' y='([0-9.]+)'>([^<]+)<");
    std::map<std::string, std::string> colour;
    double above = 0.0;
    for (std::sregex_iterator i(picture.begin(), picture.end(), entry), end; i != end; ++i) {
        colour[(*i)[3]] = (*i)[1];
        EXPECT_GT(std::stod((*i)[2]), above + 12.0);
        above = std::stod((*i)[2]);
    }
    ASSERT_EQ(colour.size(), 4u);
    std::set<std::string> different;
    for (const auto& [name, of] : colour) {
        different.insert(of);
        const std::regex point("r='[46]' fill='" + of + "' fill-opacity='[0-9.]+'><title>" + name +
                               "[ ,]");
        if (name != "hexahedron") {
            EXPECT_TRUE(std::regex_search(picture, point)) << name;
        }
    }
    EXPECT_EQ(different.size(), 4u);
}

TEST(TradeoffOutput, RefusesAFolderThatCannotBe) {
    const fs::path file = fs::path(testing::TempDir()) / "tradeoff_is_a_file";
    std::ofstream(file) << "x";
    EXPECT_THROW(write_tradeoff(four_points(), file / "below"), InputError);
    fs::remove(file);
}

TEST(TradeoffOutput, WritesBothFilesOrNone) {
    const fs::path folder = fs::path(testing::TempDir()) / "tradeoff_half";
    fs::create_directories(folder / "tradeoff.svg" / "in_the_way");
    std::ofstream(folder / "tradeoff.csv") << "older";
    EXPECT_THROW(write_tradeoff(four_points(), folder), InputError);
    std::ifstream in(folder / "tradeoff.csv");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "older");
    fs::remove_all(folder);
}

BodyDescription brick() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(10, 10, 10), {1, 1, 1});
    body.fixed.assign(body.mesh.vertices_mm.size(), 0);
    for (int v = 0; v < 4; ++v) body.fixed[v] = 1;
    return body;
}

// A body that is stepped in parts: costs and iterations are for a frame, and for one of its parts.
TEST(FrameMeter, BooksAFrameAndItsParts) {
    const BodyDescription body = brick();
    const auto make = [&] {
        auto stepper =
            make_cpu_stepper(body, {.solver = LinearSolverKind::block_jacobi, .sleeping = false});
        stepper->set_gravity(Vec3(0, 9810, 0));
        return stepper;
    };
    const auto metered = make(), plain = make();
    FrameMeter meter;
    Job job;
    double iterations = 0.0;
    for (int frame = 0; frame < 5; ++frame) {
        meter.step(*metered, 3, job);
        for (int part = 0; part < 3; ++part)
            iterations += plain->step(1.0 / 180.0).linear_iterations;
    }
    EXPECT_EQ(meter.frames(), 5);
    EXPECT_GT(meter.last_wall_ms(), 0.0);
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v)
        EXPECT_LT((metered->positions_mm()[v] - plain->positions_mm()[v]).norm(), 1e-12);
    TradeoffPoint booked;
    booked.options.substeps = 3;
    meter.book(booked);
    EXPECT_GT(iterations, 0.0);
    EXPECT_NEAR(booked.iterations, iterations / 15.0, 1e-12);
    EXPECT_NEAR(booked.dt_s, 1.0 / 180.0, 1e-15);
    EXPECT_GT(booked.frame_ms, 0.0);
    EXPECT_NEAR(booked.step_ms, booked.frame_ms / 3.0, 1e-12);
    job.cancel();
    EXPECT_THROW(meter.step(*metered, 3, job), Cancelled);
}

// While a device works the processor waits: what it computes meanwhile is not the frame's cost.
TEST(FrameMeter, BooksTheTimeThatPassesOnADevice) {
    static constexpr int waited_ms = 60;
    const BodyDescription body = brick();
    const auto cost_of = [&](const DeformBackEnd& back_end) {
        const auto wait = std::make_shared<test::Fault>([](const std::string& call) {
            if (call == "begin step")
                std::this_thread::sleep_for(std::chrono::milliseconds(waited_ms));
        });
        test::FailingStepper stepper(back_end.make(body, {}, {}), wait);
        FrameMeter meter;
        Job job;
        for (int i = 0; i < 3; ++i) meter.step(stepper, 1, job);
        TradeoffPoint booked;
        meter.book(booked);
        return booked.frame_ms;
    };
    EXPECT_GE(cost_of(test::emulated_back_end().back_end), waited_ms);
    EXPECT_LT(cost_of(cpu_back_end()), waited_ms);
}

}  // namespace
}  // namespace hepatica
