// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/quoted_name.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

namespace hepatica {
namespace {

TEST(QuotedName, CanBeLeftOutOfASentence) {
    const std::string sentence =
        "Read " + quoted_name("MUELLER^ANNA") + " and left out " + quoted_name("a”b“c") + " twice";
    EXPECT_NE(sentence.find("MUELLER^ANNA"), std::string::npos);
    EXPECT_EQ(without_names(sentence), "Read “…” and left out “…” twice");
    EXPECT_EQ(without_names("nothing to hide"), "nothing to hide");
    EXPECT_EQ(without_names("an “open one"), "an “open one");
}

// No name can end its own quotation.
TEST(QuotedName, OfAnyBytesIsLeftOutWhole) {
    std::mt19937 chance(3);
    const std::string_view bytes("\xe2\x80\x9c\x9d_", 5);
    for (int trial = 0; trial < 20000; ++trial) {
        std::string name;
        for (int i = 0; i < 12; ++i) name += bytes[chance() % bytes.size()];
        const std::string text = "<" + quoted_name(name) + ">";
        EXPECT_EQ(without_names(text), "<“…”>");
        EXPECT_TRUE(is_utf8(text));
    }
}

// The JSON library refuses what is no UTF-8.
TEST(Utf8, IsToldApartAsTheJsonLibraryDoes) {
    std::mt19937 chance(4);
    const std::string_view starts(
        "a\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\xed\xa0\x80\xff\xc0\xf4\x90\xe0\xc2\xdf\xbf\xef\x8f",
        23);
    int valid = 0;
    for (int trial = 0; trial < 50000; ++trial) {
        std::string text;
        for (unsigned i = 0, size = 1 + chance() % 4; i < size; ++i)
            text += starts[chance() % starts.size()];
        bool accepted = true;
        try {
            (void)nlohmann::json(text).dump();
        } catch (const nlohmann::json::exception&) {
            accepted = false;
        }
        EXPECT_EQ(is_utf8(text), accepted);
        EXPECT_NO_THROW((void)nlohmann::json(as_utf8(text)).dump());
        EXPECT_EQ(as_utf8(text) == text, accepted);
        valid += accepted;
    }
    EXPECT_GT(valid, 1000);
    EXPECT_LT(valid, 45000);
}

}  // namespace
}  // namespace hepatica
