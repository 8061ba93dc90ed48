// SPDX-License-Identifier: GPL-3.0-or-later
// The Kuhn subdivision of a hexahedron.
#include "core/mesh/hex_mesh.h"

namespace hepatica {

std::vector<std::array<int, 4>> cut_into_tetrahedra(
    const std::vector<std::array<int, 8>>& hexahedra) {
    // Paths from corner 0 to corner 6 along one edge at a time; the last three have two corners
    // swapped so that all tetrahedra are right-handed.
    constexpr int paths[6][4] = {{0, 1, 2, 6}, {0, 3, 7, 6}, {0, 4, 5, 6},
                                 {0, 2, 3, 6}, {0, 7, 4, 6}, {0, 5, 1, 6}};
    std::vector<std::array<int, 4>> tetrahedra;
    tetrahedra.reserve(6 * hexahedra.size());
    for (const auto& corner : hexahedra)
        for (const auto& path : paths)
            tetrahedra.push_back(
                {corner[path[0]], corner[path[1]], corner[path[2]], corner[path[3]]});
    return tetrahedra;
}

}  // namespace hepatica
