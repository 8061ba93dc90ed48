// SPDX-License-Identifier: GPL-3.0-or-later
// The end of the portal trunk: a skeleton ends somewhere in a wide lumen, not at the section at
// which the trunk comes in.
#pragma once

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Leads the portal centreline nearest to `entry_mm` there, as wide as it is where it leaves off, so
// that an end lies there. A wide end of the portal vein within 15 mm beyond the place where it
// leaves off goes. Nothing changes where no portal vein lies within 15 mm, or where one is there
// already.
void lead_trunk_to(const Vec3& entry_mm, VesselGraph& graph);

}  // namespace hepatica
