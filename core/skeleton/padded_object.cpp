// SPDX-License-Identifier: GPL-3.0-or-later
// The padded copy of a mask, its neighbourhoods and its lists of voxels.
#include "core/skeleton/padded_object.h"

#include <algorithm>
#include <cstring>

#include "core/image/filters.h"

namespace hepatica {

namespace {

constexpr int margin = 2;

}  // namespace

PaddedObject::PaddedObject(const Mask& mask) : grid_(mask.grid) {
    if (mask.voxels.empty()) return;
    const IndexBox box = bounding_box(mask);
    if (box.empty()) return;
    for (int a = 0; a < 3; ++a) {
        dims_[a] = box.end[a] - box.begin[a] + 2 * margin;
        corner_[a] = box.begin[a] - margin;
    }
    voxels_.assign(
        static_cast<std::size_t>(dims_[0]) * dims_[1] * static_cast<std::size_t>(dims_[2]), 0);
    for (int z = box.begin[2]; z < box.end[2]; ++z)
        for (int y = box.begin[1]; y < box.end[1]; ++y) {
            const std::uint8_t* from = &mask.at(box.begin[0], y, z);
            std::uint8_t* to = &voxels_[step(margin, y - corner_[1], z - corner_[2])];
            for (int x = 0; x < box.end[0] - box.begin[0]; ++x) to[x] = from[x] != 0;
        }
}

std::uint32_t PaddedObject::neighbourhood(std::size_t p) const {
    std::uint32_t bits = 0;
    int shift = 0;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy, shift += 3) {
            // Reads four bytes; the margin of the box makes the fourth one readable.
            std::uint32_t row;
            std::memcpy(&row, &voxels_[p + step(-1, dy, dz)], sizeof row);
            row &= 0x010101u;
            bits |= ((row | row >> 7 | row >> 14) & 7u) << shift;
        }
    return bits;
}

std::array<std::ptrdiff_t, 6> PaddedObject::face_steps() const {
    return {step(-1, 0, 0), step(1, 0, 0),  step(0, -1, 0),
            step(0, 1, 0),  step(0, 0, -1), step(0, 0, 1)};
}

std::array<std::ptrdiff_t, 26> PaddedObject::neighbour_steps() const {
    std::array<std::ptrdiff_t, 26> steps{};
    int n = 0;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (dx != 0 || dy != 0 || dz != 0) steps[n++] = step(dx, dy, dz);
    return steps;
}

std::vector<std::size_t> PaddedObject::object_voxels() const {
    std::vector<std::size_t> found;
    for (std::size_t p = 0; p < voxels_.size(); ++p)
        if (voxels_[p] & 1) found.push_back(p);
    return found;
}

std::vector<std::size_t> PaddedObject::border_voxels() const {
    std::vector<std::size_t> found;
    const auto faces = face_steps();
    for (std::size_t p = 0; p < voxels_.size(); ++p)
        if ((voxels_[p] & 1) &&
            std::ranges::any_of(faces, [&](std::ptrdiff_t s) { return !contains(p + s); }))
            found.push_back(p);
    return found;
}

Index3 PaddedObject::index_in_mask(std::size_t p) const {
    const auto nx = static_cast<std::size_t>(dims_[0]);
    const auto ny = static_cast<std::size_t>(dims_[1]);
    return {static_cast<int>(p % nx) + corner_[0], static_cast<int>(p / nx % ny) + corner_[1],
            static_cast<int>(p / (nx * ny)) + corner_[2]};
}

std::size_t PaddedObject::offset_in_mask(std::size_t p) const {
    const auto [x, y, z] = index_in_mask(p);
    return grid_.offset(x, y, z);
}

Mask PaddedObject::to_mask() const {
    Mask mask(grid_);
    for (std::size_t p = 0; p < voxels_.size(); ++p)
        if (voxels_[p] & 1) mask.voxels[offset_in_mask(p)] = 1;
    return mask;
}

}  // namespace hepatica
