// SPDX-License-Identifier: GPL-3.0-or-later
// Compares seeds with the image's extent and the liver's voxels.
#include "core/reconstruction/seed_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr double seed_reach_mm = 10.0;

std::string text_of(const Vec3& position_mm) {
    char text[96];
    std::snprintf(text, sizeof text, "%.6g,%.6g,%.6g", position_mm.x(), position_mm.y(),
                  position_mm.z());
    return text;
}

// The option as the window knows its two fields by it.
const char* option_of(const VesselSeed& seed) {
    if (seed.system == VascularSystem::portal) return "--seed-mm X,Y,Z,portal";
    if (seed.system == VascularSystem::hepatic) return "--seed-mm X,Y,Z,hepatic";
    if (seed.system == VascularSystem::artery) return "--seed-mm X,Y,Z,artery";
    return "--seed-mm";
}

}  // namespace

void require_seeds_in_image(const std::vector<VesselSeed>& seeds, const Grid& grid) {
    for (const VesselSeed& seed : seeds) {
        if (holds(grid, seed.position_mm)) continue;
        const Vec3 corner = grid.to_mm(0, 0, 0);
        const Vec3 opposite = grid.to_mm(grid.dims[0] - 1, grid.dims[1] - 1, grid.dims[2] - 1);
        throw InputError(text_of(seed.position_mm) +
                             " lies outside the image, which reaches from " + text_of(corner) +
                             " to " + text_of(opposite),
                         option_of(seed),
                         "Give a place inside a vessel, in mm to the patient's left, back and head "
                         "(LPS); other programs may show RAS: there change the sign of X and Y");
    }
}

void require_seeds_near_liver(const std::vector<VesselSeed>& seeds, const Mask& liver,
                              const std::string& liver_place) {
    for (const VesselSeed& seed : seeds) {
        double nearest_mm = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
            if (liver.voxels[i] == 0) continue;
            const auto [x, y, z] = liver.grid.index_of(i);
            nearest_mm =
                std::min(nearest_mm, (liver.grid.to_mm(x, y, z) - seed.position_mm).norm());
            if (nearest_mm <= seed_reach_mm) break;
        }
        if (nearest_mm <= seed_reach_mm) continue;
        throw InputError(text_of(seed.position_mm) + " lies " +
                             std::to_string(std::lround(nearest_mm)) + " mm from the liver of " +
                             liver_place,
                         option_of(seed),
                         "Give a place inside a vessel in or at the liver, in mm to the patient's "
                         "left, back and "
                         "head (LPS)");
    }
}

}  // namespace hepatica
