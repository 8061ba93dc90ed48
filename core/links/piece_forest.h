// SPDX-License-Identifier: GPL-3.0-or-later
// A regression forest (Breiman, Mach Learn 2001;45:5) as plain arrays: predicts from its features
// which share of a piece is a vessel. It is trained with a library (core/training) and only
// evaluated here.
#pragma once

#include <string>
#include <vector>

#include "core/links/piece_features.h"

namespace hepatica {

struct ForestNode {
    int feature = -1;    // -1: a leaf
    double value = 0.0;  // of a leaf: share of vessel; else: threshold of the feature
    int up_to = -1;      // child for feature <= value; its index is above this node's, as is that
                         // of `above`
    int above = -1;      // child for feature > value
};

struct PieceForest {
    std::vector<std::vector<ForestNode>> trees;  // each begins with its root

    // Mean over the trees, in [0, 1]; 0 without trees. The forest must be valid. Thread-safe.
    double share_of_vessel(const PieceFeatures& features) const;
};

// Throws InputError, naming `place`, unless every tree can be evaluated: features exist, children
// stand after their parents, the values of leaves lie in [0, 1], and all values are finite.
void validate(const PieceForest& forest, const std::string& place);

}  // namespace hepatica
