// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/liver_side.h"

#include <gtest/gtest.h>

#include "core/patient/patient_case.h"

namespace hepatica {
namespace {

// A body of 300 mm with arms of air beside it; x leads to the left.
Volume body() {
    Grid grid;
    grid.dims = {120, 60, 40};
    grid.spacing_mm = Vec3(3, 3, 3);
    Volume ct(grid);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        ct.voxels[i] = x >= 10 && x < 110 && y >= 5 && y < 55 ? 60 : -1000;
    }
    return ct;
}

// A liver of 120 mm on a finer grid of its own, its middle there.
Mask liver_at(double x_mm, std::uint8_t label = organ_label::liver) {
    Mask organs;
    organs.grid.dims = {60, 40, 20};
    organs.grid.spacing_mm = Vec3(2, 2, 2);
    organs.grid.origin_mm = Vec3(x_mm - 59.0, 40, 20);
    organs.voxels.assign(60 * 40 * 20, label);
    return organs;
}

TEST(LiverSide, IsTheRight) {
    const Volume ct = body();
    const double middle = 59.5 * 3.0;
    const auto on_the_left = [&](const Mask& organs) {
        Job job;
        return lies_on_the_left(organs, ct, job);
    };
    EXPECT_FALSE(on_the_left(liver_at(middle - 70.0)));
    EXPECT_FALSE(on_the_left(liver_at(middle))) << "that says nothing";
    EXPECT_FALSE(on_the_left(liver_at(middle + 20.0))) << "a large left lobe alone in the image";
    EXPECT_TRUE(on_the_left(liver_at(middle + 70.0)));
    EXPECT_FALSE(on_the_left(liver_at(middle + 70.0, organ_label::cava))) << "it is no liver";
    EXPECT_FALSE(on_the_left(Mask()));
}

}  // namespace
}  // namespace hepatica
