// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the centrelines of a graph into the middle of their lumen, smooths them, and measures the
// radii from cross-sections (lumen_radius.h).
#pragma once

#include <array>
#include <functional>

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Takes links with points at voxel centres and inscribed radii, and gives them smooth points a
// voxel apart and radii smooth along the link. Inside a node's lumen a link keeps the radius that
// it has outside, so that a thin branch does not begin as wide as its parent. Links are processed
// independently, apart from the contrast of their system. `ct` may be null. `contrast_hu` > 0 is
// the contrast of blood to use where the graph's own vessels are too few or too thin to show it.
// `progress` gets the share done, from any thread; an exception it throws ends the work.
void measure_lumen(VesselGraph& graph, const Mask& vessels, const Volume* ct,
                   const std::function<void(double share)>& progress, double contrast_hu = 0.0);

// Six places outside a vessel, along the axes in both directions, two radii and three voxels from a
// point of its centreline. Another vessel may lie there.
std::array<Vec3, 6> places_beside(const Vec3& point_mm, double radius_mm, double voxel_mm);

}  // namespace hepatica
