// SPDX-License-Identifier: GPL-3.0-or-later
// Disturbances that make a real liver's CT harder to read than a clean phantom: uneven perfusion,
// mottle, tumours, fat in fissures, arteries and bile ducts beside the portal vein, unmixed
// contrast medium, noise with a spectrum, streaks. Each is off by default.
#pragma once

#include <cstdint>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Values in HU are relative to the parenchyma unless stated otherwise.
struct Disturbances {
    double perfusion_hu = 0.0;   // standard deviation of a field correlated over 30 mm, 0 to 100
    double mottle_hu = 0.0;      // the same of a fine field, 0 to 100, correlated over
    double mottle_mm = 2.0;      // mottle_mm, 0.5 to 10
    int tumours = 0;             // 0 to 20, with radii of 4 to 18 mm
    double tumour_hu = -40.0;    // -150 to 150
    double tumour_rim_hu = 0.0;  // of a shell 2 mm thick on each surface, -150 to 150; 0: none
    int fissures = 0;            // 0 to 10 sheets of fat that reach into the liver
    // Radius of an artery beside each portal branch, relative to that branch: 0 (none) to 0.8.
    // Arteries thinner than 0.4 mm are left out. Enhanced arteries are vessels of the truth.
    double artery_share = 0.0;
    double artery_hu = 0.0;     // 0 to 300
    double duct_share = 0.0;    // the same of a bile duct on the opposite side, 0 to 0.8
    double duct_hu = -60.0;     // -150 to 0
    double streaming_hu = 0.0;  // standard deviation of the contrast along the vessels, 0 to 50
    // Of the noise: the standard deviation of the Gaussian that correlates it within a slice, 0.2
    // to 3, or 0 for the plain phantom's noise; and the share of its slow part that is subtracted,
    // 0 to 1, as sharp kernels do. Below 0.2 neither Gaussian reaches the next voxel: the noise
    // would be white, less correlated than the plain one, and a sharpness of 1 would subtract all
    // of it.
    double noise_correlation_mm = 0.0;
    double noise_sharpness = 0.0;
    int streaks = 0;                     // 0 to 40 lines across the body, each several slices high
    double streak_hu = 0.0;              // greatest amplitude, 0 to 100
    double slice_spread_sigma_mm = 0.0;  // additional point spread along z, 0 to 5

    bool operator==(const Disturbances&) const = default;
};

// Throws InputError, naming the value, where one is outside its range.
void validate(const Disturbances& disturbances);

// A Gaussian random field with mean 0 and standard deviation of about 1, correlated over about
// correlation_mm > 0. Deterministic for a seed. Throws Cancelled.
FloatVolume smooth_field(const Grid& grid, double correlation_mm, std::uint64_t seed, Job& job);

// Vessels beside the portal branches of a tree, `share` times as wide, displaced towards `side` (a
// unit vector). They have nodes and segments of their own; branches thinner than 0.4 mm are left
// out.
VesselTree companions(const VesselTree& tree, double share, const Vec3& side,
                      VascularSystem system);

// Adds perfusion, mottle, tumours, fissures and streaming to a clean image before it is blurred.
// `lumen` holds sixty-fourths of each voxel; parenchyma_hu is that of the clean liver. The same
// bytes for any number of threads. Throws Cancelled.
void disturb_tissue(FloatVolume& image, const Mask& liver, const Image<std::uint8_t>& lumen,
                    const Disturbances& disturbances, double parenchyma_hu, std::uint64_t seed,
                    Job& job);

// Noise of standard deviation 1 with the requested spectrum. Throws Cancelled.
FloatVolume correlated_noise(const Grid& grid, const Disturbances& disturbances, std::uint64_t seed,
                             Job& job);

// Adds streaks to an image that is already blurred.
void add_streaks(FloatVolume& image, const Disturbances& disturbances, std::uint64_t seed);

}  // namespace hepatica
