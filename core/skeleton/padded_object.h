// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding box of a mask's object with a margin of two background voxels, one byte per voxel.
// The lowest bit means "object". Neighbourhoods of 27 bits can be read without tests for borders.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image/volume.h"

namespace hepatica {

// Bit of the neighbour (dx, dy, dz), each in {-1, 0, 1}, in a 27-bit neighbourhood.
constexpr int neighbour_bit(int dx, int dy, int dz) {
    return (dx + 1) + 3 * (dy + 1) + 9 * (dz + 1);
}
inline constexpr std::uint32_t centre_bit = 1u << neighbour_bit(0, 0, 0);

// A voxel `p` is an offset in the padded box. Not thread-safe for writing; several threads may
// read.
class PaddedObject {
  public:
    // Any nonzero voxel of the mask is object.
    explicit PaddedObject(const Mask& mask);

    bool empty() const { return dims_[0] == 0; }
    bool contains(std::size_t p) const { return voxels_[p] & 1; }
    void remove(std::size_t p) { voxels_[p] &= static_cast<std::uint8_t>(~1u); }

    // A second bit per voxel, free for the algorithm's own use; unset at first.
    bool marked(std::size_t p) const { return voxels_[p] & 2; }
    void mark(std::size_t p) { voxels_[p] |= 2; }
    void unmark(std::size_t p) { voxels_[p] &= static_cast<std::uint8_t>(~2u); }

    // Object bits of the 3 x 3 x 3 voxels around p (and p itself). p must not lie in the outermost
    // layer of the margin.
    std::uint32_t neighbourhood(std::size_t p) const;

    // Distance in memory from a voxel to its neighbour (dx, dy, dz).
    std::ptrdiff_t step(int dx, int dy, int dz) const {
        return dx + dims_[0] * (dy + dims_[1] * static_cast<std::ptrdiff_t>(dz));
    }
    // The voxels in directions -x, +x, -y, +y, -z, +z (W, E, S, N, D, U).
    std::array<std::ptrdiff_t, 6> face_steps() const;
    // The 26 neighbours, in the order of their bits.
    std::array<std::ptrdiff_t, 26> neighbour_steps() const;

    // All object voxels, in ascending order.
    std::vector<std::size_t> object_voxels() const;
    // Those of them with background among their six face neighbours.
    std::vector<std::size_t> border_voxels() const;

    // Index and offset of the voxel on the grid of the mask.
    Index3 index_in_mask(std::size_t p) const;
    std::size_t offset_in_mask(std::size_t p) const;
    // The object as a mask of 0 and 1 on the original grid.
    Mask to_mask() const;

  private:
    Grid grid_;
    Index3 dims_{0, 0, 0};    // size of the padded box
    Index3 corner_{0, 0, 0};  // index, in the mask, of the first voxel of the padded box
    std::vector<std::uint8_t> voxels_;
};

}  // namespace hepatica
