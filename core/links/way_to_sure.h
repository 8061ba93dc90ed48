// SPDX-License-Identifier: GPL-3.0-or-later
// How a piece of a permissive skeleton hangs together with what is surely a vessel: how far it is
// along the skeleton (Dijkstra), and how weak the weakest piece of the best way is.
#pragma once

#include <span>
#include <vector>

#include "core/links/line_pieces.h"

namespace hepatica {

inline constexpr double sure_radius_mm = 1.5;
inline constexpr double sure_line = 1.6;  // in multiples of a line that noise can make
inline constexpr double farthest_sure_mm = 60.0;

struct WayToSure {
    double distance_mm = farthest_sure_mm;  // 0 for sure pieces; never more than the farthest
    double weakest_line = 0.0;  // largest over all ways of the least line on it; 0: there is none
};

// One for each piece. `lines` and `radii_mm` hold one value for each; the piece itself is on its
// way.
std::vector<WayToSure> ways_to_sure(const std::vector<LinePiece>& pieces,
                                    std::span<const double> lines,
                                    std::span<const double> radii_mm);

}  // namespace hepatica
