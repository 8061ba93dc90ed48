// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/csv_cell.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace hepatica {
namespace {

// RFC 4180, 2.5 to 2.7: quoted, and a quotation mark within is written twice.
TEST(CsvCell, HoldsWhateverIsInAText) {
    EXPECT_EQ(csv_cell(std::string()), "\"\"");
    EXPECT_EQ(csv_cell(std::string("left, lateral\nbranch")), "\"left, lateral\nbranch\"");
    EXPECT_EQ(csv_cell(std::string("the \"cut\"")), "\"the \"\"cut\"\"\"");
}

TEST(CsvCell, OfANumberIsReadBackToTheBit) {
    for (const double value : {0.1, -1.0 / 3.0, 1e300, std::numeric_limits<double>::min()})
        EXPECT_EQ(std::stod(csv_cell(value)), value);
    EXPECT_EQ(csv_cell(0.5), "0.5");
}

TEST(CsvCell, OfWhatIsNotKnownIsEmpty) {
    EXPECT_EQ(csv_cell(std::numeric_limits<double>::quiet_NaN()), "");
    EXPECT_EQ(csv_cell(-std::numeric_limits<double>::infinity()), "");
}

}  // namespace
}  // namespace hepatica
