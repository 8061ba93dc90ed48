// SPDX-License-Identifier: GPL-3.0-or-later
// Scans that show no liver, or no contrast, are refused in words, whatever the method, and never
// become a tree.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/vessel_segmentation.h"
#include "tests/support/other_bodies.h"

namespace hepatica {
namespace {

// Problem and remedy of the refusal; empty where there was none.
std::string refusal(const Volume& ct, SegmentationMethod method) {
    SegmentationOptions options;
    options.method = method;
    options.spacing_mm = 1.4;
    Job job;
    try {
        const Segmentation found = segment_vessels(ct, options, job);
        ADD_FAILURE() << "a tree in what has " << found.statistics.parenchyma_hu << " HU, "
                      << found.statistics.contrast_hu() << " HU above it";
        return "";
    } catch (const InputError& error) {
        EXPECT_FALSE(error.remedy().empty());
        return error.problem() + " " + error.remedy();
    }
}

class OtherBodies : public testing::TestWithParam<SegmentationMethod> {};

INSTANTIATE_TEST_SUITE_P(Methods, OtherBodies,
                         testing::Values(SegmentationMethod::coherent,
                                         SegmentationMethod::multi_layer,
                                         SegmentationMethod::vesselness));

TEST_P(OtherBodies, AWaterPhantomIsNoLiver) {
    EXPECT_NE(refusal(test::water_phantom(), GetParam()).find("no liver"), std::string::npos);
}

TEST_P(OtherBodies, AHeadIsNoLiver) {
    for (const bool contrast : {false, true})
        EXPECT_NE(refusal(test::head(contrast), GetParam()).find("brain"), std::string::npos)
            << contrast;
}

TEST_P(OtherBodies, AChestIsNoLiver) {
    const std::string said = refusal(test::chest(), GetParam());
    EXPECT_NE(said.find("no liver"), std::string::npos) << said;
}

TEST_P(OtherBodies, AnAbdomenWithoutContrastHasNoVessels) {
    PhantomOptions options;
    options.dims = {128, 128, 96};
    options.spacing_mm = Vec3(1.6, 1.6, 1.7);
    options.generations = 4;
    options.contrast_hu = 0.0;
    options.parenchyma_hu = 60.0;
    Job job;
    const std::string said = refusal(make_phantom(options, job).ct, GetParam());
    EXPECT_NE(said.find("contrast medium"), std::string::npos) << said;
}

}  // namespace
}  // namespace hepatica
