// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces of organs and vessels as voxels, for a CT that can be made from them.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "core/image/volume.h"

namespace hepatica::testing_support {

struct ClosedSurface {
    std::vector<Vec3> points_mm;
    std::vector<std::array<int, 3>> triangles;
};

// A legacy VTK file of polygons, which are cut into triangles. Throws InputError.
ClosedSurface read_surface(const std::filesystem::path& file);

// Sixty-fourths of each voxel that lie inside, counted on 4 x 4 x 4 points: those around which the
// surface winds, whichever way it is oriented. `grid` lies along the axes of space.
Image<std::uint8_t> inside_share(const ClosedSurface& surface, const Grid& grid);

}  // namespace hepatica::testing_support
