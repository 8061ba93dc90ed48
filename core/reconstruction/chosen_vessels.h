// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps those of the detected lines that a learned model takes for vessels (core/links).
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/links/link_model.h"
#include "core/links/piece_features.h"
#include "core/reconstruction/detected_vessels.h"

namespace hepatica {

// The pieces of the detected vessels' skeleton, at most about 8 mm long, and their features.
// `found` must hold evidence (vessel_detection.h). Throws Cancelled.
struct MeasuredPieces {
    std::vector<LinePiece> pieces;
    std::vector<PieceFeatures> features;
};
MeasuredPieces measured_pieces(const DetectedVessels& found, const Vec3& ct_spacing_mm, Job& job);

// Removes from `found` the voxels of the pieces that the model drops, and then what is smaller than
// a vessel. Begins one stage. Throws Cancelled.
void keep_chosen(const LinkModel& model, const Vec3& ct_spacing_mm, DetectedVessels& found,
                 Job& job);

}  // namespace hepatica
