// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies studied in gpu_study.h.
#pragma once

#include "core/deform/body/body.h"

namespace hepatica::gpu {

// A bar with at least this many tetrahedra, clamped at one end.
BodyDescription slender_bar(int tetrahedra);

// A slab one cell thick above a rigid block, with friction; about `contacts` of its vertices lie
// above the block. At rest they are slab_clearance_pads pads away from it.
BodyDescription slab_above_a_block(int contacts);
constexpr double slab_clearance_pads = 2.0;

}  // namespace hepatica::gpu
