// SPDX-License-Identifier: GPL-3.0-or-later
// Finds roots where blood probably does not enter, because another end of the same tree is much
// wider: a vessel drawn onto a trunk, or a root set on a twig, makes the trunk an outlet that takes
// most of the flow. Vessels taper away from where they are filled (Murray 1926).
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

// In the order of the tree's roots. A root is doubtful where another end has a radius of at least
// 2.5 mm and 1.5 times the root's; both are medians over the last 5 mm, so that single sections do
// not matter.
std::vector<DoubtfulRoot> doubtful_roots(const VesselTree& tree);

// One sentence for each, with what would help.
std::vector<std::string> sentences(const std::vector<DoubtfulRoot>& roots);

}  // namespace hepatica
