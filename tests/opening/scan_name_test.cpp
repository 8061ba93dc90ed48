// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/scan_name.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(ScanName, IsThatOfTheFolder) {
    EXPECT_EQ(name_of_scan("/scans/anton"), "anton");
    EXPECT_EQ(name_of_scan("/scans/anton/"), "anton");
    EXPECT_EQ(name_of_scan("/scans/DICOM of anton"), "DICOM of anton");
    EXPECT_EQ(name_of_scan("/scans/ct-7"), "ct-7") << "somebody named it";
}

// As ircadb and TotalSegmentator lay out their patients, and as discs do.
TEST(ScanName, IsThatOfTheFolderAboveWhereEveryPatientHasOneOfTheSameName) {
    EXPECT_EQ(name_of_scan("/data/ircadb01_case07/PATIENT_DICOM"), "ircadb01_case07");
    EXPECT_EQ(name_of_scan("/data/totalseg/dicom"), "totalseg");
    for (const char* own : {"ct", "CT", "Images", "img", "series", "DICOMDIR", "DICOM/images/"})
        EXPECT_EQ(name_of_scan("/scans/anton/" + std::string(own)), "anton") << own;
}

// A number alone says little, and yet tells two patients of one study apart.
TEST(ScanName, KeepsNumbersBehindTheFolderAbove) {
    EXPECT_EQ(name_of_scan("/scans/totalseg/S0001/ct"), "totalseg S0001");
    EXPECT_EQ(name_of_scan("/scans/anton/42"), "anton 42");
    EXPECT_EQ(name_of_scan("/scans/anton/DICOM/ST000001/SE000002"), "anton ST000001 SE000002");
    EXPECT_EQ(name_of_scan("/scans/p07"), "p07") << "of no writer of DICOM";
}

// Which would be nobody's scan, or tell whose it is.
TEST(ScanName, IsNeverThatOfAUserADiscOrADownload) {
    for (const char* above : {"/home/jdoe", "/home/jdoe/Downloads", "/media/jdoe/MUELLER_HANS",
                              "/run/media/jdoe/MUELLER_HANS", "/mnt/disc", "/scratch"}) {
        EXPECT_EQ(name_of_scan(std::string(above) + "/DICOM"), "DICOM") << above;
        EXPECT_EQ(name_of_scan(std::string(above) + "/anton/DICOM"), "anton") << above;
    }
}

TEST(ScanName, StaysWhereNoFolderAboveSaysMore) {
    EXPECT_EQ(name_of_scan("/DICOM"), "DICOM");
    EXPECT_EQ(name_of_scan("dicom"), "dicom");
    EXPECT_EQ(name_of_scan("/DICOM/1"), "1");
    EXPECT_EQ(name_of_scan(""), "");
}

}  // namespace
}  // namespace hepatica
