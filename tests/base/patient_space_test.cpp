// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/patient_space.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(PlaceText, IsToATenthOfAMillimetreWithItsUnit) {
    EXPECT_EQ(place_text(Vec3(12.34, -5.06, 1000.0)), "12.3, -5.1, 1000.0 mm");
    EXPECT_EQ(place_text(Vec3(-0.04, 0.04, -0.05)), "0.0, 0.0, -0.1 mm");
}

}  // namespace
}  // namespace hepatica
