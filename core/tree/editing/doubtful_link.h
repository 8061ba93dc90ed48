// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a link by hand may have been made by mistake: it joins two systems, which do not meet in
// a liver, or reaches farther than a gap between two parts of one vessel does.
#pragma once

#include <string>
#include <vector>

#include "core/tree/editing/tree_edit.h"

namespace hepatica {

// One sentence for each doubt about this add_link to the tree as it is before it. The gap is
// measured from wall to wall; it is long above 20 mm, or above five diameters of the wider vessel.
// Empty for other edits, for an end more than 10 mm from any vessel, which edited() refuses, and
// for a link along a path: that of an offered gap, whose likelihood is known.
std::vector<std::string> doubts_of_link(const VesselTree& tree, const TreeEdit& edit);

}  // namespace hepatica
