// SPDX-License-Identifier: GPL-3.0-or-later
// The 26-neighbourhood of a voxel, in the order of memory: x fastest, then y, then z.
#pragma once

#include <array>
#include <cstddef>

#include "core/image/volume.h"

namespace hepatica {

// Calls visit(neighbour) for the 26 neighbours inside the grid.
template <class Visit>
void for_each_neighbour(const Grid& grid, std::size_t voxel, const Visit& visit) {
    const Index3 at = grid.index_of(voxel);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if ((x != 0 || y != 0 || z != 0) && grid.contains(at[0] + x, at[1] + y, at[2] + z))
                    visit(grid.offset(at[0] + x, at[1] + y, at[2] + z));
}

struct NeighbourStep {
    Index3 step{0, 0, 0};
    double length_mm = 0.0;
};

// The steps to the 26 neighbours; the one at 25 - i is opposite to the one at i.
inline std::array<NeighbourStep, 26> neighbour_steps(const Grid& grid) {
    std::array<NeighbourStep, 26> steps;
    std::size_t count = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (x != 0 || y != 0 || z != 0)
                    steps[count++] = {{x, y, z},
                                      Vec3(x, y, z).cwiseProduct(grid.spacing_mm).norm()};
    return steps;
}

}  // namespace hepatica
