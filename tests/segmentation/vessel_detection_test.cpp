// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels in noise by either method that works in three dimensions, and the user's window.
#include "core/segmentation/vessel_detection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "tests/support/falls_of_progress.h"
#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

Grid detection_grid() {
    Grid grid;
    grid.dims = {64, 48, 48};
    grid.spacing_mm = Vec3::Constant(0.8);
    return grid;
}

// A vessel of 2 mm radius bent through the volume and a straight one of 1.2 mm.
double from_axis(const Vec3& p) {
    return std::hypot(p.y() - 14.0 - 4.0 * std::sin(0.1 * p.x()), p.z() - 12.0);
}
bool in_vessel(const Vec3& p) {
    return from_axis(p) < 2.0 || std::hypot(p.y() - 26.0, p.z() - 27.0) < 1.2;
}

LiverFrame noisy_frame() {
    LiverFrame frame{FloatVolume(detection_grid()), Mask(detection_grid(), 1)};
    std::mt19937_64 random(6);
    for (std::size_t i = 0; i < frame.intensity.voxels.size(); ++i) {
        const auto [x, y, z] = detection_grid().index_of(i);
        double noise = 0.0;
        for (int k = 0; k < 3; ++k) noise += 2.0 * test::uniform(random) - 1.0;  // deviation 1
        frame.intensity.voxels[i] = static_cast<float>(
            110.0 + 10.0 * noise + (in_vessel(detection_grid().to_mm(x, y, z)) ? 70.0 : 0.0));
    }
    return frame;
}

TEST(DetectVessels, FindsThinVesselsInNoise) {
    const LiverFrame frame = noisy_frame();
    Job job;
    const TissueContrast tissue = measure_tissue(frame.intensity, frame.liver, job);
    for (const auto method : {SegmentationMethod::coherent, SegmentationMethod::vesselness}) {
        const Detection found =
            detect_vessels(tissue, frame.liver, Vec3::Constant(0.8), {.method = method}, job);
        double both = 0, vessels = 0, detected = 0, far = 0;
        for (std::size_t i = 0; i < found.vessels.voxels.size(); ++i) {
            const auto [x, y, z] = detection_grid().index_of(i);
            const Vec3 p = detection_grid().to_mm(x, y, z);
            const bool truth = in_vessel(p), seen = found.vessels.voxels[i] != 0;
            both += truth && seen;
            vessels += truth;
            detected += seen;
            far += seen && from_axis(p) > 4.0 && std::hypot(p.y() - 26.0, p.z() - 27.0) > 3.2;
        }
        EXPECT_GT(2.0 * both / (vessels + detected), 0.85) << static_cast<int>(method);
        EXPECT_LT(far, 0.03 * detected) << static_cast<int>(method);
    }
}

TEST(DetectVessels, ItsProgressNeverFallsBack) {
    const LiverFrame frame = noisy_frame();
    Job setup;
    const TissueContrast tissue = measure_tissue(frame.intensity, frame.liver, setup);
    TissueContrast in_window = tissue;
    apply_window(frame, {140.0, 300.0}, in_window);
    for (const auto method : {SegmentationMethod::coherent, SegmentationMethod::vesselness,
                              SegmentationMethod::multi_layer})
        for (const TissueContrast* contrast :
             std::array<const TissueContrast*, 2>{&tissue, &in_window}) {
            Job job;
            job.begin_stage("detect");
            const test::FallsOfProgress falls(job);
            detect_vessels(*contrast, frame.liver, Vec3::Constant(0.8), {.method = method}, job);
            EXPECT_TRUE(falls.stages().empty()) << static_cast<int>(method);
            EXPECT_NEAR(job.progress().fraction, 1.0, 1e-9) << static_cast<int>(method);
            Job doubting;
            doubting.begin_stage("detect");
            const test::FallsOfProgress back(doubting);
            detect_vessels(*contrast, frame.liver, Vec3::Constant(0.8),
                           {.method = method, .doubtful_share = 0.75}, doubting);
            EXPECT_TRUE(back.stages().empty()) << static_cast<int>(method);
            EXPECT_NEAR(doubting.progress().fraction, 1.0, 1e-9) << static_cast<int>(method);
        }
}

TEST(DetectVessels, FindsNothingInNoiseAlone) {
    LiverFrame frame = noisy_frame();
    for (std::size_t i = 0; i < frame.intensity.voxels.size(); ++i) {
        const auto [x, y, z] = detection_grid().index_of(i);
        if (in_vessel(detection_grid().to_mm(x, y, z))) frame.intensity.voxels[i] -= 70.0f;
    }
    Job job;
    const TissueContrast tissue = measure_tissue(frame.intensity, frame.liver, job);
    const Detection found = detect_vessels(tissue, frame.liver, Vec3::Constant(0.8), {}, job);
    EXPECT_EQ(std::count(found.vessels.voxels.begin(), found.vessels.voxels.end(), 1), 0);
}

TEST(ApplyWindow, MeasuresFromOneLevelAndDropsWhatIsTooBright) {
    LiverFrame frame = noisy_frame();
    frame.liver.voxels[7] = 0;
    frame.intensity.voxels[8] = 250.0f;
    frame.intensity.voxels[9] = 250.5f;
    Job job;
    TissueContrast tissue = measure_tissue(frame.intensity, frame.liver, job);
    tissue.parenchyma_hu = 100.0;
    apply_window(frame, {130.0, 250.0}, tissue);
    EXPECT_EQ(tissue.threshold_hu, 30.0);
    EXPECT_EQ(tissue.excess.voxels[7], 0.0f);
    EXPECT_EQ(tissue.excess.voxels[8], 150.0f);
    EXPECT_EQ(tissue.excess.voxels[9], 0.0f);
    for (std::size_t i = 10; i < 1000; ++i)
        ASSERT_FLOAT_EQ(tissue.excess.voxels[i], frame.intensity.voxels[i] - 100.0f);
    for (const auto& wrong : {std::pair{130.0, 130.0}, {140.0, 130.0}, {std::nan(""), 130.0}})
        EXPECT_THROW(apply_window(frame, wrong, tissue), InputError);
}

// Without contrast medium vessels are darker than the tissue: most of the liver is brighter than
// the window then, and none of that is a vessel.
TEST(ApplyWindow, BelowTheTissueTakesInNothingBrighter) {
    const LiverFrame frame = noisy_frame();
    Job job;
    TissueContrast tissue = measure_tissue(frame.intensity, frame.liver, job);
    apply_window(frame, {90.0, 100.0}, tissue);
    ASSERT_LT(*tissue.threshold_hu, -10.0);
    std::size_t within = 0;
    for (std::size_t i = 0; i < tissue.excess.voxels.size(); ++i) {
        const float hu = frame.intensity.voxels[i];
        if (std::abs(hu - 90.0f) < 1e-3f) continue;  // rounding decides
        const bool taken = tissue.excess.voxels[i] > static_cast<float>(*tissue.threshold_hu);
        ASSERT_EQ(taken, hu > 90.0f && hu <= 100.0f) << hu << " HU";
        within += taken;
    }
    EXPECT_GT(within, 1000u);
}

}  // namespace
}  // namespace hepatica
