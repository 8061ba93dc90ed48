// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_place.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(PatientPlace, IsSaidByLettersAndInWords) {
    const Vec3 here(12.0, 40.2, 155.4), there(-3.0, -7.0, -0.6);
    EXPECT_EQ(patient_place(here), "L 12  P 40  H 155 mm");
    EXPECT_EQ(patient_place(there), "R 3  A 7  F 1 mm");
    EXPECT_EQ(patient_place_in_words(here), "12 mm left, 40 mm back, 155 mm headwards");
    EXPECT_EQ(patient_place_in_words(there, 1), "3.0 mm right, 7.0 mm front, 0.6 mm feetwards");
}

}  // namespace
}  // namespace hepatica
