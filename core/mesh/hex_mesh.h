// SPDX-License-Identifier: GPL-3.0-or-later
// A body as hexahedra of eight corners. Plain data.
#pragma once

#include <array>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Corners in VTK's order: 0-3 counter-clockwise around the bottom seen from above, 4-7 above them.
struct HexMesh {
    std::vector<Vec3> vertices_mm;
    std::vector<std::array<int, 8>> hexahedra;
};

}  // namespace hepatica
