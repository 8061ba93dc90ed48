// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest rotation against Eigen's singular value decomposition, over random and broken input.
#include "core/deform/elements/polar_decomposition.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/base/small_matrix_eigen.h"

namespace hepatica {
namespace {

Mat3 random_matrix(std::mt19937_64& random) {
    Mat3 a;
    for (int i = 0; i < 9; ++i) a(i) = static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;
    return a;
}

double best_trace(const Mat3& f) {
    const Eigen::JacobiSVD<Mat3> svd(f);
    const double sign = f.determinant() < 0.0 ? -1.0 : 1.0;
    return svd.singularValues()[0] + svd.singularValues()[1] + sign * svd.singularValues()[2];
}

TEST(NearestRotation, MaximisesTheTraceForRandomMatricesOfAnySize) {
    std::mt19937_64 random(7);
    for (int trial = 0; trial < 20000; ++trial) {
        const double scale = std::pow(10.0, static_cast<double>(trial % 13) - 6.0);
        Mat3 f = scale * random_matrix(random);
        if (trial % 3 == 0) f.col(1) = 1e-9 * f.col(1) + 2.0 * f.col(0);  // nearly flat
        if (trial % 5 == 0) f = scale * (Mat3::Identity() + 0.1 * f / scale);
        const Mat3 r = small::to_eigen(small::nearest_rotation(small::from_eigen(f)));
        EXPECT_NEAR(r.determinant(), 1.0, 1e-12);
        EXPECT_LT((r * r.transpose() - Mat3::Identity()).norm(), 1e-12);
        EXPECT_NEAR((r.transpose() * f).trace() / scale, best_trace(f) / scale, 1e-10);
    }
}

TEST(NearestRotation, IsARotationForFlatLineAndPoint) {
    for (const Vec3& d : {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(-1, -1, -1),
                          Vec3(1, 1, -1), Vec3(1e-300, 1, 1), Vec3(1e200, 1, 1e-200)}) {
        const Mat3 f = d.asDiagonal();
        const Mat3 r = small::to_eigen(small::nearest_rotation(small::from_eigen(f)));
        EXPECT_NEAR(r.determinant(), 1.0, 1e-12);
        EXPECT_LT((r * r.transpose() - Mat3::Identity()).norm(), 1e-12);
    }
}

TEST(SignedSvd, RebuildsTheMatrixFromRotations) {
    std::mt19937_64 random(11);
    for (int trial = 0; trial < 20000; ++trial) {
        Mat3 f = random_matrix(random);
        if (trial % 4 == 0) f.row(2) = f.row(0);
        if (trial % 7 == 0) f *= 1e-8;
        const auto svd = small::signed_svd(small::from_eigen(f));
        const Mat3 u = small::to_eigen(svd.u), v = small::to_eigen(svd.v);
        const Vec3 sigma = small::to_eigen(svd.sigma);
        EXPECT_NEAR(u.determinant(), 1.0, 1e-12);
        EXPECT_NEAR(v.determinant(), 1.0, 1e-12);
        EXPECT_LT((u * sigma.asDiagonal() * v.transpose() - f).norm(), 1e-12 * f.norm());
        EXPECT_GE(sigma[0], sigma[1]);
        EXPECT_GE(sigma[1], std::abs(sigma[2]) - 1e-12 * sigma[0]);
    }
}

TEST(NearestRotation, HoldsInSinglePrecision) {
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 5000; ++trial) {
        const Mat3 f = random_matrix(random);
        small::Matrix3<float> a;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) a(i, j) = static_cast<float>(f(i, j));
        const auto r = small::nearest_rotation(a);
        EXPECT_NEAR(small::determinant(r), 1.0f, 1e-5f);
        EXPECT_NEAR(small::inner(r, a), best_trace(f), 1e-5);
    }
}

}  // namespace
}  // namespace hepatica
