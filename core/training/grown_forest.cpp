// SPDX-License-Identifier: GPL-3.0-or-later
// Trains OpenCV's random trees with a fixed random state and copies them into plain arrays.
#include "core/training/grown_forest.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/ml.hpp>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace hepatica {

namespace {

// Rounds a number as the model's file does, so that a forest that was read gives the same results
// as the trained one.
double as_written(double value) {
    return std::strtod(number_text(value).c_str(), nullptr);
}

// The library uses one random generator per thread. This replaces it by a known one for its
// lifetime.
class KnownDraws {
  public:
    KnownDraws() : before_(cv::theRNG()) { cv::theRNG() = cv::RNG(); }
    ~KnownDraws() { cv::theRNG() = before_; }
    KnownDraws(const KnownDraws&) = delete;
    KnownDraws& operator=(const KnownDraws&) = delete;

  private:
    cv::RNG before_;
};

// Copies a node and its subtree; returns the index of its copy.
int append(const cv::ml::DTrees& grown, int id, std::vector<ForestNode>& tree) {
    const cv::ml::DTrees::Node& node = grown.getNodes()[id];
    const auto at = static_cast<int>(tree.size());
    tree.emplace_back();
    if (node.split < 0) {
        tree[at].value = as_written(std::clamp(node.value, 0.0, 1.0));
        return at;
    }
    const cv::ml::DTrees::Split& split = grown.getSplits()[node.split];
    tree[at].feature = split.varIdx;
    tree[at].value = as_written(split.c);
    const int left = append(grown, node.left, tree);
    const int right = append(grown, node.right, tree);
    tree[at].up_to = split.inversed ? right : left;
    tree[at].above = split.inversed ? left : right;
    return at;
}

}  // namespace

PieceForest grown_forest(std::span<const TaughtPiece> pieces, const ForestOptions& options) {
    constexpr auto columns = static_cast<int>(piece_feature_names.size());
    const auto rows = static_cast<int>(pieces.size());
    cv::Mat samples(rows, columns, CV_32F), shares(rows, 1, CV_32F);
    for (int i = 0; i < rows; ++i) {
        for (int k = 0; k < columns; ++k) {
            const float value = pieces[i].features[k];
            if (!std::isfinite(value))
                throw InputError("feature \"" + std::string(piece_feature_names[k]) +
                                     "\" of a piece is no number",
                                 "training", "Report this as a bug");
            samples.at<float>(i, k) = value;
        }
        shares.at<float>(i) = pieces[i].share;
    }
    const auto forest = cv::ml::RTrees::create();
    forest->setMaxDepth(options.depth);
    forest->setMinSampleCount(options.least_in_leaf);
    forest->setRegressionAccuracy(0.0f);
    forest->setActiveVarCount(options.features_a_split);
    forest->setTermCriteria({cv::TermCriteria::MAX_ITER, options.trees, 0.0});
    const KnownDraws known;
    forest->train(samples, cv::ml::ROW_SAMPLE, shares);
    PieceForest copy;
    for (const int root : forest->getRoots()) append(*forest, root, copy.trees.emplace_back());
    return copy;
}

}  // namespace hepatica
