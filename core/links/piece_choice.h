// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the pieces of a permissive skeleton that are vessels, by a minimal cut, and removes the
// voxels of the others from the mask.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/links/line_pieces.h"
#include "core/links/link_model.h"

namespace hepatica {

// 1 for each piece that is kept. The labels x minimise sum_i x_i length_i (logit(kept_share) -
// logit(share_i)) + 1.5 mm * (number of neighbouring pieces with different labels), exactly, as a
// minimal cut. `shares` holds one value in [0, 1] for each piece; shares and kept_share are clamped
// to [0.05, 0.95].
std::vector<std::uint8_t> chosen_pieces(const std::vector<LinePiece>& pieces,
                                        const std::vector<double>& shares, double kept_share);

// The mask without the voxels that are nearer to the wall of a dropped piece than to that of a kept
// one, measured along paths within the mask. Voxels connected to no piece stay. The mask has cubic
// voxels. O(n log n) for n voxels. Throws Cancelled.
Mask without_dropped(const Mask& vessels, const std::vector<LinePiece>& pieces,
                     const std::vector<std::uint8_t>& chosen, const Job& job);

}  // namespace hepatica
