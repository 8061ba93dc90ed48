// SPDX-License-Identifier: GPL-3.0-or-later
// Which way a vessel runs: what an instrument that is to take it must know.
#pragma once

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Of the centreline's stretch at the place, of unit length, away from the root; 0 where the place
// is on no segment.
Vec3 vessel_direction(const VesselTree& tree, const TreePoint& place);

}  // namespace hepatica
