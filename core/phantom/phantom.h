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
    // Each system has 2^generations ends, as a symmetric tree of that depth has; 1 to 10.
    int generations = 6;
    // 1: portal vein. 2: portal vein and hepatic veins, which do not touch.
    int systems = 1;
    // Places at which hepatic veins are bent until they touch portal ones (phantom_contacts.h);
    // 0 to 20, of two systems only.
    int touching = 0;
    bool touch_fewer = false;  // in as many as the seed allows, where that is fewer
    // The anatomy has the size of an adult's (liver 195 x 150 x 150 mm) where the field of view
    // can hold it, and is scaled down as a whole, vessels and all, where it cannot.
    Index3 dims{256, 256, 160};      // 16 to 2048 each
    Vec3 spacing_mm{0.8, 0.8, 1.0};  // 0.1 to 10 each
    double root_radius_mm = 6.0;     // of each system in an adult, before scaling down
    double murray_exponent = 3.0;    // r_parent^m = sum of r_child^m; 2 to 4
    double parenchyma_hu = 110.0;
    double contrast_hu = 65.0;  // vessel minus parenchyma; 0 for a scan without
                                // contrast medium, to 1000
    // Hepatic veins minus parenchyma, 0 to 1000; none: 0.85 of contrast_hu, as a little less has
    // reached them in the portal venous phase.
    std::optional<double> hepatic_contrast_hu;
    double noise_hu = 10.0;              // standard deviation, 0 to 500
    double point_spread_sigma_mm = 0.6;  // of the Gaussian that blurs the scan; 0 to 5
    Disturbances disturbances;           // none: a clean patient
};

struct Phantom {
    Volume ct;
    Mask vessels;     // voxels of which at least half is lumen: number of the system, else 0
    Mask liver;       // voxels of which at least half is liver, vessels included but for arteries,
                      // which may come in from outside of it
    VesselTree tree;  // centrelines and radii that the CT was drawn from; systems share no node
    std::vector<Vec3> contacts_mm;  // where the systems touch, as asked for
};

// The same options give the same bytes for any number of threads. Begins three stages of `job`.
// Throws InputError, naming the option, where one is outside its range or the systems cannot be
// made to touch in so many places; Cancelled.
Phantom make_phantom(const PhantomOptions& options, Job& job);

}  // namespace hepatica
