// SPDX-License-Identifier: GPL-3.0-or-later
// Computes how much of a vessel a cut removes: the lumen ends in a ball of its own radius on both
// sides, so the gap must be visible between the walls, not between the centrelines.
#pragma once

#include <optional>

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

constexpr double cut_gap_mm = 1.0;  // between the walls of the two parts

// Distances along a link. The part before `from_mm` stays at the link's first node, the part beyond
// `to_mm` at its last. Without a value nothing stays on that side, because the rest would touch the
// other part or be shorter than 0.5 mm.
struct CutStretch {
    std::optional<double> from_mm;
    std::optional<double> to_mm;
};

// The shortest stretch around `along_mm` whose removal leaves cut_gap_mm between the walls of the
// two stumps, and between each stump and the vessels at the node beyond the gap. None where the
// vessels at the link's two nodes are closer than that to each other.
std::optional<CutStretch> cut_stretch(const VesselGraph& graph, int link, double along_mm);

}  // namespace hepatica
