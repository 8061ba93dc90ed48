// SPDX-License-Identifier: GPL-3.0-or-later
// Traces a vessel from a few clicks: the cheapest path through the CT from click to click
// (Dijkstra's algorithm, bright voxels are cheap), moved into the middle of the lumen and measured
// like any other centreline (core/tree/extraction/lumen_measurement.h).
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/extraction/centreline.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// The clicks are ordered along the vessel, each at most 50 mm from the one before; clicks within
// 0.5 mm of the one before are ignored. The centreline begins and ends at the voxels of the first
// and last click, with points about a voxel apart. `blood_contrast_hu` is the value of the function
// below; where it is 0, thin vessels are measured too wide. Begins one stage. Throws InputError
// where there are fewer than two places or all lie in one voxel, one lies outside the CT, two are
// too far apart, or the places are not at least 15 HU brighter than their surroundings; Cancelled,
// within about 0.1 s for a real CT.
Centreline traced_vessel(const Volume& ct, const std::vector<Vec3>& clicks_mm,
                         double blood_contrast_hu, Job& job);

// The part of a CT that is searched for the vessel: traced_vessel() gives the same result on it.
// Throws as traced_vessel() does for invalid places.
Volume traced_part(const Volume& ct, const std::vector<Vec3>& clicks_mm);

// The clicks, with the nearest point of a centreline before the first where that one lies up to 8
// mm outside of every lumen but in blood that goes on to the vessel: nowhere on the straight way
// there is the CT darker than the median in the lumen by half of the contrast. A tree may end
// before the blood that the CT shows. As they are where `blood_contrast_hu` is 0, the tree is
// empty, or the click lies outside of the CT.
std::vector<Vec3> begun_in_vessel(const Volume& ct, const VesselTree& tree,
                                  std::vector<Vec3> clicks_mm, double blood_contrast_hu);

// Contrast of blood against the surroundings of the vessels, from the wide vessels of a tree; 0
// where it has none.
double blood_contrast_hu(const Volume& ct, const VesselTree& tree);

}  // namespace hepatica
