// SPDX-License-Identifier: GPL-3.0-or-later
// Offers what the model takes for less than a vessel but for more than noise: dropped pieces that
// lead out of kept ones, as branches that a person accepts or refuses.
#pragma once

#include <cstdint>
#include <vector>

#include "core/links/line_pieces.h"
#include "core/tree/extraction/gap_bridging.h"

namespace hepatica {

inline constexpr double least_offered_share = 0.5;  // share of vessel of an offered branch
inline constexpr double shortest_offer_mm = 5.0;

// Branches along chains of dropped pieces, each from a kept piece, or from a branch that is offered
// before it, to a tip that meets no kept one; the surest first. Their confidence is the mean share
// of vessel along them. `shares` and `chosen` hold one value for each piece, as for
// chosen_pieces().
std::vector<Bridge> offered_branches(const std::vector<LinePiece>& pieces,
                                     const std::vector<double>& shares,
                                     const std::vector<std::uint8_t>& chosen);

}  // namespace hepatica
