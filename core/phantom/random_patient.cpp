// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the options of a random patient, and distorts the border of a liver mask at random.
#include "core/phantom/random_patient.h"

#include <algorithm>
#include <cmath>

#include "core/image/morphology.h"
#include "core/phantom/phantom_body.h"
#include "core/phantom/phantom_random.h"

namespace hepatica {

namespace {

constexpr double field_margin_mm = 6.0;
constexpr double ripple_mm = 1.0;
constexpr double ripple_length_mm = 8.0;

// Random values, many of them small and few large.
double mostly_small(PhantomRandom& random, double low, double high) {
    const double u = random.uniform();
    return low + (high - low) * u * u;
}

bool happens(PhantomRandom& random, double probability) {
    return random.uniform() < probability;
}

int whole(PhantomRandom& random, int low, int high) {
    return static_cast<int>(std::floor(random.uniform(low, high + 1.0)));
}

void draw_grid(PhantomRandom& random, PhantomOptions& options) {
    const double pixel = random.uniform(0.6, 0.9);
    const double slices =
        happens(random, 0.7) ? random.uniform(0.7, 2.0) : random.uniform(2.0, 5.0);
    options.spacing_mm = {pixel, pixel, slices};
    const Vec3 extent = PhantomBody::liver_high() - PhantomBody::liver_low() +
                        Vec3::Constant(2.0 * field_margin_mm);
    for (int axis = 0; axis < 3; ++axis)
        options.dims[axis] = static_cast<int>(std::ceil(extent[axis] / options.spacing_mm[axis]));
}

void draw_vessels(PhantomRandom& random, PhantomOptions& options) {
    options.systems = 2;
    options.touching = whole(random, 0, 8);
    options.touch_fewer = true;
    options.generations = whole(random, 6, 8);
    options.root_radius_mm = random.uniform(4.5, 7.5);
    options.murray_exponent = random.uniform(2.6, 3.1);
    options.parenchyma_hu = random.uniform(60.0, 140.0);
    options.contrast_hu = random.uniform(20.0, 110.0);
    options.hepatic_contrast_hu = options.contrast_hu * random.uniform(0.3, 1.1);
}

Disturbances draw_disturbances(PhantomRandom& random, const PhantomOptions& options) {
    Disturbances d;
    d.perfusion_hu = mostly_small(random, 1.0, 14.0);
    d.mottle_hu = mostly_small(random, 0.0, 0.25 * options.noise_hu + 2.0);
    d.mottle_mm = random.uniform(1.0, 4.0);
    d.tumours = happens(random, 0.5) ? whole(random, 1, 8) : 0;
    d.tumour_hu = random.uniform(-70.0, 25.0);
    d.tumour_rim_hu = happens(random, 0.4) ? random.uniform(10.0, 60.0) : 0.0;
    d.fissures = whole(random, 0, 4);
    const bool enhanced = happens(random, 0.5);
    d.artery_share = enhanced ? random.uniform(0.25, 0.5) : 0.0;
    d.artery_hu = enhanced ? random.uniform(0.3, 1.2) * options.contrast_hu : 0.0;
    d.duct_share = happens(random, 0.5) ? random.uniform(0.2, 0.6) : 0.0;
    d.duct_hu = random.uniform(-70.0, -25.0);
    d.streaming_hu = mostly_small(random, 0.0, 0.2 * options.contrast_hu);
    d.noise_correlation_mm = random.uniform(0.4, 1.1);
    d.noise_sharpness = happens(random, 0.5) ? random.uniform(0.3, 1.0) : 0.0;
    d.streaks = happens(random, 0.3) ? whole(random, 5, 40) : 0;
    d.streak_hu = random.uniform(5.0, 30.0);
    // A slice is a mean over its thickness, which is the slice spacing or, with overlap, more.
    d.slice_spread_sigma_mm = options.spacing_mm[2] * random.uniform(0.2, 0.5);
    return d;
}

}  // namespace

PhantomOptions random_patient(std::uint64_t seed) {
    PhantomRandom random(scrambled(seed ^ 0x7061746965ULL));
    PhantomOptions options;
    options.seed = seed;
    draw_grid(random, options);
    draw_vessels(random, options);
    options.noise_hu = mostly_small(random, 5.0, 30.0);
    options.point_spread_sigma_mm = random.uniform(0.35, 0.9);
    options.disturbances = draw_disturbances(random, options);
    return options;
}

Mask sloppy_liver(const Mask& liver, std::uint64_t seed, Job& job) {
    PhantomRandom random(scrambled(seed ^ 0x6c69766572ULL));
    const double offset_mm = random.uniform(-2.0, 2.0);
    FloatVolume border = signed_distance(liver, job);
    const FloatVolume ripple = smooth_field(liver.grid, ripple_length_mm, scrambled(seed + 1), job);
    Mask drawn(liver.grid);
    for (std::size_t i = 0; i < drawn.voxels.size(); ++i)
        drawn.voxels[i] = border.voxels[i] + ripple_mm * ripple.voxels[i] < offset_mm ? 1 : 0;
    return drawn;
}

}  // namespace hepatica
