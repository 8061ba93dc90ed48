// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a point is inside a closed surface: rays from it leave once more often than they enter.
#pragma once

#include <span>

#include "core/contact/surface_patches.h"

namespace hepatica {

// `patches` must form a closed surface; `boxes` has one entry for each patch of `surface`. The
// majority of three rays decides, so that one that grazes an edge does no harm. A point on the
// surface may lie on either side.
bool lies_within(const Vec3& point, const SurfacePatches& surface, std::span<const int> patches,
                 std::span<const Box> boxes, std::span<const Vec3> positions_mm);

std::vector<Box> boxes_of_patches(const SurfacePatches& surface,
                                  std::span<const Vec3> positions_mm);

}  // namespace hepatica
