// SPDX-License-Identifier: GPL-3.0-or-later
// Plain loops over the voxels.
#include "core/image/mask.h"

#include <algorithm>
#include <cstdint>

namespace hepatica {

std::size_t object_count(const Mask& mask) {
    return mask.voxels.size() - static_cast<std::size_t>(std::count(
                                    mask.voxels.begin(), mask.voxels.end(), std::uint8_t{0}));
}

Mask complement(const Mask& mask) {
    Mask others(mask.grid);
    std::transform(mask.voxels.begin(), mask.voxels.end(), others.voxels.begin(),
                   [](std::uint8_t v) { return static_cast<std::uint8_t>(v == 0); });
    return others;
}

}  // namespace hepatica
