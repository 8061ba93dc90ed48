// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertex of a torn body is at the open end that bleeds.
#pragma once

#include <array>
#include <vector>

#include "core/scene/frame.h"
#include "core/scene/through_tears.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// For each tear, a vertex on the rim of the stump on the root's side, from which blood is driven;
// where no rim is near, a vertex of the nearest one; -1 where there is none. `torn` has rims and
// origins; `rest_mm` is of the whole body.
std::vector<int> leaking_vertices(const VesselTree& tree, const std::vector<ThroughTear>& tears,
                                  const TearView& torn, const std::vector<Vec3>& rest_mm,
                                  const std::vector<std::array<int, 3>>& triangles);

}  // namespace hepatica
