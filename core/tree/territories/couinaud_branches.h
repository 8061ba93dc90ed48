// SPDX-License-Identifier: GPL-3.0-or-later
// Labels the branches of the portal vein by Couinaud's segments: where a branch runs
// (couinaud_frame.h) speaks for a label, and a label holds along the tree, since a segment is what
// one branch supplies. Both together are a Markov chain along the tree; its most likely state and
// each branch's certainty are exact by dynamic programming (max-product and sum-product, Pearl
// 1988), so that early and late divisions (trifurcation, a right posterior branch off the trunk)
// need no rules of their own. Borders from the whole portal tree differ from the planes of the
// hepatic veins by as much as a quarter of a segment (Fischer et al., J Comput Assist
// Tomogr 2002;26:962).
#pragma once

#include <vector>

#include "core/tree/territories/couinaud_frame.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// The chain: a step into a segment from a common branch costs `leaving`, and one from another
// segment `changing`, against staying (logarithms of odds). No branch leaves one of segment 1 for
// another segment, none becomes common again, ends are not common, and the trunk is. A stretch of
// `witness_share` of the portal vein's length counts as one independent witness of where a branch
// runs, with a likelihood of at least `least`; a common branch runs anywhere, at `common` of the
// best likelihood there.
namespace branch_chain {
inline constexpr double leaving = 3.0;
inline constexpr double changing = 4.5;
inline constexpr double witness_share = 1.0 / 300.0;
inline constexpr double least = 0.05;
inline constexpr double common = 0.9;
}  // namespace branch_chain

struct BranchLabel {
    int segment = 0;          // 1 to 8; 0: supplies several (trunk, main branches), or not portal
    double confidence = 0.0;  // probability of this label, given where all branches run
};

// One label per segment of the tree; O(points of the portal vein).
std::vector<BranchLabel> label_branches(const VesselTree& tree, const CouinaudFrame& frame);

}  // namespace hepatica
