// SPDX-License-Identifier: GPL-3.0-or-later
// Grids of voxels in patient space: LPS axes (x to the left, y to the back, z to the head),
// millimetres.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/large_pages.h"
#include "core/base/vector.h"

namespace hepatica {

// A grid of voxels in space. Index (0,0,0) is the centre of the first voxel; x runs fastest.
struct Grid {
    Index3 dims{0, 0, 0};
    Vec3 spacing_mm{1, 1, 1};           // all > 0
    Vec3 origin_mm{0, 0, 0};            // centre of voxel (0,0,0)
    Mat3 direction = Mat3::Identity();  // columns: unit vectors of the index axes, orthonormal

    std::size_t count() const {
        return static_cast<std::size_t>(dims[0]) * dims[1] * static_cast<std::size_t>(dims[2]);
    }
    std::size_t offset(int x, int y, int z) const {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(dims[0]) *
                   (static_cast<std::size_t>(y) + static_cast<std::size_t>(dims[1]) * z);
    }
    bool contains(int x, int y, int z) const {
        return x >= 0 && y >= 0 && z >= 0 && x < dims[0] && y < dims[1] && z < dims[2];
    }
    Index3 index_of(std::size_t offset) const {
        const auto nx = static_cast<std::size_t>(dims[0]);
        const auto ny = static_cast<std::size_t>(dims[1]);
        return {static_cast<int>(offset % nx), static_cast<int>(offset / nx % ny),
                static_cast<int>(offset / (nx * ny))};
    }
    // Continuous index to millimetres and back.
    Vec3 to_mm(const Vec3& index) const {
        return origin_mm + direction * index.cwiseProduct(spacing_mm);
    }
    Vec3 to_mm(int x, int y, int z) const { return to_mm(Vec3(x, y, z)); }
    Vec3 to_index(const Vec3& position_mm) const {
        return (direction.transpose() * (position_mm - origin_mm)).cwiseQuotient(spacing_mm);
    }
};

template <class T>
struct Image {
    Grid grid;
    std::vector<T> voxels;  // grid.count() values, x fastest

    Image() = default;
    explicit Image(const Grid& where, T value = T{}) : grid(where) {
        make_room(where.count());
        voxels.assign(where.count(), value);
    }
    Image(const Image& other) : grid(other.grid) {
        make_room(other.voxels.size());
        voxels = other.voxels;
    }
    Image& operator=(const Image& other) {
        if (this != &other) *this = Image(other);
        return *this;
    }
    Image(Image&&) noexcept = default;
    Image& operator=(Image&&) noexcept = default;
    ~Image() = default;

    T& at(int x, int y, int z) { return voxels[grid.offset(x, y, z)]; }
    const T& at(int x, int y, int z) const { return voxels[grid.offset(x, y, z)]; }

  private:
    // Must be called before the first voxel is written.
    void make_room(std::size_t count) {
        voxels.reserve(count);
        prefer_large_pages(voxels.data(), count * sizeof(T));
    }
};

using Volume = Image<std::int16_t>;  // a CT, in Hounsfield units
using FloatVolume = Image<float>;    // filtered intensities, distances
using Mask = Image<std::uint8_t>;    // 0 background, anything else object
using LabelMap = Image<std::uint16_t>;

// The voxel that contains a position, outer faces of the grid included; nothing outside the grid
// and for positions that are not finite.
std::optional<Index3> voxel_at(const Grid& grid, const Vec3& position_mm);

// The voxel whose centre is nearest to a finite position, which may lie outside the grid. The grid
// must not be empty.
Index3 nearest_voxel(const Grid& grid, const Vec3& position_mm);

// Whether a position lies in one of the voxels.
inline bool holds(const Grid& grid, const Vec3& position_mm) {
    return voxel_at(grid, position_mm).has_value();
}

// The value of the voxel that contains a position; T{} outside the image.
template <class T>
T value_at(const Image<T>& image, const Vec3& position_mm) {
    const std::optional<Index3> voxel = voxel_at(image.grid, position_mm);
    return voxel ? image.at((*voxel)[0], (*voxel)[1], (*voxel)[2]) : T{};
}

// True if both grids have the same dims and their corners agree to a hundredth of the smallest
// spacing.
bool same_grid(const Grid& a, const Grid& b);

}  // namespace hepatica
