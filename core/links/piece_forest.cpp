// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates a regression forest and checks its structure.
#include "core/links/piece_forest.h"

#include <cmath>
#include <string>

#include "core/base/error.h"

namespace hepatica {

double PieceForest::share_of_vessel(const PieceFeatures& features) const {
    if (trees.empty()) return 0.0;
    double sum = 0.0;
    for (const std::vector<ForestNode>& tree : trees) {
        const ForestNode* at = &tree.front();
        while (at->feature >= 0)
            at = &tree[features[at->feature] <= at->value ? at->up_to : at->above];
        sum += at->value;
    }
    return sum / static_cast<double>(trees.size());
}

void validate(const PieceForest& forest, const std::string& place) {
    const auto refuse = [&](std::size_t tree, std::size_t node, const std::string& problem) {
        throw InputError(
            "node " + std::to_string(node) + " of tree " + std::to_string(tree) + " " + problem,
            place, "Make the model again with hepatica-cli train");
    };
    for (std::size_t t = 0; t < forest.trees.size(); ++t) {
        const auto& tree = forest.trees[t];
        if (tree.empty()) refuse(t, 0, "is missing");
        const auto size = static_cast<int>(tree.size());
        for (int i = 0; i < size; ++i) {
            const ForestNode& node = tree[i];
            if (!std::isfinite(node.value)) refuse(t, i, "holds no number");
            if (node.feature < 0) {
                if (node.value < 0.0 || node.value > 1.0)
                    refuse(t, i, "holds " + std::to_string(node.value) + ", which is no share");
                continue;
            }
            if (node.feature >= static_cast<int>(piece_feature_names.size()))
                refuse(t, i, "asks for feature " + std::to_string(node.feature));
            for (const int child : {node.up_to, node.above})
                if (child <= i || child >= size)
                    refuse(t, i, "leads to node " + std::to_string(child));
        }
    }
}

}  // namespace hepatica
