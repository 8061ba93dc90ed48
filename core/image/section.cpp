// SPDX-License-Identifier: GPL-3.0-or-later
// Connected patches of the object's voxels that touch the other mask.
#include "core/image/section.h"

#include <cmath>

#include "core/image/morphology.h"

namespace hepatica {

namespace {

bool meets(const Mask& object, const Mask& beyond, const Index3& at) {
    for (int face = 0; face < 6; ++face) {
        Index3 beside = at;
        beside[face / 2] += face % 2 == 0 ? 1 : -1;
        if (!object.grid.contains(beside[0], beside[1], beside[2])) continue;
        const std::size_t n = object.grid.offset(beside[0], beside[1], beside[2]);
        if (beyond.voxels[n] != 0 && object.voxels[n] == 0) return true;
    }
    return false;
}

}  // namespace

std::optional<Section> largest_section(const Mask& object, const Mask& beyond) {
    const Grid& grid = object.grid;
    Mask border(grid);
    for (std::size_t i = 0; i < border.voxels.size(); ++i)
        border.voxels[i] = object.voxels[i] != 0 && meets(object, beyond, grid.index_of(i));
    const Components patches = connected_components(border, Connectivity::all26);
    if (patches.sizes.empty()) return std::nullopt;
    Section section;
    for (std::size_t i = 0; i < border.voxels.size(); ++i) {
        if (patches.labels.voxels[i] != 1) continue;
        const auto [x, y, z] = grid.index_of(i);
        section.middle_mm += grid.to_mm(x, y, z);
    }
    const auto voxels = static_cast<double>(patches.sizes.front());
    section.middle_mm /= voxels;
    section.area_mm2 = voxels * std::pow(grid.spacing_mm.prod(), 2.0 / 3.0);
    return section;
}

}  // namespace hepatica
