// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes that wait, as text and back.
#include "core/patient/pending_stroke.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace hepatica {
namespace {

TEST(PendingStrokes, AreTheSameAfterBeingWrittenAndRead) {
    const std::vector<PendingStroke> strokes{
        {{{Vec3(1.25, -2, 1.0 / 3.0)}, 50.0, true}, 0},
        {{{Vec3(0, 0, 0), Vec3(1e-3, 2, 3)}, 0.1, false}, 7},
    };
    EXPECT_EQ(strokes_from_json(strokes_to_json(strokes), "a file"), strokes);
    EXPECT_TRUE(strokes_from_json(strokes_to_json({}), "a file").empty());
}

TEST(PendingStrokes, AreRefusedWhereTheyCannotBeLed) {
    const auto refused = [](const std::string& path, const std::string& radius,
                            const std::string& after) {
        try {
            strokes_from_json(R"([{"path_mm": )" + path + R"(, "radius_mm": )" + radius +
                                  R"(, "erases": false, "after_edits": )" + after + "}]",
                              "left.jsonl");
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), "left.jsonl");
            return true;
        }
        return false;
    };
    EXPECT_FALSE(refused("[[1, 2, 3]]", "2.0", "1"));
    EXPECT_TRUE(refused("[]", "2.0", "1"));
    EXPECT_TRUE(refused("[[1, 2]]", "2.0", "1"));
    EXPECT_TRUE(refused("[[1, 2, 1e9]]", "2.0", "1"));
    EXPECT_TRUE(refused("[[1, 2, 3]]", "0.0", "1"));
    EXPECT_TRUE(refused("[[1, 2, 3]]", "50.1", "1"));
    EXPECT_TRUE(refused("[[1, 2, 3]]", "\"wide\"", "1"));
    EXPECT_TRUE(refused("[[1, 2, 3]]", "2.0", "-1"));
}

}  // namespace
}  // namespace hepatica
