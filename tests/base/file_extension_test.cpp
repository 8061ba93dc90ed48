// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_extension.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(FileExtension, IsTheLastOneInSmallLetters) {
    EXPECT_EQ(extension_of("TREE.SWC"), ".swc");
    EXPECT_EQ(extension_of("Scan.Nii.gZ"), ".gz");
    EXPECT_EQ(extension_of("A.B/tree.json"), ".json");
    EXPECT_EQ(extension_of("A.B/TREE"), "");
    EXPECT_EQ(extension_of("x.\xc3\x84z"), ".\xc3\x84z") << "letters of ASCII alone";
}

}  // namespace
}  // namespace hepatica
