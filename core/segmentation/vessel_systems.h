// SPDX-License-Identifier: GPL-3.0-or-later
// Separates portal vein, hepatic veins and artery, which touch in the image: each voxel belongs to
// the system whose seed is nearest along the vessels.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/base/vascular_system.h"
#include "core/image/volume.h"

namespace hepatica {

// The vessels with the number of a system in each voxel. Fronts start from all seeds of known
// systems at once and pass through the 26 neighbours of a voxel; the first to arrive takes the
// voxel (Dijkstra 1959, with the Euclidean length of each step). They are faster where the vessel
// is wide, so that a system fills its own trunk before it leaks through a narrow contact. Voxels
// that no front reaches belong to an unknown system. A seed may miss the nearest centre of a
// vessel's voxel by up to 3 mm, and by more within such a voxel (thick slices); several seeds may
// name one system; seeds of an unknown system claim nothing; of two seeds in one voxel the first
// counts. Throws InputError where no vessel lies within 3 mm of a seed; Cancelled.
Mask label_systems(const Mask& vessels, const std::vector<VesselSeed>& seeds, Job& job);

// Throws InputError, naming the first seed with no vessel within 3 mm.
void require_seeds_in_vessels(const Mask& vessels, const std::vector<VesselSeed>& seeds);

}  // namespace hepatica
