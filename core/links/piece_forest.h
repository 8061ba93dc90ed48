// SPDX-License-Identifier: GPL-3.0-or-later
// A regression forest (Breiman 2001) as plain arrays: which share of a piece is a vessel, told from
// its features. It is grown by a library (core/training) and only walked here.
#pragma once

#include <string>
#include <vector>

#include "core/links/piece_features.h"

namespace hepatica {

struct ForestNode {
    int feature = -1;    // -1: a leaf
    double value = 0.0;  // of a leaf the share of vessel; else the feature's threshold
    int up_to = -1;      // child for feature <= value; after this node, as is
    int above = -1;      // child for feature > value
};

struct PieceForest {
    std::vector<std::vector<ForestNode>> trees;  // each begins with its root

    // Mean over the trees, in [0, 1]; 0 without trees.
    double share_of_vessel(const PieceFeatures& features) const;
};

// Throws InputError, naming `place`, unless every tree can be walked to its leaves: features exist,
// children stand behind their parents, leaves lie in [0, 1], all is finite.
void validate(const PieceForest& forest, const std::string& place);

}  // namespace hepatica
