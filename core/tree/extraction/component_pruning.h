// SPDX-License-Identifier: GPL-3.0-or-later
// Removes components of a graph that are so short that they are noise, and reports how much was
// removed.
#pragma once

#include <vector>

#include "core/base/vascular_system.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

struct RemovedPieces {
    int count = 0;
    double length_mm = 0.0;
};

// A kept place belongs to a vessel whose wall is no farther away than this.
inline constexpr double kept_reach_mm = 3.0;

// Removes components whose links are shorter than `shortest_mm` in all, except the longest one,
// those nearest to a seed or to a kept place that belongs to them and, where there are seeds, those
// with a known system. Joins links at passing nodes; nodes are renumbered.
RemovedPieces remove_short_components(VesselGraph& graph, double shortest_mm,
                                      const std::vector<VesselSeed>& seeds = {},
                                      const std::vector<Vec3>& kept_mm = {});

}  // namespace hepatica
