// SPDX-License-Identifier: GPL-3.0-or-later
// How strong a bright line noise and texture can make. Noise makes as many dark lines as bright
// ones, and the vessels looked for are brighter than the tissue, so the dark lines of an image tell
// what share of its bright ones is false: a false discovery rate measured in the image itself,
// after the target and decoy idea of Elias and Gygi (2007).
#pragma once

#include <functional>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The strength, in the unit of `values`, down to which 50 bright lines or more stand against each
// dark one (line_coherence.h), counted in voxels of `where` from the strongest downwards; between
// one and four deviations, in steps of a twentieth of one. Four also where not even the strongest
// lines are that trustworthy.
//   values: intensity against the surroundings, so that broad dark regions (tumours) are no lines
//   deviation: > 0, of the noise; lines are looked for where `values` rises or falls by more
//   liver: lines are looked for here; the same grid, of cubes
//   progress: called once half of the work is done
// Throws Cancelled.
double false_line_threshold(const FloatVolume& values, double deviation, const Mask& liver,
                            const Mask& where, const std::function<void()>& progress, Job& job);

}  // namespace hepatica
