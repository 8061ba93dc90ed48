// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes of voxels and crops. See resample.cpp and gaussian.cpp for the other filters of the header.
#include "core/image/filters.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hepatica {

namespace {

IndexBox clipped(const IndexBox& box, const Grid& grid) {
    IndexBox inside;
    for (int a = 0; a < 3; ++a) {
        inside.begin[a] = std::clamp(box.begin[a], 0, grid.dims[a]);
        inside.end[a] = std::clamp(box.end[a], 0, grid.dims[a]);
    }
    if (inside.empty())
        throw InputError("holds no voxel of the image", "crop box",
                         "Choose a region inside the image");
    return inside;
}

template <class T>
Image<T> crop_image(const Image<T>& image, const IndexBox& box) {
    const IndexBox inside = clipped(box, image.grid);
    Image<T> part(crop(image.grid, box));
    const Grid& grid = part.grid;
    for (int z = 0; z < grid.dims[2]; ++z)
        for (int y = 0; y < grid.dims[1]; ++y) {
            const T* row = &image.at(inside.begin[0], inside.begin[1] + y, inside.begin[2] + z);
            std::copy_n(row, grid.dims[0], &part.at(0, y, z));
        }
    return part;
}

// First and last object voxel of a row; {n, -1} if there is none. Skips zeros eight at a time.
std::pair<int, int> extent_of_row(const std::uint8_t* row, int n) {
    int first = 0;
    while (first + 8 <= n) {
        std::uint64_t word;
        std::memcpy(&word, row + first, 8);
        if (word != 0) break;
        first += 8;
    }
    while (first < n && row[first] == 0) ++first;
    if (first == n) return {n, -1};
    int last = n - 1;
    while (row[last] == 0) --last;
    return {first, last};
}

}  // namespace

IndexBox bounding_box(const Mask& mask) {
    const Grid& grid = mask.grid;
    IndexBox box{grid.dims, {0, 0, 0}};
    for (int z = 0; z < grid.dims[2]; ++z)
        for (int y = 0; y < grid.dims[1]; ++y) {
            const auto [first, last] =
                extent_of_row(mask.voxels.data() + grid.offset(0, y, z), grid.dims[0]);
            if (last < 0) continue;
            box.begin = {std::min(box.begin[0], first), std::min(box.begin[1], y),
                         std::min(box.begin[2], z)};
            box.end = {std::max(box.end[0], last + 1), std::max(box.end[1], y + 1), z + 1};
        }
    return box;
}

IndexBox grow_box(const IndexBox& box, const Grid& grid, double margin_mm) {
    if (box.empty()) return {};  // around nothing there is no margin
    IndexBox grown;
    for (int a = 0; a < 3; ++a) {
        const int margin = static_cast<int>(std::ceil(margin_mm / grid.spacing_mm[a]));
        grown.begin[a] = std::max(0, box.begin[a] - margin);
        grown.end[a] = std::min(grid.dims[a], box.end[a] + margin);
    }
    return grown;
}

Eigen::AlignedBox3d box_mm(const IndexBox& box, const Grid& grid) {
    Eigen::AlignedBox3d space;
    if (box.empty()) return space;
    for (int corner = 0; corner < 8; ++corner) {
        const auto along = [&](int axis) {
            return (corner >> axis & 1) != 0 ? box.end[axis] - 1 : box.begin[axis];
        };
        space.extend(grid.to_mm(along(0), along(1), along(2)));
    }
    return space;
}

Grid crop(const Grid& grid, const IndexBox& box) {
    const IndexBox inside = clipped(box, grid);
    Grid part = grid;
    part.origin_mm = grid.to_mm(inside.begin[0], inside.begin[1], inside.begin[2]);
    for (int a = 0; a < 3; ++a) part.dims[a] = inside.end[a] - inside.begin[a];
    return part;
}

Volume crop(const Volume& volume, const IndexBox& box) {
    return crop_image(volume, box);
}
FloatVolume crop(const FloatVolume& volume, const IndexBox& box) {
    return crop_image(volume, box);
}
Mask crop(const Mask& mask, const IndexBox& box) {
    return crop_image(mask, box);
}

FloatVolume to_float(const Volume& volume) {
    FloatVolume image(volume.grid);
    parallel_blocks(volume.voxels.size(), 1 << 18, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            image.voxels[i] = static_cast<float>(volume.voxels[i]);
    });
    return image;
}

}  // namespace hepatica
