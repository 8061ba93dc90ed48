// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/given_vessels.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/checks_until.h"

namespace hepatica {
namespace {

LabelMap row_of(const std::vector<std::uint16_t>& labels) {
    Grid grid;
    grid.dims = {static_cast<int>(labels.size()), 1, 1};
    LabelMap map(grid);
    map.voxels = labels;
    return map;
}

std::vector<std::uint8_t> read(const std::vector<std::uint16_t>& labels,
                               const std::vector<VesselLabel>& names = {}) {
    std::vector<std::string> warnings;
    return systems_of_labels(row_of(labels), names, "mask.nii.gz", warnings).voxels;
}

using Voxels = std::vector<std::uint8_t>;

TEST(GivenVessels, ASingleLabelIsAnUnknownSystem) {
    for (const std::uint16_t label : std::vector<std::uint16_t>{1, 2, 64, 255, 4000})
        EXPECT_EQ(read({0, label, 0, label}), (Voxels{0, 255, 0, 255})) << label;
}

TEST(GivenVessels, SeveralLabelsAreSystemsByTheirNumbersAndSaidSo) {
    std::vector<std::string> warnings;
    const Mask mask = systems_of_labels(row_of({2, 0, 1, 255, 3}), {}, "mask.nii.gz", warnings);
    EXPECT_EQ(mask.voxels, (Voxels{2, 0, 1, 255, 3}));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("2 as hepatic veins"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("--vessel-label"), std::string::npos) << warnings[0];
}

TEST(GivenVessels, NamedLabelsAreWhatTheyAreNamedAndTheOthersAreLeftOut) {
    const std::vector<VesselLabel> names{{64, VascularSystem::hepatic},
                                         {900, VascularSystem::portal},
                                         {63, VascularSystem::hepatic},
                                         {8, VascularSystem::unknown}};
    EXPECT_EQ(read({64, 900, 63, 1, 8, 0}, names), (Voxels{2, 1, 2, 0, 255, 0}));
    EXPECT_EQ(read({1, 0}, {{1, VascularSystem::portal}}), (Voxels{1, 0}));
}

TEST(GivenVessels, MoreLabelsThanSystemsAreRefusedInWords) {
    try {
        read({1, 2, 3, 4});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("1, 2, 3, 4"), std::string::npos) << error.problem();
        EXPECT_NE(error.problem().find("1 portal, 2 hepatic"), std::string::npos);
        EXPECT_EQ(error.place(), "mask.nii.gz");
        EXPECT_NE(error.remedy().find("--vessel-label"), std::string::npos);
    }
    EXPECT_THROW(read({0, 0}), InputError);
    EXPECT_THROW(read({5, 6}, {{7, VascularSystem::portal}}), InputError);
}

// A map of a whole CT has a hundred million voxels.
TEST(GivenVessels, CountingAndNamingLabelsHearACancellation) {
    Grid grid;
    grid.dims = {1024, 1024, 3};
    LabelMap map(grid);
    map.voxels.back() = 1;
    std::vector<std::string> warnings;
    const auto checks_until = [&](int last) {
        return test::checks_until(last, [&](Job& job) {
            EXPECT_EQ(systems_of_labels(map, {}, "map.nii.gz", warnings, job).voxels.back(), 255);
        });
    };
    const int whole = checks_until(-1);
    EXPECT_GE(whole, 6);  // a million voxels between two, in two passes
    for (int last = 1; last <= whole; ++last) EXPECT_EQ(checks_until(last), -last);
}

}  // namespace
}  // namespace hepatica
