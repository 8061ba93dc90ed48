// SPDX-License-Identifier: GPL-3.0-or-later
// The vectors and matrices of host and device against Eigen's, for random values of both signs.
#include "core/base/small_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "core/base/small_matrix_eigen.h"

namespace hepatica::small {
namespace {

constexpr double rounding = 1e-13;

class SmallMatrix : public testing::Test {
  protected:
    Vec3 vector() {
        return Vec3::NullaryExpr([&] { return number_(random_); });
    }
    Mat3 matrix() {
        return Mat3::NullaryExpr([&] { return number_(random_); });
    }
    static void expect_near(const Vector3<double>& ours, const Vec3& theirs) {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(ours[i], theirs[i], rounding);
    }
    static void expect_near(const Matrix3<double>& ours, const Mat3& theirs) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) EXPECT_NEAR(ours(i, j), theirs(i, j), rounding);
    }

  private:
    std::mt19937 random_{20261127};
    std::uniform_real_distribution<double> number_{-2.0, 2.0};
};

TEST_F(SmallMatrix, VectorsAreAsEigenHasThem) {
    for (int trial = 0; trial < 20; ++trial) {
        const Vec3 a = vector(), b = vector();
        const auto x = from_eigen(a), y = from_eigen(b);
        expect_near(x + y, a + b);
        expect_near(x - y, a - b);
        expect_near(1.7 * x, 1.7 * a);
        EXPECT_NEAR(dot(x, y), a.dot(b), rounding);
        expect_near(cross(x, y), a.cross(b));
        expect_near(outer(x, y), a * b.transpose());
        EXPECT_EQ(to_eigen(x), a);
    }
}

TEST_F(SmallMatrix, MatricesAreAsEigenHasThem) {
    expect_near(zero_matrix<double>(), Mat3::Zero());
    expect_near(identity_matrix<double>(), Mat3::Identity());
    for (int trial = 0; trial < 20; ++trial) {
        const Mat3 a = matrix(), b = matrix();
        const Vec3 c = vector();
        const auto x = from_eigen(a), y = from_eigen(b);
        const auto z = from_eigen(c);
        EXPECT_EQ(to_eigen(x), a);
        expect_near(x + y, a + b);
        expect_near(x - y, a - b);
        expect_near(1.7 * x, 1.7 * a);
        expect_near(x * y, a * b);
        expect_near(x * z, a * c);
        expect_near(transpose(x), a.transpose());
        expect_near(transposed_times(x, z), a.transpose() * c);
        expect_near(times_transposed(x, y), a * b.transpose());
        EXPECT_NEAR(trace(x), a.trace(), rounding);
        EXPECT_NEAR(inner(x, y), a.cwiseProduct(b).sum(), rounding);
    }
}

// The cofactors are det(A) A^-T, by an inverse that is computed in another way.
TEST_F(SmallMatrix, DeterminantAndCofactorsAreThoseOfALuFactor) {
    for (int trial = 0; trial < 20; ++trial) {
        const Mat3 a = matrix();
        const double volume = Eigen::PartialPivLU<Mat3>(a).determinant();
        EXPECT_NEAR(determinant(from_eigen(a)), volume, 1e-12);
        const Mat3 inverse = a.fullPivLu().inverse();
        if (std::abs(volume) < 0.1) continue;
        EXPECT_LT((to_eigen(cofactor(from_eigen(a))) - volume * inverse.transpose()).norm(), 1e-11);
    }
}

}  // namespace
}  // namespace hepatica::small
