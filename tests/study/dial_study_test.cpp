// SPDX-License-Identifier: GPL-3.0-or-later
// The front of the dial as it is measured on a patient's own body.
#include "core/study/dial_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/scene/setting_json.h"
#include "tests/session/small_patient.h"
#include "tests/support/emulated_back_end.h"

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

// Settings of the device first, then the processor's. The device misses what the processor does
// without tension, which it has no kernels for.
TEST(DialStudy, MeasuresADeviceBesideTheProcessor) {
    const test::EmulatedBackEnd device = test::emulated_back_end();
    DeformBackEnd both = device.back_end;
    both.beside_processor = true;
    // All but one setting of either are known.
    std::vector<QualityPoint> points;
    while (const auto setting = next_dial_setting(points, both)) {
        QualityPoint point{*setting, 5.0 * setting->substeps, 0.2 / setting->substeps, "a formula"};
        if (!setting->on_processor) {
            point.back_end = both.name;
            point.device = both.device;
        }
        point.options.on_processor = false;
        points.push_back(point);
    }
    EXPECT_EQ(points.size(), 12u);
    EXPECT_EQ(points[5].back_end, "cuda-emulated");
    EXPECT_EQ(points[6].back_end, "cpu");
    std::erase_if(points, [](const QualityPoint& p) { return p.options.substeps == 1; });
    const std::size_t known = points.size();

    Job job;
    DialStudy study(small_patient(), points, both);
    ASSERT_TRUE(study.measure_next(job));
    EXPECT_GT(device.device_steps(), 10);
    const long steps = device.device_steps();
    ASSERT_TRUE(study.measure_next(job));  // loosely solved
    while (study.points().back().back_end != "cpu") ASSERT_TRUE(study.measure_next(job));
    const QualityPoint on_device = study.points()[known];
    const QualityPoint on_processor = study.points().back();
    EXPECT_GT(device.device_steps(), steps);
    EXPECT_EQ(on_device.back_end, "cuda-emulated");
    EXPECT_EQ(on_device.device, both.device);
    EXPECT_EQ(on_processor.device, "");
    for (const QualityPoint& point : {on_device, on_processor}) {
        EXPECT_EQ(point.options.substeps, 1);
        EXPECT_FALSE(point.options.on_processor);  // its back end says that
        EXPECT_GT(point.frame_ms, 0.0);
    }
    SceneSpec scene = default_scene();
    scene.flow.reset();
    scene.deform->setting = StepperOptions{};
    HandTrial trial(small_patient(), scene, PlayedRegion::as_in_scenes, job);
    StepperOptions without_tension;
    without_tension.tension = false;
    const double missed = motion_error(trial.play(dial_motion(), without_tension, job).motion,
                                       trial.reference(dial_motion(), 8, job));
    // Either solves to this share of the energy, by solvers of their own.
    EXPECT_NEAR(on_device.error_relative, missed, without_tension.linear.energy_tolerance);
}

TEST(DialStudy, TakesNoStepsOfTheProcessorForThoseOfADevice) {
    const test::EmulatedBackEnd device = test::emulated_back_end();
    device.lose();
    Job job;
    DialStudy study(small_patient(), {}, device.back_end);
    EXPECT_THROW(study.measure_next(job), InputError);
    EXPECT_TRUE(study.points().empty());
}

}  // namespace
}  // namespace hepatica
