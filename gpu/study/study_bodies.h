// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies of gpu_study.h.
#pragma once

#include "core/deform/body/body.h"

namespace hepatica::gpu {

// With at least so many tetrahedra, clamped at one end.
BodyDescription slender_bar(int tetrahedra);

// A slab one cell thick above a rigid block, with friction: about so many of its vertices lie over
// that. At rest they are this many pads away from it.
BodyDescription slab_above_a_block(int contacts);
constexpr double slab_clearance_pads = 2.0;

}  // namespace hepatica::gpu
