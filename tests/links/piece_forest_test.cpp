// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/links/piece_forest.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "core/base/error.h"

namespace hepatica {
namespace {

// Feature 1 at 2.5: 0.2 up to it, else feature 0 at -1: 0.6 or 1.
std::vector<ForestNode> small_tree() {
    return {
        {1, 2.5, 1, 2}, {-1, 0.2, -1, -1}, {0, -1.0, 3, 4}, {-1, 0.6, -1, -1}, {-1, 1.0, -1, -1}};
}

PieceFeatures features_of(float first, float second) {
    PieceFeatures features{};
    features[0] = first;
    features[1] = second;
    return features;
}

TEST(PieceForest, WalksByItsThresholds) {
    const PieceForest forest{{small_tree()}};
    EXPECT_DOUBLE_EQ(forest.share_of_vessel(features_of(9.0f, 2.5f)), 0.2);  // up to is below
    EXPECT_DOUBLE_EQ(forest.share_of_vessel(features_of(-1.0f, 2.6f)), 0.6);
    EXPECT_DOUBLE_EQ(forest.share_of_vessel(features_of(-0.9f, 2.6f)), 1.0);
}

TEST(PieceForest, IsTheMeanOfItsTrees) {
    const PieceForest forest{{small_tree(), {{-1, 0.5, -1, -1}}}};
    EXPECT_DOUBLE_EQ(forest.share_of_vessel(features_of(0.0f, 0.0f)), 0.35);
    EXPECT_DOUBLE_EQ(PieceForest{}.share_of_vessel(features_of(0.0f, 0.0f)), 0.0);
}

TEST(PieceForest, AWrongNodeIsRefusedByItsName) {
    const auto count = static_cast<int>(piece_feature_names.size());
    const std::vector<std::function<void(std::vector<ForestNode>&)>> faults{
        [](auto& tree) { tree[2].above = 2; },   // leads to itself
        [](auto& tree) { tree[2].up_to = 0; },   // leads back
        [](auto& tree) { tree[2].above = 5; },   // leads out
        [](auto& tree) { tree[2].up_to = -1; },  // leads nowhere
        [&](auto& tree) { tree[2].feature = count; },
        [](auto& tree) { tree[2].value = std::numeric_limits<double>::quiet_NaN(); }};
    PieceForest whole{{{{-1, 0.5, -1, -1}}, small_tree()}};
    EXPECT_NO_THROW(validate(whole, "links.json"));
    for (std::size_t i = 0; i < faults.size(); ++i) {
        PieceForest broken = whole;
        faults[i](broken.trees[1]);
        try {
            validate(broken, "links.json");
            ADD_FAILURE() << "fault " << i << " was not refused";
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find("node 2 of tree 1"), std::string::npos);
            EXPECT_EQ(error.place(), "links.json");
        }
    }
    for (const double share : {-0.1, 1.1}) {
        PieceForest broken = whole;
        broken.trees[0][0].value = share;
        EXPECT_THROW(validate(broken, "links.json"), InputError);
    }
    whole.trees.emplace_back();
    EXPECT_THROW(validate(whole, "links.json"), InputError);
}

}  // namespace
}  // namespace hepatica
