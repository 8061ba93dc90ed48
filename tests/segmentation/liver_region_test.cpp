// SPDX-License-Identifier: GPL-3.0-or-later
// The liver found in a body of ellipsoids, and livers with channels and cavities closed.
#include "core/segmentation/liver_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/segmentation/organ_surroundings.h"
#include "core/segmentation/soft_organ.h"
#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

bool in_ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& half_axes) {
    return (p - centre).cwiseQuotient(half_axes).norm() < 1.0;
}

struct Scan {
    Volume ct;
    Mask liver;
};

// Fat around three organs: a liver of 110 HU, a smaller spleen of 118 HU, a heart of 160 HU that
// touches the liver, and a spine.
Scan scan(double liver_scale = 1.0) {
    Grid grid;
    grid.dims = {110, 80, 60};
    grid.spacing_mm = Vec3(2.0, 2.0, 3.0);
    grid.origin_mm = Vec3(-110, -80, -90);
    Scan made{Volume(grid, -1000), Mask(grid)};
    std::mt19937_64 random(9);
    for (std::size_t i = 0; i < made.ct.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        if (!in_ellipsoid(p, Vec3::Zero(), Vec3(105, 76, 200))) continue;
        double hu = -100.0;
        if (in_ellipsoid(p, Vec3(-40, 0, 0), liver_scale * Vec3(50, 45, 50))) {
            hu = 110.0;
            made.liver.voxels[i] = 1;
        } else if (in_ellipsoid(p, Vec3(70, 25, 0), Vec3(22, 25, 35))) {
            hu = 118.0;
        } else if (in_ellipsoid(p, Vec3(15, -15, 62), Vec3(35, 30, 28))) {
            hu = 160.0;
        } else if (std::hypot(p.x(), p.y() - 55) < 14) {
            hu = 400.0;
        }
        made.ct.voxels[i] = static_cast<std::int16_t>(
            std::lround(hu + 30.0 * (test::uniform(random) + test::uniform(random) - 1.0)));
    }
    return made;
}

double dice(const Mask& a, const Mask& b) {
    double both = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < a.voxels.size(); ++i) {
        both += a.voxels[i] && b.voxels[i];
        sum += (a.voxels[i] != 0) + (b.voxels[i] != 0);
    }
    return 2.0 * both / sum;
}

TEST(FindLiver, IsTheLargestSoftOrganAndNotItsNeighbours) {
    const Scan body = scan();
    Job job;
    const Mask found = find_liver(body.ct, job).liver;
    EXPECT_TRUE(same_grid(found.grid, body.ct.grid));
    EXPECT_GT(dice(found, body.liver), 0.92);
    const auto at = [&](const Vec3& p) {
        const Vec3 index = body.ct.grid.to_index(p);
        return found.at(static_cast<int>(std::lround(index[0])),
                        static_cast<int>(std::lround(index[1])),
                        static_cast<int>(std::lround(index[2])));
    };
    EXPECT_EQ(at({-40, 0, 0}), 1);
    EXPECT_EQ(at({70, 25, 0}), 0);
    EXPECT_EQ(at({15, -15, 62}), 0);
    EXPECT_EQ(at({0, 55, 0}), 0);
}

// Where it stands in the scan, and how bright the contrast makes all of it, does not matter.
TEST(FindLiver, FollowsTheContrast) {
    Scan body = scan();
    for (std::int16_t& hu : body.ct.voxels)
        if (hu > 0 && hu < 300) hu = static_cast<std::int16_t>(hu - 40);
    Job job;
    EXPECT_GT(dice(find_liver(body.ct, job).liver, body.liver), 0.92);
}

// Without noise: a liver of 110 HU, a heart of 130 HU pressed against it, and beside them something
// larger than both that runs up and down through all intensities, 5 HU per mm along `axis` and 1.5
// along the others.
Scan scan_with_slopes(Eigen::Index axis) {
    Grid grid;
    grid.dims = {80, 64, 64};
    grid.spacing_mm = Vec3::Constant(3.0);
    Scan made{Volume(grid, -100), Mask(grid)};
    for (std::size_t i = 0; i < made.ct.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        double hu = -100.0;
        if (p.y() < 76.0 && (p - Vec3(48, 47, 95)).norm() < 36.0) {
            hu = 110.0;
            made.liver.voxels[i] = 1;
        } else if (p.y() >= 76.0 && (p - Vec3(48, 103, 95)).norm() < 30.0) {
            hu = 130.0;
        } else if (p.x() > 100.0) {
            const double along = std::fmod(0.7 * p[axis] + 0.3 * p.sum(), 112.0);
            hu = 5.0 * std::min(along, 112.0 - along);
        }
        made.ct.voxels[i] = static_cast<std::int16_t>(std::lround(hu));
    }
    return made;
}

