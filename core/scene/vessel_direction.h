// SPDX-License-Identifier: GPL-3.0-or-later
// The direction of a vessel, by which an instrument is oriented.
#pragma once

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Direction of the centreline at the place, of unit length, away from the root; 0 where the place
// is not on a segment.
Vec3 vessel_direction(const VesselTree& tree, const TreePoint& place);

}  // namespace hepatica
