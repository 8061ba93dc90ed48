// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/skeleton/thinning.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/skeleton/topology.h"
#include "tests/support/test_masks.h"

namespace hepatica {

using namespace test;

class Thinning : public testing::TestWithParam<ThinningMethod> {
  protected:
    Mask skeleton_of(const Mask& mask) {
        Job job;
        return thin(mask, GetParam(), job);
    }

    // Number of masks among `trials` whose topology thinning changed, or whose skeleton leaves the
    // mask.
    template <class MakeMask>
    int failures(int trials, const MakeMask& make) {
        std::vector<std::uint8_t> failed(trials, 0);
        parallel_blocks(trials, 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Mask mask = make(i);
                const Mask skeleton = skeleton_of(mask);
                bool inside = true;
                for (std::size_t v = 0; v < mask.voxels.size(); ++v)
                    inside = inside && (skeleton.voxels[v] == 0 || mask.voxels[v] != 0);
                failed[i] = !inside || betti_numbers(mask) != betti_numbers(skeleton);
            }
        });
        return static_cast<int>(std::ranges::count(failed, 1));
    }
};

INSTANTIATE_TEST_SUITE_P(Methods, Thinning,
                         testing::Values(ThinningMethod::queue, ThinningMethod::parallel),
                         [](const auto& instance) {
                             return instance.param == ThinningMethod::queue ? "Queue" : "Parallel";
                         });

TEST_P(Thinning, KeepsTheTopologyOfRandomVolumes) {
    // Half of them between 0.1 and 0.3, where most go wrong; the rest spread from 0.05 to 0.8.
    const int wrong = failures(40000, [](std::size_t i) {
        std::mt19937_64 random(i);
        const double share = uniform(random);
        const double density = i % 2 == 0 ? 0.1 + 0.2 * share : 0.05 + 0.75 * share;
        return bernoulli_mask(6, density, random);
    });
    EXPECT_EQ(wrong, 0);
}

TEST_P(Thinning, KeepsTheTopologyOfBlobs) {
    const int wrong = failures(1000, [](std::size_t i) {
        std::mt19937_64 random(i);
        return blob_mask(20, 0.1 + 0.5 * uniform(random), random);
    });
    EXPECT_EQ(wrong, 0);
}

TEST_P(Thinning, KeepsTheTopologyOfShapes) {
    const std::vector<Mask> shapes = {torus_mask(), hollow_cube_mask(), touching_tubes_mask()};
    EXPECT_EQ(failures(3, [&](std::size_t i) { return shapes[i]; }), 0);
}

// A published thinning loses bars of even width altogether.
TEST_P(Thinning, BarsOfAnyWidthBecomeALine) {
    for (int width = 1; width <= 7; ++width) {
        const Mask skeleton = skeleton_of(bar_mask(width, 60));
        EXPECT_EQ(betti_numbers(skeleton), (Betti{1, 0, 0})) << "width " << width;
        EXPECT_LE(count_object(skeleton), 72u) << "width " << width;
        EXPECT_GE(count_object(skeleton), 60u - width) << "width " << width;
    }
}

TEST_P(Thinning, TorusBecomesARing) {
    const std::size_t voxels = count_object(skeleton_of(torus_mask()));
    EXPECT_GE(voxels, 50u);
    EXPECT_LE(voxels, 75u);
}

TEST_P(Thinning, SkeletonOfATubeLiesOnItsAxis) {
    const Vec3 axis = Vec3(0.2, 0.35, 1.0).normalized();
    const Vec3 middle(16, 16, 24);
    Grid grid;
    grid.dims = {33, 33, 49};
    const Mask tube = mask_where(grid, [&](const Vec3& p) {
        const Vec3 q = p - middle;
        return std::abs(q.dot(axis)) < 20 && (q - q.dot(axis) * axis).norm() < 4.0;
    });
    const Mask skeleton = skeleton_of(tube);
    double sum = 0.0;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        if (skeleton.voxels[i] == 0) continue;
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 q = grid.to_mm(x, y, z) - middle;
        sum += (q - q.dot(axis) * axis).norm();
    }
    EXPECT_LT(sum / static_cast<double>(count_object(skeleton)), 0.8);
}

TEST_P(Thinning, NothingIsLeftOfNothing) {
    EXPECT_EQ(count_object(skeleton_of(Mask(cube_grid(4)))), 0u);
    EXPECT_EQ(count_object(skeleton_of(Mask(cube_grid(1), 1))), 1u);
}

TEST_P(Thinning, SameBytesForAnyNumberOfThreads) {
    std::mt19937_64 random(5);
    const Mask mask = blob_mask(40, 0.3, random);
    const Mask whole = skeleton_of(mask);
    const ThreadLimit one(1);
    EXPECT_EQ(skeleton_of(mask).voxels, whole.voxels);
}

TEST_P(Thinning, CanBeCancelled) {
    Job job;
    job.cancel();
    EXPECT_THROW(thin(torus_mask(), GetParam(), job), Cancelled);
}

}  // namespace hepatica