// Borders between organs are slopes, whichever way they run: what is steep is no tissue. It would
// widen the band of the liver's intensities to that of its neighbour.
TEST(FindLiver, TakesNoSlopeForTissue) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Scan body = scan_with_slopes(axis);
        Job job;
        const Mask found = find_liver(body.ct, job).liver;
        EXPECT_GT(dice(found, body.liver), 0.85) << "axis " << axis;  // 0.78 with the heart
        EXPECT_EQ(found.at(16, 34, 32), 0) << "axis " << axis;        // in the heart
    }
}

// Balls of soft tissue in fat, without noise, 3 mm a voxel.
Volume soft_balls(const Vec3& vessel_mm, const std::vector<std::pair<Vec3, double>>& balls) {
    Grid grid;
    grid.dims = {84, 60, 60};
    grid.spacing_mm = Vec3::Constant(3.0);
    Volume ct(grid, -100);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        for (const auto& [centre, radius] : balls)
            if ((p - centre).norm() < radius) ct.voxels[i] = 110;
        if ((p - vessel_mm).norm() < 6.0) ct.voxels[i] = 220;  // a vessel
    }
    return ct;
}

// A spleen of the liver's own intensity, joined to it by more than the neck that growing stops at:
// only its place and the neck tell the two apart. The same behind the right lobe is liver.
TEST(FindLiver, PartsAnOrganLikeItThatTouchesItWidely) {
    const Vec3 liver(125, 80, 90);
    Job job;
    for (const double side : {1.0, -1.0}) {
        const Vec3 towards = Vec3(side, 0.5, -0.3).normalized();
        std::vector<std::pair<Vec3, double>> balls{{liver, 48.0}, {liver + 76.0 * towards, 28.0}};
        for (double along = 48.0; along < 76.0; along += 2.0)
            balls.emplace_back(liver + along * towards, 13.0);
        const FoundLiver found =
            find_liver(soft_balls(Vec3(liver + Vec3(-20, -10, 15)), balls), job);
        EXPECT_EQ(value_at(found.liver, liver), 1);
        EXPECT_EQ(value_at(found.liver, Vec3(liver + 80.0 * towards)), side > 0.0 ? 0 : 1);
        EXPECT_EQ(value_at(found.vessel_region, Vec3(liver + 80.0 * towards)), 1)
            << "vessels are looked for in all that touches the liver and looks like it";
    }
}

// The region is the whole organ, to the rim that smoothing took, with the vessels in it, and
// nothing that fat parts from it.
TEST(FindLiver, LooksForVesselsInAllThatTouchesIt) {
    const Vec3 liver(90, 90, 90), apart(185, 90, 90);
    Job job;
    const FoundLiver found = find_liver(soft_balls(liver, {{liver, 54.0}, {apart, 30.0}}), job);
    EXPECT_TRUE(same_grid(found.vessel_region.grid, found.liver.grid));
    EXPECT_EQ(value_at(found.vessel_region, liver), 1) << "a bright vessel";
    EXPECT_EQ(value_at(found.vessel_region, apart), 0);
    std::size_t voxels = 0;
    for (const std::uint8_t voxel : found.vessel_region.voxels) voxels += voxel;
    const auto ball_mm3 = [](double r) { return 4.0 / 3.0 * std::numbers::pi * r * r * r; };
    EXPECT_GT(27.0 * static_cast<double>(voxels), ball_mm3(54.0 - 3.0)) << "but for a voxel";
    EXPECT_LT(27.0 * static_cast<double>(voxels), ball_mm3(54.0 + 1.5));
}

