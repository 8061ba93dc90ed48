// SPDX-License-Identifier: GPL-3.0-or-later
// Couinaud's segments of real patients, whose true borders nobody drew: only what is published of
// their sizes is asked. Perfusion volumetry of 107 normal livers (Mise et al., HPB 2014;16:612):
// segment 8 has 11.1 to 38.0 % of the liver, median 26.1 %, and is the largest; 1 is the smallest.
#include <gtest/gtest.h>

#include <numeric>

#include "core/base/error.h"
#include "core/tree/territories/couinaud_segments.h"
#include "tests/reconstruction/real_case.h"

namespace hepatica {

using namespace test;

class RealSegments : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Ircadb01, RealSegments, testing::ValuesIn(real_cases));

TEST_P(RealSegments, HaveSizesThatLiversHave) {
    const auto folder = shared_data() / GetParam();
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    Job job;
    const PatientCase patient = reconstruct(quick_options(folder), job).patient;
    const auto volumes = segment_volumes_ml(patient.couinaud);
    const double all = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    EXPECT_GT(volumes[7], 0.111 * all);
    EXPECT_LT(volumes[7], 0.380 * all);
    for (int k = 1; k < couinaud_count; ++k) EXPECT_LT(volumes[k], 0.380 * all) << k + 1;
    for (int k = 3; k < couinaud_count; ++k) EXPECT_LT(volumes[0], volumes[k]) << k + 1;
    ASSERT_TRUE(patient.doubts->segments.has_value());
    EXPECT_LT(patient.doubts->segments->unsure_share, 0.25);
}

}  // namespace hepatica
