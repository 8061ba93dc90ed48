// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds rounded geometry and voxels of a CT to SHA-256.
#include "core/patient/image_digest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/sha256.h"

namespace hepatica {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are digested as they lie");

constexpr double micrometres_per_mm = 1000.0;
constexpr double millionths = 1e6;
constexpr std::size_t voxels_at_once = std::size_t{1} << 21;

void add(Sha256& digest, double value, double steps) {
    const auto rounded = static_cast<std::int64_t>(std::llround(value * steps));
    digest.add_bytes(&rounded, sizeof rounded);
}

}  // namespace

std::string digest_of(const Volume& ct) {
    Job nobodys;
    return digest_of(ct, nobodys);
}

std::string digest_of(const Volume& ct, Job& job) {
    Sha256 digest;
    const Grid& grid = ct.grid;
    for (const int size : grid.dims) add(digest, size, 1.0);
    for (const double spacing : grid.spacing_mm) add(digest, spacing, micrometres_per_mm);
    for (const double place : grid.origin_mm) add(digest, place, micrometres_per_mm);
    for (int axis = 0; axis < 3; ++axis)
        for (int row = 0; row < 3; ++row) add(digest, grid.direction(row, axis), millionths);
    const std::size_t size = ct.voxels.size();
    for (std::size_t done = 0; done < size; done += voxels_at_once) {
        job.advance(static_cast<double>(done) / static_cast<double>(size));
        digest.add_bytes(&ct.voxels[done],
                         std::min(voxels_at_once, size - done) * sizeof ct.voxels[0]);
    }
    return digest.hex_digest();
}

}  // namespace hepatica
