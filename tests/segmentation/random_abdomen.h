// SPDX-License-Identifier: GPL-3.0-or-later
// A synthetic upper abdomen, randomised by a seed, to find the liver in: what lies around it
// touches it, with or without a film of fat, and has intensities that overlap with its own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/volume.h"

namespace hepatica::test {

// What the voxels of RandomAbdomen::organs hold.
enum class AbdomenOrgan : std::uint8_t {
    none,
    liver,  // vessels and tumours included
    spleen,
    heart,
    stomach,
    pancreas,  // and duodenum
    kidney,
    cava,
    wall,  // muscle of wall and diaphragm, bone
    bowel,
    count,
};
std::string name_of(AbdomenOrgan organ);

struct RandomAbdomenOptions {
    std::uint64_t seed = 1;
    Vec3 spacing_mm{1.5, 1.5, 2.0};
    // Extent along the body of a slab through the liver's middle; 0: all from below the liver to
    // the heart.
    double slab_mm = 0.0;
};

struct RandomAbdomen {
    Volume ct;
    Mask liver;   // 1 in the liver
    Mask organs;  // AbdomenOrgan of each voxel
    double parenchyma_hu = 0.0;
};

// The same options give the same voxels for any number of threads. Randomised are, each by itself:
// - shape: size, waves of the surface, length and thickness of the left lobe, which may reach the
//   spleen and bend round it; spleen, stomach, heart, kidneys, cava, pancreas by place and size;
// - the gap between the liver and each neighbour: -1 (they touch) to 3 mm of fat;
// - intensities: parenchyma 85 to 135 HU; spleen -8 to 25 HU from it, pancreas -28 to 3, heart's
//   muscle -15 to 20 and blood 15 to 60, cava -25 to 30, stomach's wall and content, muscle 45 to
//   68;
// - in the liver: vessels of 20 to 70 HU, 0 to 5 dark tumours of 5 to 38 mm in radius, a smooth
//   field of up to 10 HU; in three of ten bodies the streaks of arms: a back that is up to 28 HU
//   darker, through all organs;
// - noise of 8 to 22 HU a voxel, correlated in the plane, point spread 0.7 mm.
// The ranges are those of an adult's anatomy and of portal-venous scans in words of textbooks, and
// wider than what the real patients beside the checkout show.
RandomAbdomen random_abdomen(const RandomAbdomenOptions& options);

}  // namespace hepatica::test
