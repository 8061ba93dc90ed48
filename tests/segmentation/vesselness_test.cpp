// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/vesselness.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"

namespace hepatica {
namespace {

Mat3 full(const Symmetric3& m) {
    Mat3 matrix;
    matrix << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
    return matrix;
}

void expect_eigenvalues(const Symmetric3& m) {
    const Vec3 exact = Eigen::SelfAdjointEigenSolver<Mat3>(full(m)).eigenvalues();
    const auto ours = eigenvalues(m);
    const double size = std::max(1e-30, exact.cwiseAbs().maxCoeff());
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(ours[static_cast<std::size_t>(k)], exact[k], 3e-4 * size) << full(m);
}

TEST(Eigenvalues, MeetEigensOnRandomMatricesOfAllSizes) {
    std::mt19937_64 engine(5);
    for (int n = 0; n < 20000; ++n) {
        const double size = std::pow(10.0, static_cast<double>(engine() % 13) - 6.0);
        Symmetric3 m;
        for (float& v : m)
            v = static_cast<float>(size * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0));
        expect_eigenvalues(m);
    }
}

TEST(Eigenvalues, MeetEigensWhereTheyCoincide) {
    for (const Symmetric3& m :
         {Symmetric3{0, 0, 0, 0, 0, 0}, Symmetric3{2, 2, 2, 0, 0, 0}, Symmetric3{1, 1, 3, 0, 0, 0},
          Symmetric3{-5, 1, 1, 0, 0, 0}, Symmetric3{1, 1, 1, 1, 1, 1},
          Symmetric3{1e-20f, 0, 0, 0, 0, 0}, Symmetric3{1e6f, 1e6f, 1e6f, 1e-3f, 0, 0}})
        expect_eigenvalues(m);
}

// A bright shape on cubes of 1 mm: value 60 where inside(p), softened by the resolution.
FloatVolume soft_shape(double (*signed_distance)(const Vec3&)) {
    Grid grid;
    grid.dims = {32, 32, 32};
    grid.origin_mm = Vec3::Constant(-15.5);
    FloatVolume volume(grid);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        const double d = signed_distance(grid.to_mm(at[0], at[1], at[2]));
        volume.voxels[i] = static_cast<float>(30.0 * (1.0 - std::tanh(d)));
    }
    return volume;
}

float at_centre(const FloatVolume& shape) {
    Job job;
    return vesselness(shape, {1.5, 2.5}, job).at(15, 15, 15);
}

TEST(Vesselness, AnswersToATubeMoreThanToABallOrASheet) {
    const float tube =
        at_centre(soft_shape([](const Vec3& p) { return std::hypot(p[0], p[1]) - 2.5; }));
    const float tilted = at_centre(soft_shape([](const Vec3& p) {
        const Vec3 axis = Vec3(1, 1, 1).normalized();
        return (p - p.dot(axis) * axis).norm() - 2.5;
    }));
    const float ball = at_centre(soft_shape([](const Vec3& p) { return p.norm() - 2.5; }));
    const float sheet = at_centre(soft_shape([](const Vec3& p) { return std::abs(p[0]) - 2.5; }));
    EXPECT_GT(tube, 10.0f);
    EXPECT_NEAR(tilted, tube, 0.15f * tube);
    EXPECT_LT(ball, 0.4f * tube);
    EXPECT_LT(sheet, 0.1f * tube);
}

// A grid of three different sides, cut out of the cube: its values are those of the cube.
TEST(Vesselness, DoesNotDependOnTheSidesOfTheGrid) {
    const FloatVolume cube = soft_shape([](const Vec3& p) {
        const Vec3 axis = Vec3(1, 2, 3).normalized();
        return (p - p.dot(axis) * axis).norm() - 2.5;
    });
    const IndexBox box{{2, 3, 0}, {32, 29, 28}};
    Job job;
    const FloatVolume whole = vesselness(cube, {1.5}, job);
    const FloatVolume part = vesselness(crop(cube, box), {1.5}, job);
    for (int z = 12; z < 20; ++z)
        for (int y = 12; y < 20; ++y)
            for (int x = 12; x < 20; ++x)
                EXPECT_NEAR(part.at(x - box.begin[0], y - box.begin[1], z - box.begin[2]),
                            whole.at(x, y, z), 0.05)
                    << x << " " << y << " " << z;
    EXPECT_GT(whole.at(15, 15, 15), 10.0f);
}

TEST(Vesselness, IsTheSameForAnyNumberOfThreads) {
    std::mt19937_64 engine(3);
    FloatVolume noise(soft_shape([](const Vec3& p) { return p.norm(); }).grid);
    for (float& v : noise.voxels) v = static_cast<float>(engine() % 100);
    Job job;
    FloatVolume one;
    {
        const ThreadLimit limit(1);
        one = vesselness(noise, {1.0, 2.0}, job);
    }
    EXPECT_EQ(one.voxels, vesselness(noise, {1.0, 2.0}, job).voxels);
}

TEST(Vesselness, RefusesVoxelsThatAreNotCubesAndScalesBelowTheVoxel) {
    FloatVolume flat = soft_shape([](const Vec3& p) { return p.norm(); });
    Job job;
    EXPECT_THROW(vesselness(flat, {0.2}, job), InputError);
    flat.grid.spacing_mm[2] = 2.0;
    EXPECT_THROW(vesselness(flat, {1.0}, job), InputError);
}

}  // namespace
}  // namespace hepatica
