// SPDX-License-Identifier: GPL-3.0-or-later
// Unit-width skeleton by the valence-driven spatial median (VDSM; Wang and Cheng 2008): the second
// step of section II.A.2 of the paper. A skeleton voxel's degree is its number of 26-neighbours;
// crowded points have a degree above 2 and a neighbour with a degree above 2; each 26-connected
// region of them is thinned to the shortest paths between its centre and its exits.
//
// As published the removal can destroy tunnels. Here a voxel is removed only while it is simple and
// not a line end, so components, tunnels and cavities are preserved.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// One crowded region with its centre and paths. Voxels are offsets into the skeleton's grid.
struct CrowdedRegion {
    std::vector<std::size_t> voxels;  // ascending
    std::vector<std::size_t> exits;   // skeleton voxels of degree 2 or less next to the region
    std::size_t centre = 0;           // the valence-driven spatial median
    // From the centre to each exit, both included; empty where an exit cannot be reached.
    std::vector<std::vector<std::size_t>> paths;
};

// All stages of the method, for display and tests.
struct UnitWidthStages {
    std::vector<CrowdedRegion> regions;
    Mask skeleton;  // the result
};

// Throws Cancelled. Deterministic.
UnitWidthStages unit_width_stages(const Mask& skeleton, Job& job);

// Only the result: every simple voxel left in it is a line end. Throws Cancelled.
Mask unit_width(const Mask& skeleton, Job& job);

// Number of object voxels of degree above 2 with a neighbour of degree above 2. Not 0 in general: a
// junction of three branches is necessarily crowded.
std::size_t crowded_point_count(const Mask& skeleton);

// Number of object voxels that are simple and not line ends: 0 in a unit-width skeleton.
std::size_t removable_point_count(const Mask& skeleton);

}  // namespace hepatica
