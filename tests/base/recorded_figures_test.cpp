// SPDX-License-Identifier: GPL-3.0-or-later
// What a figure says that is not the one recorded.
#include "tests/support/recorded_figures.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace hepatica {
namespace {

TEST(RecordedFigures, SayWithWhichCommandTheyAreRecordedAnew) {
    if (std::getenv("HEPATICA_UPDATE_BASELINES")) GTEST_SKIP() << "figures are being recorded";
    test::Figures figures;
    figures.add("figure", 1.0);
    EXPECT_NONFATAL_FAILURE(test::expect_recorded("base", "nothing", figures),
                            "base_tests --gtest_filter="
                            "RecordedFigures.SayWithWhichCommandTheyAreRecordedAnew");
}

}  // namespace
}  // namespace hepatica
