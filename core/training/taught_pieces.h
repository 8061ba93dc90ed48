// SPDX-License-Identifier: GPL-3.0-or-later
// Training data from one synthetic patient: the pieces of its permissive skeleton, each with its
// features and the share of it that is a vessel.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/job.h"
#include "core/links/piece_features.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/vessel_segmentation.h"

namespace hepatica {

struct TaughtPiece {
    PieceFeatures features{};
    float share = 0.0f;  // share of its points within 2 mm of a true centreline
};

// What the patient with this number is segmented with: in two patients of three a sloppily drawn
// liver mask is given, in the third the liver is found. Throws Cancelled.
SegmentationOptions options_taught_with(std::uint64_t number, const Phantom& patient, Job& job);

// The pieces of the patient with this number (random_patient.h), segmented with those options.
// Otherwise as taught_on().
std::vector<TaughtPiece> taught_by(std::uint64_t number, double line_share, Job& job);

// The same, where `make` makes the patient of the options for this number: a smaller one, as tests
// need it.
using PatientMaker = std::function<Phantom(const PhantomOptions& options, Job& job)>;
std::vector<TaughtPiece> taught_by_made(const PatientMaker& make, std::uint64_t number,
                                        double line_share, Job& job);

// The pieces of any patient whose vessels are known. Empty where no line rises above the noise.
// Throws NoLiverFound; InputError where a given liver or another option cannot be used; Cancelled.
std::vector<TaughtPiece> taught_on(const Phantom& patient, const SegmentationOptions& options,
                                   double line_share, Job& job);

// The share of each piece's points that lie within 2 mm of the tree's centrelines.
std::vector<float> shares_of_truth(const std::vector<LinePiece>& pieces, const VesselTree& truth);

}  // namespace hepatica
