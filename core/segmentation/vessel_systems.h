// SPDX-License-Identifier: GPL-3.0-or-later
// Portal vein, hepatic veins and artery touch in the image: each voxel belongs to the system whose
// seed is nearest along the vessels.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/base/vascular_system.h"
#include "core/image/volume.h"

namespace hepatica {

// The vessels with the number of a system in each voxel: fronts run out from all seeds of known
// systems at once, through the 26 neighbours of a voxel, fast where the vessel is wide (so that a
// system keeps its own trunk before it leaks through a narrow contact), and the first to arrive
// takes the voxel (Dijkstra 1959, with the Euclidean length of each step). What no front reaches is
// of an unknown system. A seed may miss the lumen by up to 3 mm; several may name one system, and
// one of an unknown system claims nothing.
// Throws InputError where there is no vessel that near to a seed; Cancelled.
Mask label_systems(const Mask& vessels, const std::vector<VesselSeed>& seeds, Job& job);

// Throws InputError that names the first seed with no vessel within 3 mm.
void require_seeds_in_vessels(const Mask& vessels, const std::vector<VesselSeed>& seeds);

}  // namespace hepatica
