// SPDX-License-Identifier: GPL-3.0-or-later
// Portal vein, hepatic veins and artery touch in the image: each voxel belongs to the system whose
// seed is nearest along the vessels, and a wrong piece changes hands in one step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// A point inside one vascular system. Systems are numbered from 1 (say 1 portal vein, 2 hepatic
// veins, 3 artery); several seeds may name the same system.
struct VesselSeed {
    Vec3 position_mm = Vec3::Zero();
    std::uint8_t system = 1;
};

// Labels what is connected to a seed, and drops the rest: fronts run out from all seeds at once,
// fast where the vessel is wide (so that a system keeps its own trunk before it leaks through a
// narrow contact), and the first to arrive takes the voxel. A seed may miss the lumen by up to
// 3 mm; throws InputError where there is no vessel that near, or a system is 0; Cancelled.
Mask label_systems(const Mask& vessels, const std::vector<VesselSeed>& seeds, Job& job);

// One step of the correction of an overlap: the piece around `correction` goes over to its system.
// The piece is what the front from the correction reaches, within the system that it lies in,
// before the fronts from that system's own seeds do. Returns how many voxels changed hands: 0 where
// they are the system's already. Throws InputError where no vessel lies within 3 mm; Cancelled.
std::size_t reassign_overlap(Mask& systems, const std::vector<VesselSeed>& seeds,
                             const VesselSeed& correction, Job& job);

}  // namespace hepatica
