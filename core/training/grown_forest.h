// SPDX-License-Identifier: GPL-3.0-or-later
// Trains the forest of piece_forest.h with the random trees of OpenCV (Breiman, Mach Learn
// 2001;45:5).
#pragma once

#include <span>

#include "core/links/piece_forest.h"
#include "core/training/taught_pieces.h"

namespace hepatica {

struct ForestOptions {
    int trees = 60;            // 1 to 500
    int depth = 9;             // 1 to 20
    int least_in_leaf = 20;    // least number of pieces that a node needs to be split, 1 or more
    int features_a_split = 6;  // drawn at random at each split
};

// Trains on two pieces or more. The same pieces in the same order give the same forest. Throws
// InputError where a feature is not finite.
PieceForest grown_forest(std::span<const TaughtPiece> pieces, const ForestOptions& options);

}  // namespace hepatica
