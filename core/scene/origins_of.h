// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertex of the whole body each vertex of a torn one was split from.
#pragma once

#include <cstddef>
#include <vector>

#include "core/tear/torn_topology.h"

namespace hepatica {

// One entry per vertex, itself for a vertex of the whole body. Costs one pass over the vertices.
inline std::vector<int> origins_of(const TornTopology& torn) {
    std::vector<int> origins(torn.parents().begin(), torn.parents().end());
    for (int& origin : origins) origin = origins[static_cast<std::size_t>(origin)];
    return origins;
}

}  // namespace hepatica
