// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured of a piece of a permissive skeleton so that a forest can tell whether it is a
// vessel. All values are relative to the image's own noise and contrast, or in millimetres, so that
// they mean the same in any scan.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/job.h"
#include "core/links/line_pieces.h"
#include "core/segmentation/vessel_detection.h"

namespace hepatica {

inline constexpr std::array<std::string_view, 33> piece_feature_names{
    // Brightness along the axis, in deviations of the noise, but for the third, which is in shares
    // of that of wide vessels.
    "rise mean", "rise low", "rise of contrast",
    // Strength of lines through the axis in multiples of a line that noise can make: means over
    // half lengths of 2, 3.5 and 6 mm, and the low end of the second.
    "line short", "line middle", "line long", "line low",
    // How far the ring around the axis lies below it, in deviations: three quarters, half and a
    // quarter of the ring, all of it, and how dark its darkest quarter is. A sheet or an edge is
    // bright on parts of the ring, beside a duct or a fissure a part of it is dark.
    "ring three quarters", "ring half", "ring quarter", "ring all", "ring dark",
    // Shape of the piece and of the link that it belongs to.
    "radius", "radius spread", "length", "link length", "straightness", "free ends",
    // What it hangs together with.
    "component length", "component radius", "neighbours", "neighbour radius", "neighbour rise",
    "alignment", "way to sure", "weakest to sure",
    // Where it lies.
    "depth mean", "depth least",
    // The image.
    "contrast", "false line", "slices", "voxel", "radius in voxels"};

using PieceFeatures = std::array<float, piece_feature_names.size()>;

struct PieceImage {
    const LineEvidence& evidence;
    const Mask& liver;      // on the evidence's grid of cubes
    Vec3 ct_spacing_mm;     // of the CT itself
    double vessel_rise_hu;  // of wide vessels, > 0
};

// One for each piece. Same bytes for any number of threads. Throws Cancelled.
std::vector<PieceFeatures> piece_features(const std::vector<LinePiece>& pieces,
                                          const PieceImage& image, Job& job);

}  // namespace hepatica
