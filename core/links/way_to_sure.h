// SPDX-License-Identifier: GPL-3.0-or-later
// How a piece of a permissive skeleton is connected to sure vessels: its distance along the
// skeleton (Dijkstra's algorithm) and the weakest piece on the best path.
#pragma once

#include <span>
#include <vector>

#include "core/links/line_pieces.h"

namespace hepatica {

// A piece is sure from this radius and this line coherence on.
inline constexpr double sure_radius_mm = 1.5;
inline constexpr double sure_line = 1.6;  // in multiples of a line that noise can make
inline constexpr double farthest_sure_mm = 60.0;

struct WayToSure {
    double distance_mm = farthest_sure_mm;  // 0 for sure pieces; at most farthest_sure_mm
    double weakest_line = 0.0;  // maximum over all paths of the least line on the path; 0: no path
};

// One for each piece. `lines` and `radii_mm` hold one value for each piece. A path includes the
// piece itself and the sure piece; distances run between the middles of pieces.
std::vector<WayToSure> ways_to_sure(const std::vector<LinePiece>& pieces,
                                    std::span<const double> lines,
                                    std::span<const double> radii_mm);

}  // namespace hepatica