// The largest soft organ of a head lies in bone, that of a chest in the lungs.
TEST(FindLiver, RefusesAHeadAndAChest) {
    Job job;
    const Vec3 middle(126, 90, 90);
    for (const auto& [around_hu, word] :
         {std::pair<std::int16_t, const char*>{700, "brain"}, {-800, "heart"}}) {
        Volume ct = soft_balls(middle, {{middle, 48.0}});
        for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
            const auto [x, y, z] = ct.grid.index_of(i);
            const double r = (ct.grid.to_mm(x, y, z) - middle).norm();
            if (r >= 48.0 && r < 66.0) ct.voxels[i] = around_hu;
        }
        try {
            find_liver(ct, job);
            ADD_FAILURE() << word;
        } catch (const NoLiverFound& error) {
            EXPECT_NE(error.problem().find(word), std::string::npos) << error.problem();
        }
    }
}

TEST(FindLiver, RefusesAScanWithoutOne) {
    Job job;
    Grid grid;
    grid.dims = {40, 40, 40};
    grid.spacing_mm = Vec3::Constant(3.0);
    EXPECT_THROW(find_liver(Volume(grid, -100), job), NoLiverFound);
    Volume small(grid, -100);  // an organ of 27 ml
    for (int z = 10; z < 20; ++z)
        for (int y = 10; y < 20; ++y)
            for (int x = 10; x < 20; ++x) small.at(x, y, z) = 100;
    EXPECT_THROW(find_liver(small, job), NoLiverFound);
    job.cancel();
    EXPECT_THROW(find_liver(scan().ct, job), Cancelled);
}

Mask ball_with(double channel_radius_mm) {
    return test::mask_where(test::cube_grid(60), [=](const Vec3& p) {
        const Vec3 q = p - Vec3::Constant(29.5);
        const bool channel = std::hypot(q.y(), q.z()) < channel_radius_mm;
        const bool cavity = (q - Vec3(0, 11, 0)).norm() < 4.0;
        return q.norm() < 20.0 && !channel && !cavity;
    });
}

TEST(CloseLiver, FillsChannelsAndCavitiesUpToTwiceItsRadius) {
    Job job;
    const Mask narrow = ball_with(3.0);
    const Mask closed = close_liver(narrow, 4.0, job);
    int added = 0;
    for (std::size_t i = 0; i < narrow.voxels.size(); ++i) {
        if (narrow.voxels[i]) {
            ASSERT_EQ(closed.voxels[i], 1);
        }
        added += closed.voxels[i] && !narrow.voxels[i];
        const auto [x, y, z] = narrow.grid.index_of(i);
        const double r = (Vec3(x, y, z) - Vec3::Constant(29.5)).norm();
        if (r < 16.0) {
            ASSERT_EQ(closed.voxels[i], 1) << x << " " << y << " " << z;
        }
        if (r >= 20.0) {
            ASSERT_EQ(closed.voxels[i], 0);
        }
    }
    EXPECT_GT(added, 500);
    // A wide channel stays open, an enclosed cavity is filled however small the radius.
    const Mask wide = close_liver(ball_with(6.0), 4.0, job);
    EXPECT_EQ(wide.at(29, 29, 29), 0);
    EXPECT_EQ(close_liver(ball_with(3.0), 1.0, job).at(29, 40, 29), 1);
    EXPECT_EQ(close_liver(ball_with(3.0), 1.0, job).at(29, 29, 29), 0);
}

// Three layers of 94, 100 and 106 HU under fat: in the histogram, whose bins are 2 HU wide,
// smoothed with exp(-k^2/8) over k bins, they are one peak in the bin from 100 to 102 HU. It falls
// to half its height between the fourth and the fifth bin: sum of exp(-(j - k)^2/8) over j = -3,
// 0, 3.
TEST(SoftOrgan, IsOnePeakOfTheSmoothedHistogram) {
    Grid grid;
    grid.dims = {20, 20, 27};
    grid.spacing_mm = Vec3::Constant(3.0);
    FloatVolume smooth(grid);
    for (std::size_t i = 0; i < smooth.voxels.size(); ++i) {
        const int z = grid.index_of(i)[2];
        smooth.voxels[i] = z < 2 ? -100.0f : z < 11 ? 94.0f : z < 19 ? 100.0f : 106.0f;
    }
    Job job;
    const SoftOrgan organ = largest_soft_organ(smooth, job);
    EXPECT_EQ(organ.hu, 101.0);
    EXPECT_NEAR(organ.half_band_hu, 2.2 * (5 * 2.0) / 1.177, 1e-9);
    EXPECT_GT(organ.core_ml, 0.0);
}

}  // namespace
}  // namespace hepatica
