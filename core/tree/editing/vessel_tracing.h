// SPDX-License-Identifier: GPL-3.0-or-later
// A vessel that a person points out by a few clicks: the path of least cost through the CT from
// click to click (Dijkstra, bright voxels are cheap), moved into the middle of the lumen and
// measured as every other centreline is (core/tree/extraction/lumen_measurement.h).
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/extraction/centreline.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Clicks in the order along the vessel, each at most 50 mm from the one before; clicks within half
// a millimetre of the one before are passed over. The centreline begins and ends at the voxels of
// the first and the last click, with points a voxel apart. Throws InputError where there are fewer
// than two places, one lies outside of the CT, two are too far apart, or the places are no brighter
// than what is around them by 15 HU; Cancelled, within 0.1 s or so of a real CT.
//   blood_contrast_hu: see below; thin vessels are measured too wide where it is not known (0).
Centreline traced_vessel(const Volume& ct, const std::vector<Vec3>& clicks_mm,
                         double blood_contrast_hu, Job& job);

// The part of a CT that such a vessel is looked for in: traced_vessel() gives the same of it.
// Throws as it does for places that are none.
Volume traced_part(const Volume& ct, const std::vector<Vec3>& clicks_mm);

// How much brighter blood is than what is around the vessels, by the tree's wide ones; 0 where it
// has none.
double blood_contrast_hu(const Volume& ct, const VesselTree& tree);

}  // namespace hepatica
