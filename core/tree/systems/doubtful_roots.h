// SPDX-License-Identifier: GPL-3.0-or-later
// Roots that are hardly where blood comes in: another end of the same tree is far wider. A vessel
// that was drawn onto a trunk, or a root set on a twig, leaves the trunk an outlet, which would
// take most of the flow. Vessels taper away from where they are filled (Murray 1926).
#pragma once

#include <string>
#include <vector>

#include "core/tree/system_summary.h"

namespace hepatica {

struct DoubtfulRoot {
    VascularSystem system = VascularSystem::unknown;
    SystemRoot root;
    SystemRoot wider_end;  // the widest end of that tree
};

// In the order of the tree's roots. An end is doubted from 2.5 mm of radius on that is 1.5 times
// the root's; both are medians over the last 5 mm, which one odd section does not sway.
std::vector<DoubtfulRoot> doubtful_roots(const VesselTree& tree);

// One for each, with what would help.
std::vector<std::string> sentences(const std::vector<DoubtfulRoot>& roots);

}  // namespace hepatica
