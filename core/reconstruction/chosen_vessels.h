// SPDX-License-Identifier: GPL-3.0-or-later
// Among everything that looks like a vessel: what a learned model keeps.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/links/link_model.h"
#include "core/links/piece_features.h"
#include "core/reconstruction/detected_vessels.h"

namespace hepatica {

// The pieces of what was detected, with what is measured of each. `found` holds evidence
// (vessel_detection.h).
struct MeasuredPieces {
    std::vector<LinePiece> pieces;
    std::vector<PieceFeatures> features;
};
MeasuredPieces measured_pieces(const DetectedVessels& found, const Vec3& ct_spacing_mm, Job& job);

// Takes the voxels of the other pieces out of what was detected, and pieces of what is left that
// are smaller than a vessel. Begins a stage of the job. Throws Cancelled.
void keep_chosen(const LinkModel& model, const Vec3& ct_spacing_mm, DetectedVessels& found,
                 Job& job);

}  // namespace hepatica
