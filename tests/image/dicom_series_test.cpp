// SPDX-License-Identifier: GPL-3.0-or-later
// Places of slices on the even grid: what rounding does to them, and what it cannot do.
#include "core/image/dicom_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/image/image_fixtures.h"

namespace hepatica {
namespace {

using namespace testing_support;

std::vector<DicomSlice> slices_at(const std::vector<double>& levels_mm) {
    std::vector<DicomSlice> slices;
    for (const double level_mm : levels_mm) {
        DicomSlice slice;
        slice.file = "slice_" + std::to_string(slices.size());
        slice.rows = slice.columns = 4;
        slice.has_geometry = true;
        slice.position_mm = Vec3(-3.0, 5.0, level_mm);
        slice.row_axis = Vec3::UnitX();
        slice.column_axis = Vec3::UnitY();
        slice.row_spacing_mm = slice.column_spacing_mm = 0.7;
        slices.push_back(slice);
    }
    return slices;
}

// 1 mm apart up to a slice, and another distance from there on.
std::vector<double> levels_that_change(int slices, int at, double later_mm) {
    std::vector<double> levels_mm;
    for (int i = 0; i < slices; ++i)
        levels_mm.push_back(std::min(i, at) + later_mm * std::max(0, i - at));
    return levels_mm;
}

// Every gap is within a tenth of the others; they were read as even, and slices lay up to 6.7 mm
// beside their places.
TEST(DicomSlices, WhoseDistanceChangesSlowlyAreRefusedByTheSliceFurthestAstray) {
    const std::string message =
        refusal([] { order_slices(slices_at(levels_that_change(40, 20, 1.08))); });
    EXPECT_NE(message.find("slice_20: lies where the distance between slices changes: it is 1 mm "
                           "on average up to there, and 1.039 mm in the whole series"),
              std::string::npos)
        << message;
    for (const double later_mm : {0.92, 1.02, 1.05, 1.09})
        EXPECT_NE(refusal([&] {
                      order_slices(slices_at(levels_that_change(301, 151, later_mm)));
                  }).find("slice_151: lies where"),
                  std::string::npos)
            << later_mm;
}

TEST(DicomSlices, OfRoundedPositionsAreEvenHoweverManyThereAre) {
    for (const double spacing_mm : {1.13, 1.25, 2.0 / 1.5, 2.375, 4.96})
        for (const double decimals : {10.0, 1000.0}) {
            std::vector<double> levels_mm;
            for (int i = 0; i < 500; ++i)
                levels_mm.push_back(std::round(spacing_mm * i * decimals) / decimals);
            const OrderedSeries series = order_slices(slices_at(levels_mm));
            EXPECT_NEAR(series.slice_spacing_mm, spacing_mm, 1e-3);
        }
}

}  // namespace
}  // namespace hepatica
