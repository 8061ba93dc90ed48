// SPDX-License-Identifier: GPL-3.0-or-later
// Grows the forest that piece_forest.h walks, by OpenCV's random trees.
#pragma once

#include <span>

#include "core/links/piece_forest.h"
#include "core/training/taught_pieces.h"

namespace hepatica {

struct ForestOptions {
    int trees = 60;            // 1 to 500
    int depth = 9;             // 1 to 20
    int least_in_leaf = 20;    // pieces, 1 or more
    int features_a_split = 6;  // drawn at random for each
};

// The same pieces in the same order give the same forest. `pieces` holds at least two. Throws
// InputError where a feature is not finite.
PieceForest grown_forest(std::span<const TaughtPiece> pieces, const ForestOptions& options);

}  // namespace hepatica
