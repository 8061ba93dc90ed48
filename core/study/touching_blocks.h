// SPDX-License-Identifier: GPL-3.0-or-later
// A soft block that lies on a soft slab: the body of the studies of contact between surfaces.
#pragma once

#include "core/deform/body/body.h"

namespace hepatica {

inline constexpr double study_gap_mm = 0.05;  // below the block, or between slab and a ball
inline constexpr double study_cell_mm = 2.0;

struct TouchingBlocks {
    BodyDescription body;    // its surfaces touch each other
    int first_of_block = 0;  // vertices from here on are the block's
};

// Bricks of three layers of cells of 2 mm, each cut into six tetrahedra. The slab's bottom is held;
// the block, so many cells across, begins so far above its middle.
TouchingBlocks block_on_slab(int slab_cells, int block_cells, double gap_mm = study_gap_mm);

// Such a slab alone, held at its rim.
BodyDescription slab_held_at_rim(int cells);

// What both are made of: 20 kPa, Poisson's ratio 0.3, as dense as water.
Material study_tissue();

}  // namespace hepatica
