// SPDX-License-Identifier: GPL-3.0-or-later
// Features of a piece of a permissive skeleton, from which a forest tells whether it is a vessel.
// Lengths are in millimetres and intensities relative to the image's own noise and contrast, so
// that they mean the same in any scan.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/job.h"
#include "core/links/line_pieces.h"
#include "core/segmentation/vessel_detection.h"

namespace hepatica {

inline constexpr std::array<std::string_view, 33> piece_feature_names{
    // Rise above the tissue along the axis, in standard deviations of the noise: mean and 0.2
    // quantile; then its mean divided by the rise of wide vessels.
    "rise mean", "rise low", "rise of contrast",
    // Line coherence on the axis, in multiples of a line that noise can make: means for half
    // lengths of 2, 3.5 and 6 mm, and the 0.2 quantile for 3.5 mm.
    "line short", "line middle", "line long", "line low",
    // Ring of 12 points 1.5 mm outside the wall, in standard deviations. First by how much at least
    // three quarters, half, a quarter and all of the ring lie below the axis, then the brightness
    // of its second darkest point. Part of the ring is bright beside a sheet or an edge, dark
    // beside a duct or a fissure.
    "ring three quarters", "ring half", "ring quarter", "ring all", "ring dark",
    // Shape of the piece, and length of its link.
    "radius", "radius spread", "length", "link length", "straightness", "free ends",
    // Its component and its neighbours: radius and rise of the strongest neighbour relative to its
    // own, alignment with the straightest continuation, and the path to a sure vessel
    // (way_to_sure.h).
    "component length", "component radius", "neighbours", "neighbour radius", "neighbour rise",
    "alignment", "way to sure", "weakest to sure",
    // Depth below the liver's surface in mm, at most 40.
    "depth mean", "depth least",
    // The image: rise of wide vessels and of a false line in standard deviations, coarsest spacing,
    // mean voxel edge, and the radius in voxels.
    "contrast", "false line", "slices", "voxel", "radius in voxels"};

using PieceFeatures = std::array<float, piece_feature_names.size()>;

struct PieceImage {
    const LineEvidence& evidence;
    const Mask& liver;      // on the grid of the evidence, which has cubic voxels
    Vec3 ct_spacing_mm;     // of the original CT
    double vessel_rise_hu;  // rise of wide vessels above the tissue, > 0
};

// The features of each piece, in the order of piece_feature_names. The same for any number of
// threads. Throws Cancelled.
std::vector<PieceFeatures> piece_features(const std::vector<LinePiece>& pieces,
                                          const PieceImage& image, Job& job);

}  // namespace hepatica
