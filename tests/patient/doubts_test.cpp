// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/doubts.h"

#include <gtest/gtest.h>

#include "core/patient/doubts_json.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

TEST(Doubts, ASureTreeHasNone) {
    VesselTree tree = test::forked_tree();
    for (VesselSegment& segment : tree.segments) {
        segment.system = VascularSystem::portal;
        segment.system_confidence = 1.0;
    }
    const Doubts doubts = doubts_of(tree);
    EXPECT_EQ(doubts.uncertain_share, 0.0);
    EXPECT_EQ(doubts.unknown_share, 0.0);
    EXPECT_TRUE(sentences(doubts).empty());
}

TEST(Doubts, SharesAreThoseOfTheLength) {
    VesselTree tree = test::forked_tree();
    for (VesselSegment& segment : tree.segments) {
        segment.system = VascularSystem::hepatic;
        segment.system_confidence = 0.8;  // just enough
    }
    tree.segments[1].system_confidence = 0.79;
    tree.segments[2].system = VascularSystem::unknown;
    tree.segments[2].system_confidence = 0.0;
    const Doubts doubts = doubts_of(tree);
    const double whole = length_mm(tree);
    EXPECT_NEAR(doubts.unknown_share, length_mm(tree.segments[2]) / whole, 1e-12);
    EXPECT_NEAR(doubts.uncertain_share,
                (length_mm(tree.segments[1]) + length_mm(tree.segments[2])) / whole, 1e-12);
    EXPECT_EQ(sentences(doubts).size(), 2u);
}

TEST(Doubts, DimVesselsAndLoopsAreToldWithWhatWouldHelp) {
    Doubts doubts{.contrast_hu = 34.0, .noise_hu = 10.0, .opened_loops = 1, .loops = 2};
    const auto told = sentences(doubts);
    ASSERT_EQ(told.size(), 3u);
    EXPECT_NE(told[0].find("34 HU"), std::string::npos);
    EXPECT_NE(told[0].find("portal venous phase"), std::string::npos);
    EXPECT_NE(told[1].find("1 loop "), std::string::npos);
    EXPECT_NE(told[2].find("2 loops are"), std::string::npos);
    doubts.contrast_hu = 36.0;
    EXPECT_EQ(sentences(doubts).size(), 2u);
}

// A loop that was cut since is none any more, and one that was closed is one.
TEST(Doubts, OfACorrectedTreeHaveItsOwnLoops) {
    const auto told_of = [](int loops_of_tree, int loops_of_reconstruction) {
        VesselTree tree = test::forked_tree();
        for (int i = 0; i < loops_of_tree; ++i)
            tree.segments[static_cast<std::size_t>(i) + 1].closes_loop = true;
        return sentences(Doubts{.loops = loops_of_reconstruction}, tree);
    };
    EXPECT_TRUE(told_of(0, 2).empty());
    ASSERT_EQ(told_of(2, 0).size(), 1u);
    EXPECT_NE(told_of(2, 0)[0].find("2 loops are left"), std::string::npos);
    EXPECT_EQ(sentences(std::nullopt, test::forked_tree()).size(), 0u);
}

TEST(Doubts, AreTheSameAfterBeingWrittenAndRead) {
    const Doubts doubts{31.5, 9.25, 1.6, 0.25, 0.125, 3, 1};
    const Doubts again = doubts_from(json_of(doubts));
    EXPECT_EQ(json_of(again), json_of(doubts));
    EXPECT_EQ(json_of(doubts).at("in_words").size(), sentences(doubts).size());
}

}  // namespace
}  // namespace hepatica
