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
// is smoothed by a bilateral filter, which keeps edges, and thresholded at tissue.threshold_hu, or
// else at the median plus three standard deviations of the remaining noise. Chains of
// cross-sections with an extent below 10 mm or a volume below 60 mm^3 are dropped. `liver` lies on
// the grid of `tissue`. Throws Cancelled.
Detection detect_by_layers(const TissueContrast& tissue, const Mask& liver, Job& job);

}  // namespace hepatica
