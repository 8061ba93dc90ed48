// SPDX-License-Identifier: GPL-3.0-or-later
// A synthetic patient with ground truth: vessel trees grown in a liver by constrained constructive
// optimisation (Schreiner and Buxbaum 1993; Karch et al. 1999 in three dimensions) under Murray's
// law, then imaged as a portal-venous CT with partial volume, point spread and noise.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/phantom/disturbances.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct PhantomOptions {
    std::uint64_t seed = 1;
    // Each system has 2^generations ends, like a symmetric tree of that depth; 1 to 10.
    int generations = 6;
    // 1: portal vein. 2: portal vein and hepatic veins, which do not touch unless `touching` is
    // set.
    int systems = 1;
    // Places at which hepatic veins are bent to touch portal ones (phantom_contacts.h): 0 to 20,
    // with two systems only.
    int touching = 0;
    bool touch_fewer = false;  // accept fewer places where the seed allows no more
    // The anatomy has the size of an adult's (liver 195 x 150 x 150 mm) where it fits into the
    // field of view; otherwise everything, vessels included, is scaled down.
    Index3 dims{256, 256, 160};      // 16 to 2048 each
    Vec3 spacing_mm{0.8, 0.8, 1.0};  // 0.1 to 10 each
    double root_radius_mm = 6.0;     // of each system in an adult, before scaling; 1 to 12
    double murray_exponent = 3.0;    // r_parent^m = sum of r_child^m; 2 to 4
    // Intensity of the liver's tissue, -100 to 300.
    double parenchyma_hu = 110.0;
    double contrast_hu = 65.0;  // vessel minus parenchyma, 0 (no contrast medium) to 1000
    // Hepatic veins minus parenchyma, 0 to 1000; none: 0.85 of contrast_hu, because less contrast
    // medium has reached them in the portal venous phase.
    std::optional<double> hepatic_contrast_hu;
    double noise_hu = 10.0;              // standard deviation, 0 to 500
    double point_spread_sigma_mm = 0.6;  // of the Gaussian that blurs the scan; 0 to 5
    Disturbances disturbances;           // none: a clean patient
};

struct Phantom {
    Volume ct;
    Mask vessels;     // number of the system where at least half of the voxel is lumen, else 0
    Mask liver;       // 1 where the voxel's centre lies in the liver or the voxel is a vessel;
                      // arteries, which may enter from outside, do not count
    VesselTree tree;  // centrelines and radii that the CT was drawn from, without bile ducts;
                      // systems share no node
    std::vector<Vec3> contacts_mm;  // where the systems touch, as requested
};

// Makes the phantom. The same options give the same bytes for any number of threads. Begins three
// stages of `job`. Throws InputError, naming the option, where one is out of range or the systems
// cannot touch in so many places; Cancelled.
Phantom make_phantom(const PhantomOptions& options, Job& job);

}  // namespace hepatica
