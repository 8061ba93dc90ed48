// SPDX-License-Identifier: GPL-3.0-or-later
// The front of the dial as it is measured on a patient's own body.
#include "core/study/dial_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/scene/setting_json.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::small_patient;

// What next_dial_setting() asks for where settings cost and miss what a formula says.
std::vector<QualityPoint> filled_front(const std::function<double(const StepperOptions&)>& cost) {
    std::vector<QualityPoint> points;
    while (const auto setting = next_dial_setting(points)) {
        const double loose = setting->linear.energy_tolerance > 0.05 ? 0.02 : 0.0;
        points.push_back({*setting, cost(*setting), 0.2 / setting->substeps + loose, "a formula"});
        if (points.size() > 50) break;
    }
    return points;
}

TEST(DialSettings, BeginWithTheMostUsefulAndAreSixWhereNothingIsMissing) {
    const auto points = filled_front([](const StepperOptions& s) { return 5.0 * s.substeps; });
    ASSERT_EQ(points.size(), 6u);
    EXPECT_TRUE(same_setting(points[0].options, StepperOptions{}));
    EXPECT_EQ(points[1].options.substeps, 2);
}

TEST(DialSettings, FillTheGapsOfACostThatLeaps) {
    const auto leaping = [](const StepperOptions& s) { return std::pow(s.substeps, 3.0); };
    const QualityDial dial(filled_front(leaping));
    const auto front = dial.front();
    EXPECT_GT(front.size(), 6u);
    for (std::size_t i = 1; i < front.size(); ++i) {
        EXPECT_GT(front[i].frame_ms, front[i - 1].frame_ms);
        EXPECT_LT(front[i].error_relative, front[i - 1].error_relative);
        const bool neighbours = front[i].options.substeps == front[i - 1].options.substeps + 1;
        EXPECT_TRUE(neighbours || front[i].frame_ms <= widest_cost_ratio * front[i - 1].frame_ms)
            << front[i - 1].frame_ms << " to " << front[i].frame_ms;
    }
}

TEST(DialStudy, MissesLeastInTheStepsOfItsReferenceAndGoesOnWhereItWasStopped) {
    Job job;
    DialStudy study(small_patient());
    ASSERT_TRUE(study.measure_next(job));
    ASSERT_TRUE(study.measure_next(job));
    ASSERT_EQ(study.points().size(), 2u);
    const QualityPoint &one = study.points()[0], &two = study.points()[1];
    EXPECT_GT(one.frame_ms, 0.0);
    EXPECT_GT(one.error_relative, 0.0);
    EXPECT_LT(one.error_relative, 0.1);
    EXPECT_NE(one.reference.find("8 substeps"), std::string::npos) << one.reference;

    Job stopped;
    stopped.cancel();
    EXPECT_THROW(study.measure_next(stopped), Cancelled);
    EXPECT_EQ(study.points().size(), 2u);

    DialStudy later(small_patient(), study.points());
    while (later.measure_next(job)) {
    }
    EXPECT_GE(later.points().size(), 6u);
    EXPECT_EQ(later.points()[1].frame_ms, two.frame_ms);  // not measured again
    double finest = 1.0;
    for (const QualityPoint& point : later.points())
        if (point.options.substeps == 8) finest = point.error_relative;
    // The setting of the reference misses what the region and the solver's tolerance leave out.
    EXPECT_LT(finest, 0.5 * one.error_relative);
    EXPECT_FALSE(later.measure_next(stopped));  // without any work
}

}  // namespace
}  // namespace hepatica
