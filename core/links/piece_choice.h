// SPDX-License-Identifier: GPL-3.0-or-later
// Which pieces of a permissive skeleton are vessels, and what is left of the mask without the
// others.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/links/line_pieces.h"
#include "core/links/link_model.h"

namespace hepatica {

// 1 for each piece that is kept: the labelling of least energy, in which a piece costs what its
// share of vessel says against it, by its length, and neighbours that differ cost a tie (a minimal
// cut). `shares` holds one value in [0, 1] for each piece.
std::vector<std::uint8_t> chosen_pieces(const std::vector<LinePiece>& pieces,
                                        const std::vector<double>& shares, double kept_share);

// The mask without the voxels that are nearer to the wall of a piece that is not chosen than to
// that of one that is, by way through the mask. Voxels that hang together with no piece stay.
// Throws Cancelled.
Mask without_dropped(const Mask& vessels, const std::vector<LinePiece>& pieces,
                     const std::vector<std::uint8_t>& chosen, const Job& job);

}  // namespace hepatica
