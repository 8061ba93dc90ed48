// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a correction gives a vessel to the system that it has, so that nothing would change but
// how sure the system is.
#pragma once

#include "core/tree/editing/tree_edit.h"

namespace hepatica {

// True for a seed_system on a vessel of its system, and for a reassign_system where all downstream
// is of its system, too. False for an empty tree, and for a place more than 10 mm from any vessel,
// both of which edited() refuses.
bool is_given_already(const VesselTree& tree, const TreeEdit& edit);

// Whether such a reassign_system is worth making all the same: it states the system of vessels
// whose system was in doubt (sure_confidence in system_summary.h).
bool settles_a_doubt(const VesselTree& tree, const TreeEdit& edit);

}  // namespace hepatica
