// SPDX-License-Identifier: GPL-3.0-or-later
// Which vascular system (portal vein, hepatic veins, artery) each link belongs to, from seeds that
// the user set. Systems touch in the image; they are parted where the vessel between them is
// narrowest: a watershed along the tree.
#pragma once

#include <vector>

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// A point in a vessel that the user named, and the vascular system it stands for.
struct SystemSeed {
    Vec3 position_mm = Vec3::Zero();
    int system = 0;
};

// Where the mask names systems itself (several nonzero values): gives each link the system whose
// voxels most of its points lie in, split where a long stretch lies in another. Returns false, and
// does nothing, where the points of all links lie in one value.
bool assign_systems_by_labels(VesselGraph& graph, const Mask& labels);

// Sets the system of every link. From the links nearest to the seeds each system spreads over the
// widest links first. Components without a seed join the system whose centreline is nearest.
// Does nothing without seeds.
void assign_systems(VesselGraph& graph, const std::vector<SystemSeed>& seeds);

}  // namespace hepatica
