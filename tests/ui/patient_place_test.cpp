// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_place.h"

#include <gtest/gtest.h>

#include <QLocale>

#include "core/base/patient_space.h"
#include "ui/message_bar.h"

namespace hepatica {
namespace {

TEST(PatientPlace, IsSaidByLettersAndInWords) {
    const Vec3 here(12.0, 40.2, 155.4), there(-3.0, -7.0, -0.6);
    EXPECT_EQ(patient_place(here), "L 12  P 40  H 155 mm");
    EXPECT_EQ(patient_place(there), "R 3  A 7  F 1 mm");
    EXPECT_EQ(patient_place_in_words(here), "12 mm left, 40 mm back, 155 mm headwards");
    EXPECT_EQ(patient_place_in_words(there, 1), "3.0 mm right, 7.0 mm front, 0.6 mm feetwards");
}

TEST(PatientPlace, IsReadAsItIsWritten) {
    for (const Vec3& place : {Vec3(12.0, 40.2, 155.4), Vec3(-3.0, -7.1, -0.6), Vec3::Zero().eval()})
        for (const QLocale::Language language : {QLocale::English, QLocale::German}) {
            const QLocale before;
            QLocale::setDefault(QLocale(language));
            const QString text = patient_place(place, 1);
            QLocale::setDefault(before);
            const auto read = read_patient_place(text);
            ASSERT_TRUE(read) << text.toStdString();
            EXPECT_LT((*read - place).norm(), 1e-9) << text.toStdString();
        }
    EXPECT_EQ(read_patient_place("-1,5 2 3.25"), Vec3(-1.5, 2.0, 3.25));
    for (const char* other : {"", "1 2", "1 2 3 4", "L 1 L 2 H 3", "P 1 L 2 H 3", "L -1 P 2 H 3",
                              "L 1 P 2 H 3 cm", "a b c"})
        EXPECT_FALSE(read_patient_place(other)) << other;
}

TEST(PatientPlace, IsReadFromTheMessagesOfCore) {
    for (const Vec3& place : {Vec3(136.3, 117.2, 123.2), Vec3(-0.5, 0.0, -1200.1)}) {
        const auto read = position_of(place_text(place));
        ASSERT_TRUE(read);
        EXPECT_LT((*read - place).norm(), 1e-9);
    }
    for (const char* other : {"", "the list", "1.5 mm", "1.0, 2.0, 3.0", "/ct/1.0, 2.0, 3.0 mm"})
        EXPECT_FALSE(position_of(other)) << other;
}

TEST(PatientPlace, IsSaidInWordsWhereverATextHoldsOne) {
    EXPECT_EQ(
        places_in_words("An end (1.5, -2.0, 3.0 mm), and one at -1.0, 0.0, -30.6 mm, of 3.2 mm"),
        "An end (2 mm left, 2 mm front, 3 mm headwards), and one at 1 mm right, 0 mm back, "
        "31 mm feetwards, of 3.2 mm");
    for (const char* other : {"", "of 1.5 mm", "1.0, 2.0, 3.0", "1.2.0, 2.0, 3.0 mm"})
        EXPECT_EQ(places_in_words(other), other);
}

// Everybody knows left and right, and nobody the axes.
TEST(PatientPlace, OfAFailureIsSaidInWords) {
    const std::string place = place_text(Vec3(136.3, -117.2, 123.2));
    EXPECT_EQ(lines_of({"too far", place, "Point between them"}).join("\n"),
              "Too far\nat 136 mm left, 117 mm front, 123 mm headwards\nPoint between them");
    EXPECT_EQ(lines_of({"unreadable", "/ct/1.nii", ""}).join("\n"), "Unreadable\nin /ct/1.nii");
}

}  // namespace
}  // namespace hepatica
