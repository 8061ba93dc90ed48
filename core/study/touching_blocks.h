// SPDX-License-Identifier: GPL-3.0-or-later
// A soft block on a soft slab, and a soft bar along another: the bodies of the studies of contact
// between surfaces.
#pragma once

#include "core/deform/body/body.h"

namespace hepatica {

inline constexpr double study_gap_mm = 0.05;  // below the block, or between slab and ball
inline constexpr double study_cell_mm = 2.0;

struct TouchingBlocks {
    BodyDescription body;    // with self-contact
    int first_of_block = 0;  // first vertex of the block
};

// Bricks of three layers of cells of 2 mm, each cut into six tetrahedra. The slab's bottom is
// fixed; the block, `block_cells` cells across, begins `gap_mm` above the slab's middle.
TouchingBlocks block_on_slab(int slab_cells, int block_cells, double gap_mm = study_gap_mm);

// Two bars of three by three such cells across, as vessels that lie along each other: the lower
// one's bottom is fixed, the upper one begins `gap_mm` above it, at its middle. Lengths in cells.
TouchingBlocks bar_along_bar(int lower_cells, int upper_cells, double gap_mm = study_gap_mm);

// Such a slab alone, fixed at its rim.
BodyDescription slab_held_at_rim(int cells);

// Their material: 20 kPa, Poisson's ratio 0.3, density of water.
Material study_tissue();

}  // namespace hepatica
