// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a vessel a cut takes away: the lumen ends in a ball of its own radius on both sides
// of a gap, so the gap between the walls, not that between the centrelines, has to be seen.
#pragma once

#include <optional>

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

constexpr double cut_gap_mm = 1.0;  // between the walls of the two parts

// Distances along a link. What lies before `from_mm` stays at the link's first node, what lies
// beyond `to_mm` at its last; without a value nothing stays there, because the remainder would
// touch the other part or be shorter than half a millimetre.
struct CutStretch {
    std::optional<double> from_mm;
    std::optional<double> to_mm;
};

// The shortest stretch around `along_mm` whose removal parts the walls by cut_gap_mm: those of the
// two stumps, and those of each stump and of the vessels in the node beyond the gap. Nothing where
// the vessels in the link's two nodes are that close to each other themselves.
std::optional<CutStretch> cut_stretch(const VesselGraph& graph, int link, double along_mm);

}  // namespace hepatica
