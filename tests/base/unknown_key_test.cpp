// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/unknown_key.h"

#include <gtest/gtest.h>

#include <vector>

namespace hepatica {
namespace {

TEST(UnknownKey, NamesTheKeyThatWasMostLikelyMeant) {
    const std::vector<std::string> known{"where", "by_mm", "over_s", "kitten"};
    const auto nearest = [&](const char* key) { return unknown_key(key, known); };
    EXPECT_EQ(nearest("over"), "is not known; the nearest key is \"over_s\"");
    EXPECT_EQ(nearest("wehre"), "is not known; the nearest key is \"where\"");
    EXPECT_EQ(nearest("bymm"), "is not known; the nearest key is \"by_mm\"");
    EXPECT_EQ(nearest("sitting"), "is not known; the nearest key is \"kitten\"");
    EXPECT_EQ(nearest("whe"), "is not known; the nearest key is \"where\"") << "its beginning";
    EXPECT_EQ(nearest("gravity"), "is not known; choose from where, by_mm, over_s, kitten");
    EXPECT_EQ(nearest(""), "is not known; choose from where, by_mm, over_s, kitten");
    EXPECT_EQ(unknown_key("x", {}), "is not known, and no key is");
}

}  // namespace
}  // namespace hepatica
