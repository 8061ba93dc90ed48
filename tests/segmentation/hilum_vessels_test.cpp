// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/hilum_vessels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/image/morphology.h"

namespace hepatica {
namespace {

constexpr float tissue_hu = 110, vessel_hu = 170, fat_hu = -80;

struct Tube {
    Vec3 from_mm, to_mm;
    double radius_mm;
    float hu = vessel_hu;
};

bool in_tube(const Vec3& p, const Tube& tube) {
    const Vec3 along = tube.to_mm - tube.from_mm;
    const double share = std::clamp((p - tube.from_mm).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - tube.from_mm - share * along).norm() < tube.radius_mm;
}

// A liver of 100 x 80 x 70 mm with a fissure of 22 mm from in front (low y) and a groove of 16 mm
// behind, both full of fat. Vessels run where `tubes` say; those in the liver are known.
struct Anatomy {
    LiverFrame frame;
    Mask known, fissure;
};

bool in_fissure(const Vec3& p) {
    return std::abs(p.x() - 50) < 11 && p.y() < 52;
}
bool in_groove(const Vec3& p) {
    return std::abs(p.x() - 56) < 8 && p.y() > 58;
}

Anatomy liver_with(const std::vector<Tube>& tubes) {
    Grid grid;
    grid.dims = {112, 92, 82};
    grid.origin_mm = Vec3::Constant(-6.0);
    Anatomy made{{FloatVolume(grid), Mask(grid)}, Mask(grid), Mask(grid)};
    std::mt19937 random(7);
    std::normal_distribution<float> noise(0.0F, 8.0F);
    for (std::size_t i = 0; i < made.known.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        const bool box = (p.array() >= 0).all() && (Vec3(100, 80, 70) - p).minCoeff() >= 0;
        const bool liver = box && !in_fissure(p) && !in_groove(p);
        float hu = liver ? tissue_hu : fat_hu;
        for (const Tube& tube : tubes)
            if (in_tube(p, tube)) {
                hu = tube.hu;
                made.known.voxels[i] = liver;
            }
        made.frame.intensity.voxels[i] = hu + noise(random);
        made.frame.liver.voxels[i] = liver;
        made.fissure.voxels[i] = box && in_fissure(p);
    }
    return made;
}

const Hilum hilum{.at_mm = Vec3(50, 40, 33),
                  .confluence_mm = Vec3(56, 64, 60),
                  .parenchyma_hu = tissue_hu,
                  .vessel_hu = vessel_hu};
// From the right lobe through the fissure into the left one, and the trunk that joins it there.
const Tube branches{Vec3(20, 40, 33), Vec3(80, 40, 33), 4.0};
const Tube trunk{Vec3(50, 40, 33), Vec3(50, -6, 20), 5.5};

double share_found(const Mask& found, const Anatomy& made, const Tube& tube) {
    double in = 0, all = 0;
    for (std::size_t i = 0; i < found.voxels.size(); ++i) {
        const auto [x, y, z] = found.grid.index_of(i);
        const Vec3 p = found.grid.to_mm(x, y, z);
        if (made.fissure.voxels[i] == 0 || !in_tube(p, tube) || (p - hilum.at_mm).norm() > 20)
            continue;
        ++all;
        in += found.voxels[i];
    }
    return in / all;
}

std::size_t count(const Mask& mask) {
    return mask.voxels.size() - std::ranges::count(mask.voxels, 0);
}

TEST(HilumVessels, JoinsLeftAndRightThroughTheFissureAndFindsTheTrunk) {
    const Anatomy made = liver_with({branches, trunk});
    ASSERT_EQ(connected_components(made.known, Connectivity::all26).sizes.size(), 2u);
    Job job;
    const HilumVessels found = hilum_vessels(made.frame, made.known, hilum, job);
    // Walls lie in fat: up to 0.75 mm are missing all around.
    EXPECT_GT(share_found(found.vessels, made, branches), std::pow(1 - 0.75 / 4.0, 2));
    EXPECT_GT(share_found(found.vessels, made, trunk), std::pow(1 - 0.75 / 4.0, 2));
    Mask all = made.known;
    std::size_t beside = 0;
    for (std::size_t i = 0; i < all.voxels.size(); ++i) {
        const auto [x, y, z] = all.grid.index_of(i);
        const Vec3 p = all.grid.to_mm(x, y, z);
        EXPECT_FALSE(found.vessels.voxels[i] != 0 && made.frame.liver.voxels[i] != 0);
        beside += found.vessels.voxels[i] != 0 &&
                  !in_tube(p, {branches.from_mm, branches.to_mm, 5}) &&
                  !in_tube(p, {trunk.from_mm, trunk.to_mm, 6.5});
        all.voxels[i] |= found.vessels.voxels[i];
    }
    EXPECT_EQ(beside, 0u);
    EXPECT_EQ(connected_components(all, Connectivity::all26).sizes.size(), 1u);
    // 30 mm from the hilum along the trunk.
    const Vec3 expected = trunk.from_mm + 30.0 * (trunk.to_mm - trunk.from_mm).normalized();
    ASSERT_TRUE(found.trunk_mm);
    EXPECT_LT((*found.trunk_mm - expected).norm(), 2.0);
}

// It is as bright, and joined with hepatic veins that are as wide.
TEST(HilumVessels, LeavesOutTheVenaCava) {
    const Tube cava{Vec3(56, 64, -6), Vec3(56, 64, 60), 6.0};
    const Tube vein{Vec3(56, 64, 60), Vec3(36, 54, 55), 4.0};
    const Anatomy made = liver_with({cava, vein});
    Job job;
    const HilumVessels found = hilum_vessels(made.frame, made.known, hilum, job);
    EXPECT_EQ(count(found.vessels), 0u);
    EXPECT_FALSE(found.trunk_mm);
}

TEST(HilumVessels, LeavesOutWhatIsNoWideVesselOfTheLiver) {
    const Tube thin{branches.from_mm, branches.to_mm, 1.45, 225};                 // an artery
    const Tube bone{Vec3(20, 40, 33), Vec3(80, 40, 33), 4.0, 400};                // too bright
    const Tube apart{Vec3(50, 20, 20), Vec3(50, 40, 50), 4.0};                    // a bowel
    const Tube bile{Vec3(20, 40, 33), Vec3(80, 40, 33), 4.0, tissue_hu + 15.0F};  // too dark
    for (const Tube& tube : {thin, bone, apart, bile}) {
        const Anatomy made = liver_with({tube});
        Job job;
        const HilumVessels found = hilum_vessels(made.frame, made.known, hilum, job);
        EXPECT_LT(share_found(found.vessels, made, tube), 0.1)
            << tube.radius_mm << " mm, " << tube.hu << " HU";
        EXPECT_FALSE(found.trunk_mm);
    }
}

}  // namespace
}  // namespace hepatica
