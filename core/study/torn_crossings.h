// SPDX-License-Identifier: GPL-3.0-or-later
// Whether surfaces of a body that tears have passed through each other, although contact should
// keep them apart; by exact predicates.
#pragma once

#include <span>

#include "core/deform/body/body.h"
#include "core/deform/potentials/self_load.h"
#include "core/tear/torn_topology.h"

namespace hepatica {

// Number of pairs of surface triangles that cross now. Not counted are what overlapped at rest and
// has not separated yet, `kept`, and the sides of a tear around twins that lie on each other.
int torn_crossings(const TornTopology& torn, const BodyDescription& whole,
                   std::span<const Vec3> now_mm, const OverlapsKept& kept);

}  // namespace hepatica
