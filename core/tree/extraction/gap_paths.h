// SPDX-License-Identifier: GPL-3.0-or-later
// Minimal paths from an open end of a vessel through the CT to the mask of other pieces: Dijkstra's
// algorithm over the 26 neighbours, or A* with a goal; bright voxels are cheap.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/vector.h"
#include "core/image/volume.h"

namespace hepatica {

struct GapPath {
    int piece = -1;                  // the piece reached
    std::vector<Vec3> points_mm;     // voxel centres, from the end to the first voxel of the piece
    std::vector<double> brightness;  // at each point: 0 parenchyma, 1 vessel
    double gap_mm = 0.0;             // length outside all pieces
    double cost_mm = 0.0;
};

struct GapSearch {
    const Grid* grid = nullptr;
    // Piece that a voxel belongs to, -1 for none. Paths may enter the piece they start from for up
    // to 4 mm, as through a bulge of its mask.
    std::function<int(std::size_t offset)> piece_of;
    // 0 as dark as parenchyma, 1 as bright as a vessel.
    std::function<double(const Vec3& position_mm)> brightness;
    double longest_gap_mm = 15.0;
    // A dark millimetre costs 10, a bright one 1: the limit is 4 dark or 40 bright millimetres.
    double longest_cost_mm = 40.0;
    // Position of the only other piece, if known: the search is then guided towards it (A*; the
    // distance is a lower bound, because a millimetre costs at least 1). The cost of the path stays
    // the same.
    std::optional<Vec3> goal_mm{};
};

// The cheapest path from a voxel to each other piece in reach, in the order of their cost.
std::vector<GapPath> gap_paths(const GapSearch& search, int own_piece, const Index3& start);

}  // namespace hepatica
