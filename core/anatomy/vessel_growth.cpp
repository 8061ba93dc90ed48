// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anatomy/vessel_growth.h"

#include <cstdint>
#include <vector>

#include "core/image/morphology.h"

namespace hepatica {

Mask hysteresis(const Mask& strong, const Mask& weak, double minimum_mm3) {
    const Components pieces = connected_components(weak, Connectivity::all26);
    std::vector<std::uint8_t> kept(pieces.sizes.size() + 1, 0);
    for (std::size_t i = 0; i < weak.voxels.size(); ++i)
        if (strong.voxels[i]) kept[pieces.labels.voxels[i]] = 1;
    kept[0] = 0;
    const double voxel_mm3 = weak.grid.spacing_mm.prod();
    for (std::size_t p = 0; p < pieces.sizes.size(); ++p)
        if (static_cast<double>(pieces.sizes[p]) * voxel_mm3 < minimum_mm3) kept[p + 1] = 0;
    Mask mask(weak.grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        mask.voxels[i] = kept[pieces.labels.voxels[i]];
    return mask;
}

}  // namespace hepatica
