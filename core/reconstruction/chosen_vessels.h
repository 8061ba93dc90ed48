// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps those of the detected lines that a learned model takes for vessels, or offers those that it
// takes for vessels among the ones that are too faint to be believed (core/links).
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/links/link_model.h"
#include "core/links/offered_branches.h"
#include "core/links/piece_features.h"
#include "core/reconstruction/detected_vessels.h"

namespace hepatica {

// The pieces of the skeleton of `lines`, at most about 8 mm long, and their features. `found` must
// hold evidence (vessel_detection.h). Throws Cancelled.
struct MeasuredPieces {
    std::vector<LinePiece> pieces;
    std::vector<PieceFeatures> features;
};
MeasuredPieces measured_pieces(const Mask& lines, const DetectedVessels& found,
                               const Vec3& ct_spacing_mm, Job& job);

// Removes from `found` the voxels of the pieces that the model drops, and then what is smaller than
// a vessel. Returns the branches that are offered in their place. Begins one stage. Throws
// Cancelled.
std::vector<Bridge> keep_chosen(const LinkModel& model, const Vec3& ct_spacing_mm,
                                DetectedVessels& found, Job& job);

// The branches of found.detection.doubtful that lead out of these vessels. Begins one stage. Throws
// Cancelled.
std::vector<Bridge> doubtful_branches(const LinkModel& model, const Vec3& ct_spacing_mm,
                                      const DetectedVessels& found, const Mask& vessels, Job& job);

}  // namespace hepatica
