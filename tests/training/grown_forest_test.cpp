// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/training/grown_forest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/ml.hpp>
#include <random>

#include "core/base/error.h"

namespace hepatica {
namespace {

constexpr auto columns = static_cast<int>(piece_feature_names.size());

// Pieces whose share rises with two of their features; the others are noise.
std::vector<TaughtPiece> random_pieces(int count, unsigned seed) {
    std::mt19937 random(seed);
    const auto draw = [&] { return static_cast<float>(random() % 10000) / 10000.0f; };
    std::vector<TaughtPiece> pieces(static_cast<std::size_t>(count));
    for (TaughtPiece& piece : pieces) {
        for (float& value : piece.features) value = draw();
        piece.share = piece.features[4] + piece.features[9] > 1.0f ? 1.0f : 0.1f;
    }
    return pieces;
}

TEST(GrownForest, LearnsWhatDecides) {
    const PieceForest forest = grown_forest(random_pieces(4000, 1), ForestOptions{});
    EXPECT_EQ(forest.trees.size(), 60u);
    EXPECT_NO_THROW(validate(forest, "grown"));
    int right = 0;
    const auto unseen = random_pieces(1000, 2);
    for (const TaughtPiece& piece : unseen)
        right += (forest.share_of_vessel(piece.features) > 0.55) == (piece.share > 0.55f);
    EXPECT_GE(right, 930);
}

// The library's own walk through the same forest.
TEST(GrownForest, IsWalkedAsTheLibraryWalksIt) {
    const auto pieces = random_pieces(1500, 3);
    const ForestOptions options{.trees = 12, .depth = 6, .least_in_leaf = 10};
    const PieceForest forest = grown_forest(pieces, options);
    cv::Mat samples(static_cast<int>(pieces.size()), columns, CV_32F);
    cv::Mat shares(static_cast<int>(pieces.size()), 1, CV_32F);
    for (int i = 0; i < samples.rows; ++i) {
        for (int k = 0; k < columns; ++k) samples.at<float>(i, k) = pieces[i].features[k];
        shares.at<float>(i) = pieces[i].share;
    }
    const auto theirs = cv::ml::RTrees::create();
    theirs->setMaxDepth(options.depth);
    theirs->setMinSampleCount(options.least_in_leaf);
    theirs->setRegressionAccuracy(0.0f);
    theirs->setActiveVarCount(options.features_a_split);
    theirs->setTermCriteria({cv::TermCriteria::MAX_ITER, options.trees, 0.0});
    cv::theRNG() = cv::RNG();
    theirs->train(samples, cv::ml::ROW_SAMPLE, shares);
    cv::Mat answers;
    theirs->predict(samples, answers);
    for (int i = 0; i < samples.rows; ++i)
        EXPECT_NEAR(forest.share_of_vessel(pieces[i].features), answers.at<float>(i), 1e-5);
}

TEST(GrownForest, IsTheSameEachTimeAndLeavesOthersDrawsAlone) {
    cv::theRNG().state = 12345;
    const auto pieces = random_pieces(600, 4);
    const ForestOptions options{.trees = 5};
    const PieceForest one = grown_forest(pieces, options), other = grown_forest(pieces, options);
    EXPECT_EQ(cv::theRNG().state, 12345u);
    ASSERT_EQ(one.trees.size(), other.trees.size());
    for (std::size_t t = 0; t < one.trees.size(); ++t) {
        ASSERT_EQ(one.trees[t].size(), other.trees[t].size());
        EXPECT_GT(one.trees[t].size(), 3u);
        for (std::size_t i = 0; i < one.trees[t].size(); ++i) {
            EXPECT_EQ(one.trees[t][i].feature, other.trees[t][i].feature);
            EXPECT_EQ(one.trees[t][i].value, other.trees[t][i].value);
        }
    }
}

TEST(GrownForest, RefusesWhatIsNoNumber) {
    auto pieces = random_pieces(300, 5);
    pieces[7].features[11] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(grown_forest(pieces, ForestOptions{}), InputError);
}

}  // namespace
}  // namespace hepatica
