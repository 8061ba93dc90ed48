// SPDX-License-Identifier: GPL-3.0-or-later
// Leads a place to what it belongs to: to the nearest point of the convex hull of some points.
#pragma once

#include <span>

#include "core/base/vector.h"

namespace hepatica {

// The point of the hull of `points`, of which there must be one, that is nearest to `place`, to a
// thousandth of a millimetre; inside the hull that is `place` itself.
Vec3 nearest_in_hull(std::span<const Vec3> points, const Vec3& place);

}  // namespace hepatica
