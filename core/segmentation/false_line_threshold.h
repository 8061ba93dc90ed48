// SPDX-License-Identifier: GPL-3.0-or-later
// How strong a bright line noise and texture can make. Noise makes as many dark lines as bright
// ones, and the vessels sought are brighter than the tissue, so the dark lines of an image tell
// what share of its bright ones is false: a false discovery rate measured in the image itself,
// after the target-decoy idea of Elias and Gygi (2007).
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The lowest strength (line_coherence.h), in the unit of `values`, above which there is at most one
// dark line for every 50 bright ones, counted in voxels of `where` from the strongest downwards.
// The result lies between one and four deviations, in steps of 0.05 deviations: four if even the
// strongest lines exceed that share, one if no line is found.
//   values: intensity minus that of the surroundings, so that broad dark regions are not lines
//   deviation: > 0, of the noise; lines are sought where `values` rises or falls by more
//   liver: lines are sought here; all images on the same grid, of cubic voxels
// Throws Cancelled.
double false_line_threshold(const FloatVolume& values, double deviation, const Mask& liver,
                            const Mask& where, Job& job);

}  // namespace hepatica
