// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's multi-layer method (section II.A.1): the vessel's cross-sections are segmented layer
// by layer in 2-D, fronts that march inwards from their boundary collide on the centreline, and
// along it the cross-sections are assembled into a volume.
#pragma once

#include "core/base/job.h"
#include "core/segmentation/tissue_contrast.h"
#include "core/segmentation/vessel_detection.h"

namespace hepatica {

// Layers are the planes z = constant of the grid (cubes, so that neighbouring layers overlap). Each
// is smoothed by a bilateral filter, which keeps edges, and cut at a multiple of the deviation that
// is left. A chain of cross-sections shorter than about 10 mm is dropped. Throws Cancelled.
Detection detect_by_layers(const TissueContrast& tissue, const Mask& liver, Job& job);

}  // namespace hepatica
