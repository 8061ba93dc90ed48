// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over all voxels of an image that can be cancelled: a reconstruction passes over tens of
// millions of voxels many times, and one uninterrupted pass takes longer than a user should wait.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/job.h"
#include "core/base/large_pages.h"
#include "core/base/parallel.h"
#include "core/image/volume.h"

namespace hepatica {

inline constexpr std::size_t voxels_between_looks = std::size_t{1} << 20;

// Calls body(i) for each i < count, on several threads and in any order; it may write only data of
// voxel i. Throws Cancelled.
template <class Body>
void for_each_voxel(std::size_t count, const Job& job, const Body& body) {
    parallel_blocks(count, voxels_between_looks, [&](std::size_t begin, std::size_t end) {
        job.throw_if_cancelled();
        for (std::size_t i = begin; i < end; ++i) body(i);
    });
}

// The same in order on the calling thread; body may write anything.
template <class Body>
void for_each_voxel_in_order(std::size_t count, const Job& job, const Body& body) {
    for (std::size_t begin = 0; begin < count; begin += voxels_between_looks) {
        job.throw_if_cancelled();
        const std::size_t end = std::min(count, begin + voxels_between_looks);
        for (std::size_t i = begin; i < end; ++i) body(i);
    }
}

// Image<T>(grid, value). Throws Cancelled.
template <class T>
Image<T> filled_image(const Grid& grid, T value, const Job& job) {
    Image<T> image;
    image.grid = grid;
    const std::size_t count = grid.count();
    image.voxels.reserve(count);
    prefer_large_pages(image.voxels.data(), count * sizeof(T));
    while (image.voxels.size() < count) {
        job.throw_if_cancelled();
        image.voxels.resize(std::min(count, image.voxels.size() + voxels_between_looks), value);
    }
    return image;
}

// A copy. Throws Cancelled.
template <class T>
Image<T> copied_image(const Image<T>& image, const Job& job) {
    Image<T> copy = filled_image(image.grid, T{}, job);
    for_each_voxel(copy.voxels.size(), job,
                   [&](std::size_t i) { copy.voxels[i] = image.voxels[i]; });
    return copy;
}

}  // namespace hepatica
