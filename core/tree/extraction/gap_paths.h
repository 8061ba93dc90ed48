// SPDX-License-Identifier: GPL-3.0-or-later
// Minimal paths from an open end of a vessel through the CT to the mask of other pieces (Dijkstra
// over the 26 neighbours; bright voxels are cheap).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/vector.h"
#include "core/image/volume.h"

namespace hepatica {

struct GapPath {
    int piece = -1;                  // the piece that was reached
    std::vector<Vec3> points_mm;     // voxel centres, from the end to the first voxel of the piece
    std::vector<double> brightness;  // at each point: 0 parenchyma, 1 vessel
    double gap_mm = 0.0;             // length outside of all pieces
    double cost_mm = 0.0;
};

struct GapSearch {
    const Grid* grid = nullptr;
    // Piece whose mask a voxel belongs to, -1 for none. Paths may lead a little way
    // back into the piece they start from, as through a bulge of its mask.
    std::function<int(std::size_t offset)> piece_of;
    // 0 where it is as dark as parenchyma, 1 where it is as bright as a vessel.
    std::function<double(const Vec3& position_mm)> brightness;
    double longest_gap_mm = 15.0;
    // A dark millimetre costs ten: four of them, or forty bright ones.
    double longest_cost_mm = 40.0;
    // Where the only other piece lies, if that is known: voxels from which it can no longer be
    // reached as cheaply are then not searched (A*; a millimetre costs one at least). The path
    // costs the same.
    std::optional<Vec3> goal_mm{};
};

// The cheapest path from a voxel to each other piece in reach, in the order in which they are
// found.
std::vector<GapPath> gap_paths(const GapSearch& search, int own_piece, const Index3& start);

}  // namespace hepatica
