// SPDX-License-Identifier: GPL-3.0-or-later
// What one synthetic patient teaches: the pieces of its permissive skeleton, each with its features
// and the share of it that is a vessel.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/links/piece_features.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/vessel_segmentation.h"

namespace hepatica {

struct TaughtPiece {
    PieceFeatures features{};
    float share = 0.0f;  // of its points within 2 mm of a centreline of the truth
};

// Of the patient with this number (random_patient.h). The liver's mask is given, drawn sloppily, in
// two patients of three, and found in the third. Nothing where no line is told from noise.
std::vector<TaughtPiece> taught_by(std::uint64_t number, double line_share, Job& job);

// Of any patient whose vessels are known. Throws as detect_in_liver() does.
std::vector<TaughtPiece> taught_on(const Phantom& patient, const SegmentationOptions& options,
                                   double line_share, Job& job);

// The share of each piece that lies within 2 mm of the tree's centrelines.
std::vector<float> shares_of_truth(const std::vector<LinePiece>& pieces, const VesselTree& truth);

}  // namespace hepatica
