// SPDX-License-Identifier: GPL-3.0-or-later
// The quick rows of the stability suite; `hepatica-cli extremes` runs all of them.
#include "core/study/extremes.h"

#include <gtest/gtest.h>

#include <set>
#include <stop_token>
#include <string>

#include "core/base/error.h"
#include "core/scene/deform_part.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

TEST(Extremes, HasTwoHundredRowsOfDifferentNames) {
    std::set<std::string> names;
    const auto cases = extreme_cases();
    for (const ExtremeCase& extreme : cases) names.insert(extreme.name);
    EXPECT_GE(cases.size(), 200u);
    EXPECT_EQ(names.size(), cases.size());
}

TEST(Extremes, HearAStopInEveryRowThatSteps) {
    std::stop_source stopped;
    stopped.request_stop();
    auto cases = extreme_cases();
    for (const auto& campaign : {touch_cases({.trials = 6, .most_tetrahedra = 300}),
                                 tear_cases({.trials = 4, .most_tetrahedra = 300})})
        cases.insert(cases.end(), campaign.begin(), campaign.end());
    for (const ExtremeCase& extreme : cases) {
        if (extreme.name.starts_with("refuse")) continue;
        EXPECT_THROW(extreme.run(stopped.get_token()), Cancelled) << extreme.name;
    }
}

// The second run of a row went on with the random numbers of the first.
TEST(Extremes, ARowOfACampaignIsTheSameEveryTime) {
    const auto drag =
        touch_cases({.seed = 3, .trials = 5, .steps = 10, .most_tetrahedra = 700}).back();
    const auto pull =
        tear_cases({.seed = 5, .trials = 1, .steps = 10, .most_tetrahedra = 700}).front();
    for (const ExtremeCase& extreme : {drag, pull}) {
        const ExtremeRow first = extreme.run({}), again = extreme.run({});
        EXPECT_GT(first.path_mm, 0.0) << extreme.name;
        EXPECT_EQ(again.path_mm, first.path_mm) << extreme.name;
        EXPECT_EQ(again.energy_made, first.energy_made) << extreme.name;
    }
}

// A sample of the campaign: each kind of play twice, on small trees.
TEST(Extremes, NothingPassesInASampleOfTouch) {
    Job job;
    const auto cases = touch_cases({.seed = 3, .trials = 12, .steps = 60, .most_tetrahedra = 700});
    int touched = 0;
    for (const ExtremeRow& row : run_extremes(cases, "", job)) {
        EXPECT_TRUE(row.survived) << row.name << ": " << row.note;
        touched += row.touched_steps > 0 ? 1 : 0;
    }
    EXPECT_GT(touched, 6);
}

// As `extremes --suite touch --case CASE` has real ones.
TEST(Extremes, NothingPassesInASampleOfTouchOnAPatient) {
    Job job;
    const DeformPart part(*test::small_patient(), DeformSpec{});
    Campaign campaign{.trials = 5, .steps = 40};
    campaign.patients = {std::make_shared<const BodyDescription>(part.body())};
    const std::size_t tetrahedra = part.body().mesh.tetrahedra.size();
    const auto rows = run_extremes(touch_cases(campaign), "", job);
    ASSERT_EQ(rows.size(), 5u);
    int touched = 0;
    for (const ExtremeRow& row : rows) {
        EXPECT_TRUE(row.survived) << row.name << ": " << row.note;
        EXPECT_TRUE(row.name.ends_with(std::to_string(tetrahedra) + " tetrahedra")) << row.name;
        touched += row.touched_steps > 0 ? 1 : 0;
    }
    EXPECT_GT(touched, 1);
}

