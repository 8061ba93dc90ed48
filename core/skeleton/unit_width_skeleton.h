// SPDX-License-Identifier: GPL-3.0-or-later
// Unit-width skeleton by the valence-driven spatial median (VDSM; Wang and Cheng 2008): the second
// step of section II.A.2 of the paper. A skeleton voxel's degree is its number of 26-neighbours;
// crowded points have a degree above 2 and such a neighbour; each 26-connected region of them is
// thinned to the shortest paths between its centre and its exits.
//
// As published the removal can close tunnels. Here a voxel goes only while it is simple and not a
// line end, so that components, tunnels and cavities stay as they were.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// One crowded region and what was decided about it. Voxels are offsets into the skeleton's grid.
struct CrowdedRegion {
    std::vector<std::size_t> voxels;              // ascending
    std::vector<std::size_t> exits;               // of degree 2 or less, adjacent to the region
    std::size_t centre = 0;                       // the valence-driven spatial median
    std::vector<std::vector<std::size_t>> paths;  // from the centre to each exit, both included
};

// Every stage of the method, to be shown or judged.
struct UnitWidthStages {
    std::vector<CrowdedRegion> regions;
    Mask skeleton;  // the result
};

// Throws Cancelled. Deterministic.
UnitWidthStages unit_width_stages(const Mask& skeleton, Job& job);

// The result alone: no simple voxel is left in it that is not a line end.
Mask unit_width(const Mask& skeleton, Job& job);

// Object voxels of degree above 2 with a neighbour of degree above 2. A junction of three branches
// is crowded and cannot be otherwise.
std::size_t crowded_point_count(const Mask& skeleton);

// Object voxels that are simple and not line ends: 0 in a unit-width skeleton.
std::size_t removable_point_count(const Mask& skeleton);

}  // namespace hepatica
