// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/line_coherence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"

namespace hepatica {
namespace {

constexpr int size = 33, middle = 16;

// Voxels of 0.7 mm: a half-line of 3.5 mm is five of them.
Grid line_grid() {
    Grid grid;
    grid.dims = {size, size, size};
    grid.spacing_mm = Vec3::Constant(0.7);
    return grid;
}

// 1 where `inside`, of the place in voxels from the middle.
FloatVolume shape(const std::function<bool(const Vec3&)>& inside) {
    FloatVolume volume(line_grid());
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        const auto [x, y, z] = volume.grid.index_of(i);
        volume.voxels[i] = inside(Vec3(x - middle, y - middle, z - middle)) ? 1.0f : 0.0f;
    }
    return volume;
}

float at_middle(const FloatVolume& values, const LineOptions& options = {}) {
    Job job;
    return line_coherence(values, Mask(line_grid(), 1), options, job).at(middle, middle, middle);
}

TEST(LineCoherence, IsTheMeanAlongATubeInAnyDirection) {
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 0),
                                  Vec3(1, -2, 1), Vec3(-1, 1, 3)}) {
        const Vec3 axis = direction.normalized();
        const float tube =
            at_middle(shape([&](const Vec3& p) { return (p - p.dot(axis) * axis).norm() < 1.8; }));
        EXPECT_GE(tube, 1.0f - 1e-5f) << direction.transpose();
        EXPECT_LE(tube, 1.0f + 1e-5f);
    }
}

// Of eleven voxels in a row an isolated ball holds five.
TEST(LineCoherence, IsLessAtABallAndAtTheEndOfATube) {
    const float ball = at_middle(shape([](const Vec3& p) { return p.norm() < 2.3; }));
    EXPECT_NEAR(ball, 5.0 / 11.0, 1e-5);
    const float end = at_middle(
        shape([](const Vec3& p) { return p.x() >= 0.0 && std::hypot(p.y(), p.z()) < 1.8; }));
    EXPECT_GE(end, 6.0f / 11.0f - 1e-5f);
    EXPECT_LE(end, 8.0f / 11.0f);  // what the other half meets going back beside the tube's end
}

TEST(LineCoherence, FollowsABendButNoCorner) {
    const auto bent_by = [](double degrees) {
        const double turn = degrees * M_PI / 180.0;
        const Vec3 onwards(std::cos(turn), std::sin(turn), 0.0);
        return shape([onwards](const Vec3& p) {
            const auto beside = [&](const Vec3& axis) {
                return p.dot(axis) >= -1.0 && (p - p.dot(axis) * axis).norm() < 1.6;
            };
            return beside(Vec3(-1, 0, 0)) || beside(onwards);
        });
    };
    EXPECT_GT(at_middle(bent_by(25.0)), 0.99f);
    const float corner = at_middle(bent_by(100.0));
    EXPECT_LT(corner, 0.85f);
    LineOptions any;
    any.max_bend_deg = 110.0;
    EXPECT_GT(at_middle(bent_by(100.0), any), 0.99f);
}

TEST(LineCoherence, ReachesAsFarAsAsked) {
    const FloatVolume rod = shape(
        [](const Vec3& p) { return std::abs(p.x()) <= 5.0 && std::hypot(p.y(), p.z()) < 1.8; });
    EXPECT_NEAR(at_middle(rod), 1.0, 1e-5);
    LineOptions longer;
    longer.half_length_mm = 7.0;  // ten voxels either way, of which five lie in the rod
    EXPECT_NEAR(at_middle(rod, longer), 11.0 / 21.0, 1e-5);
    LineOptions shortest;
    shortest.half_length_mm = 0.1;  // one voxel at least
    EXPECT_NEAR(at_middle(shape([](const Vec3& p) { return p.norm() < 0.5; }), shortest), 1.0 / 3.0,
                1e-5);
}

TEST(LineCoherence, ContinuesTheBorderAndKeepsToTheCandidates) {
    const FloatVolume one(line_grid(), 2.5f);
    Mask some(line_grid());
    for (const int c : {0, 3, 4, 5, middle, size - 6, size - 5, size - 1})
        some.at(c, size - 1 - c, c) = 1;
    Job job;
    const FloatVolume lines = line_coherence(one, some, {}, job);
    for (std::size_t i = 0; i < some.voxels.size(); ++i)
        ASSERT_NEAR(lines.voxels[i], some.voxels[i] ? 2.5 : 0.0, 1e-5);
}

// What a line sees does not depend on whether the border is near.
TEST(LineCoherence, SeesTheSameNearTheBorderAsFarFromIt) {
    const auto rods = [](int extra) {
        Grid grid = line_grid();
        grid.dims = {size + 2 * extra, 14 + 2 * extra, 14 + 2 * extra};
        FloatVolume volume(grid);
        for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
            const auto [x, y, z] = grid.index_of(i);
            volume.voxels[i] = static_cast<float>(std::clamp(x - extra, 0, size - 1) % 3 +
                                                  4 * (std::clamp(y - extra, 0, 13) % 4) *
                                                      (std::clamp(z - extra, 0, 13) % 3));
        }
        Job job;
        return line_coherence(volume, Mask(grid, 1), {}, job);
    };
    const FloatVolume tight = rods(0), wide = rods(6);
    for (int z = 0; z < 14; ++z)
        for (int y = 0; y < 14; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_FLOAT_EQ(tight.at(x, y, z), wide.at(x + 6, y + 6, z + 6));
}

TEST(LineCoherence, StopsWhenCancelled) {
    Job job;
    job.cancel();
    EXPECT_THROW(line_coherence(FloatVolume(line_grid()), Mask(line_grid(), 1), {}, job),
                 Cancelled);
}

}  // namespace
}  // namespace hepatica
