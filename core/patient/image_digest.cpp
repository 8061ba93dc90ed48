// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/image_digest.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/sha256.h"

namespace hepatica {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are digested as they lie");

constexpr double micrometres_per_mm = 1000.0;
constexpr double millionths = 1e6;

void add(Sha256& digest, double value, double steps) {
    const auto rounded = static_cast<std::int64_t>(std::llround(value * steps));
    digest.add_bytes(&rounded, sizeof rounded);
}

}  // namespace

std::string digest_of(const Volume& ct) {
    Sha256 digest;
    const Grid& grid = ct.grid;
    for (const int size : grid.dims) add(digest, size, 1.0);
    for (const double spacing : grid.spacing_mm) add(digest, spacing, micrometres_per_mm);
    for (const double place : grid.origin_mm) add(digest, place, micrometres_per_mm);
    for (int axis = 0; axis < 3; ++axis)
        for (int row = 0; row < 3; ++row) add(digest, grid.direction(row, axis), millionths);
    digest.add_bytes(ct.voxels.data(), ct.voxels.size() * sizeof ct.voxels[0]);
    return digest.hex_digest();
}

}  // namespace hepatica
