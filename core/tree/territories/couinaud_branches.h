// SPDX-License-Identifier: GPL-3.0-or-later
// Labels the branches of the portal vein with Couinaud's segments. The position of a branch
// (couinaud_frame.h) is evidence for a label, and labels persist along the tree, because a segment
// is what one branch supplies. Together they form a Markov chain along the tree, whose most likely
// state and marginal probabilities are computed exactly by dynamic programming (max-product and
// sum-product, Pearl 1988), so that early and late divisions (trifurcation, a right posterior
// branch off the trunk) need no special rules. Borders from the whole portal tree differ from the
// planes of the hepatic veins by up to a quarter of a segment (Fischer et al., J Comput Assist
// Tomogr 2002;26:962).
#pragma once

#include <vector>

#include "core/tree/territories/couinaud_frame.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// The parameters of the chain. A transition from a common branch to a segment costs `leaving`, one
// between segments `changing`, against staying (log odds). Segment 1 does not change to another
// segment, none becomes common again, ends are not common, and the trunk is. A length of
// `witness_share` of the portal vein's counts as one independent observation of where a branch
// runs, with a likelihood of at least `least`; a common branch may run anywhere, with `common`
// times the best likelihood there.
namespace branch_chain {
inline constexpr double leaving = 3.0;
inline constexpr double changing = 4.5;
inline constexpr double witness_share = 1.0 / 300.0;
inline constexpr double least = 0.05;
inline constexpr double common = 0.9;
}  // namespace branch_chain

struct BranchLabel {
    int segment = 0;          // 1 to 8; 0: supplies several (trunk, main branches) or not portal
    double confidence = 0.0;  // probability of this label, given the positions of all branches
};

// One label per segment of the tree. O(points of the portal vein).
std::vector<BranchLabel> label_branches(const VesselTree& tree, const CouinaudFrame& frame);

}  // namespace hepatica
