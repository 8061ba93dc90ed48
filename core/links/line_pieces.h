// SPDX-License-Identifier: GPL-3.0-or-later
// The links of a permissive skeleton cut into short pieces: what is kept or dropped as a whole when
// vessels are chosen among everything that looks a little like one.
#pragma once

#include <vector>

#include "core/image/volume.h"

namespace hepatica {

struct LinePiece {
    std::vector<Vec3> points_mm;   // 2 or more, along the centreline; shared with the next piece
    std::vector<double> radii_mm;  // of the largest ball inside the mask, one per point
    double length_mm = 0.0;
    double link_length_mm = 0.0;  // of the whole link that it was cut from
    std::vector<int> neighbours;  // pieces that it meets at either end, ascending
    int free_ends = 0;            // ends at which it meets nothing: 0 to 2
};

// Pieces of at most longest_mm, in the order of the skeleton's links; empty for an empty skeleton.
// `skeleton` has unit width, both masks lie on one grid.
std::vector<LinePiece> line_pieces(const Mask& skeleton, const Mask& vessels, double longest_mm);

// The connected component of each piece, numbered by first piece.
std::vector<int> components_of(const std::vector<LinePiece>& pieces);

}  // namespace hepatica
