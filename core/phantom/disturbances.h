// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a real liver's CT harder to read than a clean phantom: uneven perfusion, mottle,
// tumours, fat in fissures, arteries and bile ducts beside the portal vein, contrast medium that
// has not mixed, noise with a spectrum, streaks. Each is off unless asked for.
#pragma once

#include <cstdint>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Values in HU are relative to the parenchyma where nothing else is said.
struct Disturbances {
    double perfusion_hu = 0.0;   // standard deviation of a slow field, 0 to 100
    double mottle_hu = 0.0;      // the same of a fine one, 0 to 100, with a correlation length of
    double mottle_mm = 2.0;      // 0.5 to 10
    int tumours = 0;             // 0 to 20, of 4 to 18 mm in radius
    double tumour_hu = -40.0;    // -150 to 150
    double tumour_rim_hu = 0.0;  // of a shell of 2 mm around each, -150 to 150
    int fissures = 0;            // 0 to 10 sheets of fat that reach into the liver
    // Radius of an artery beside each portal branch, as a share of that branch's: 0 (none) to 0.8;
    // what would be thinner than 0.4 mm is left out. Enhanced arteries are vessels of the truth.
    double artery_share = 0.0;
    double artery_hu = 0.0;     // 0 to 300
    double duct_share = 0.0;    // the same of a bile duct on the other side
    double duct_hu = -60.0;     // -150 to 0
    double streaming_hu = 0.0;  // standard deviation of the contrast along the vessels, 0 to 50
    // Of the noise: 0 for the plain phantom's, else the standard deviation of the Gaussian that
    // correlates it within a slice, 0.2 to 3, and by how much of the slower part is taken out of
    // it, 0 to 1, as sharp kernels do.
    double noise_correlation_mm = 0.0;
    double noise_sharpness = 0.0;
    int streaks = 0;                     // 0 to 40 across the body, each some slices high
    double streak_hu = 0.0;              // their height, 0 to 100
    double slice_spread_sigma_mm = 0.0;  // point spread along z in addition, 0 to 5

    bool operator==(const Disturbances&) const = default;
};

// Throws InputError, naming the value, where one is outside its range.
void validate(const Disturbances& disturbances);

// A field of standard deviation 1 and mean 0, correlated over about correlation_mm > 0.
FloatVolume smooth_field(const Grid& grid, double correlation_mm, std::uint64_t seed, Job& job);

// Vessels that run beside those of the portal system, `share` times as wide; toward one side of the
// patient. Nodes and segments of their own; what is thinner than 0.4 mm is left out.
VesselTree companions(const VesselTree& tree, double share, const Vec3& side,
                      VascularSystem system);

// Changes a clean image of the liver and its vessels (`lumen`: sixty-fourths of each voxel) before
// it is blurred. parenchyma_hu: of the clean liver. Same bytes for any number of threads.
void disturb_tissue(FloatVolume& image, const Mask& liver, const Image<std::uint8_t>& lumen,
                    const Disturbances& disturbances, double parenchyma_hu, std::uint64_t seed,
                    Job& job);

// Noise of standard deviation 1 with the spectrum that is asked for.
FloatVolume correlated_noise(const Grid& grid, const Disturbances& disturbances, std::uint64_t seed,
                             Job& job);

// Adds streaks to an image that has been blurred.
void add_streaks(FloatVolume& image, const Disturbances& disturbances, std::uint64_t seed);

}  // namespace hepatica