// A sample of the campaign of tears: each kind of play three times.
TEST(Extremes, EverythingHoldsInASampleOfTears) {
    Job job;
    const auto cases = tear_cases({.seed = 5, .trials = 12, .steps = 90, .most_tetrahedra = 700});
    int torn = 0, splits = 0;
    for (const ExtremeRow& row : run_extremes(cases, "", job)) {
        EXPECT_TRUE(row.survived) << row.name << ": " << row.note;
        torn += row.splits > 0 ? 1 : 0;
        splits += row.splits;
    }
    EXPECT_GT(torn, 6);
    EXPECT_GT(splits, 60);
}

// As `extremes --suite tear --touching` has larger ones.
TEST(Extremes, EverythingHoldsInASampleOfTearsOfWhatTouches) {
    Job job;
    const auto cases =
        tear_cases({.seed = 2, .trials = 8, .steps = 21, .most_tetrahedra = 400, .touching = true});
    int splits = 0;
    for (const ExtremeRow& row : run_extremes(cases, "", job)) {
        EXPECT_NE(row.name.find("touching"), std::string::npos) << row.name;
        EXPECT_TRUE(row.survived) << row.name << ": " << row.note;
        splits += row.splits;
    }
    EXPECT_GT(splits, 5);
}

// As `extremes --suite tear --case CASE` has real ones.
TEST(Extremes, EverythingHoldsInASampleOfTearsOfAPatient) {
    Job job;
    const DeformPart part(*test::small_patient(), DeformSpec{});
    Campaign campaign{.trials = 4, .steps = 25};
    campaign.patients = {std::make_shared<const BodyDescription>(part.body())};
    const std::string tetrahedra = std::to_string(part.body().mesh.tetrahedra.size());
    const auto rows = run_extremes(tear_cases(campaign), "", job);
    ASSERT_EQ(rows.size(), 4u);
    int splits = 0;
    for (const ExtremeRow& row : rows) {
        EXPECT_TRUE(row.survived) << row.name << ": " << row.note;
        EXPECT_TRUE(row.name.ends_with(", " + tetrahedra + " tetrahedra")) << row.name;
        splits += row.splits;
    }
    EXPECT_GT(splits, 10);
}

// What the row is about is a thousandth of the spin.
TEST(Extremes, ASpinThatLosesNothingIsNotTakenForOneThatLosesWhatItShould) {
    ExtremeRun short_run;
    short_run.most_steps = 100;  // a thousandth of those after which it is expected
    for (const ExtremeCase& extreme : extreme_cases()) {
        if (extreme.name.find("spinning") == std::string::npos) continue;
        const ExtremeRow row = extreme.run(short_run);
        EXPECT_GT(row.error, 0.9);
        EXPECT_NE(row.note.find("loss of spin"), std::string::npos) << row.note;
        return;
    }
    FAIL() << "there is no such row";
}

class QuickExtremes : public testing::TestWithParam<const char*> {};

TEST_P(QuickExtremes, Survive) {
    Job job;
    const auto rows = run_extremes(extreme_cases(), GetParam(), job);
    ASSERT_FALSE(rows.empty());
    for (const ExtremeRow& row : rows) EXPECT_TRUE(row.survived) << row.name << ": " << row.note;
}

INSTANTIATE_TEST_SUITE_P(
    All, QuickExtremes,
    testing::Values(
        "refuse", "overflow", "falls", "everything fixed", "beam corotated-10 E=1e+06 dt=0.1",
        "contrast density 1:1e6, heavy tip hexahedron", "sliver corotated-10 angle=0.01",
        "grab jumps 1 m corotated dt=0.001 limit=100000", "gravity x 1000 corotated dt=0.001",
        "beam hexahedron E=1e+06 dt=0.1 nu=0.3", "beam corotated E=1e+06 dt=0.001 nu=0.3",
        "beam spring E=1e+06 dt=0.1 nu=0.3", "stiff root hexahedron automatic dt=1",
        "sliver corotated angle=1 dt=1", "start inverted corotated dt=0.001", "into a block",
        "out of a box corotated", "beam corotated-10 E=1 dt=1e-05 nu=0.3"));

}  // namespace
}  // namespace hepatica
