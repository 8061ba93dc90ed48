// SPDX-License-Identifier: GPL-3.0-or-later
// How often a scene's vessels pass through each other, by exact predicates: what contact promises
// never to happen.
#pragma once

#include "core/scene/deform_part.h"

namespace hepatica {

// Pairs of surface triangles that cross as the body lies now, outside of what overlapped at rest
// and has not come apart yet. Costs a search over the whole surface.
int crossing_pairs(const DeformPart& deform);

}  // namespace hepatica
