// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the centrelines of a graph into the middle of their lumen, smooths them, and measures the
// radii from cross-sections (see lumen_radius.h).
#pragma once

#include <functional>

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Links come in with points at voxel centres and inscribed radii, and leave with smooth points a
// voxel apart and radii smooth along the link. Inside a node's lumen a link has the radius that it
// has outside, so that a thin branch does not begin as wide as its parent. Links are independent of
// each other but for the contrast of their system. `ct` may be null. `progress` is told
// the share that is done, from any thread; what it throws ends the work. Where the graph's own
// vessels are too few or too thin to show the contrast of blood, `contrast_hu` counts, unless 0.
void measure_lumen(VesselGraph& graph, const Mask& vessels, const Volume* ct,
                   const std::function<void(double share)>& progress, double contrast_hu = 0.0);

}  // namespace hepatica
