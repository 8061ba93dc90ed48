// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the links of a permissive skeleton into short pieces, each of which is kept or dropped as a
// whole when vessels are chosen among all candidate lines.
#pragma once

#include <vector>

#include "core/image/volume.h"

namespace hepatica {

struct LinePiece {
    std::vector<Vec3> points_mm;   // 2 or more, along the centreline; the end points are shared
                                   // with the next pieces
    std::vector<double> radii_mm;  // of the largest ball inside the mask, one per point
    double length_mm = 0.0;
    double link_length_mm = 0.0;  // of the whole link it was cut from
    std::vector<int> neighbours;  // pieces it meets at either end, ascending
    int free_ends = 0;            // ends where it meets no other piece: 0 to 2
};

// Pieces of about longest_mm > 0 or less, in the order of the skeleton's links; empty for an empty
// skeleton. `skeleton` has unit width; both masks share one grid.
std::vector<LinePiece> line_pieces(const Mask& skeleton, const Mask& vessels, double longest_mm);

// The connected component of each piece, numbered from 0 in the order of first pieces.
std::vector<int> components_of(const std::vector<LinePiece>& pieces);

}  // namespace hepatica
