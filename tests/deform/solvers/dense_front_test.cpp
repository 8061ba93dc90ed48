// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of fronts against Eigen's dense Cholesky, in memory that ends where its header says:
// the address sanitizer sees what reaches beyond.
#include "core/deform/solvers/dense_front.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <limits>
#include <random>
#include <vector>

namespace hepatica {
namespace {

Eigen::MatrixXd positive_definite(int size, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd factor =
        Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
    return factor * factor.transpose() + size * Eigen::MatrixXd::Identity(size, size);
}

// The largest error of L and of the remainder, relative to the largest entry of the matrix.
template <class T>
double error_of_front(const Eigen::MatrixXd& matrix, int pivots) {
    const int rest = static_cast<int>(matrix.rows()) - pivots;
    const int stride = padded<T>(pivots + rest), rest_stride = padded<T>(rest);
    std::vector<T> panel(stride * pivots + front_alignment<T>, T(0));
    std::vector<T> remainder(rest_stride * rest + front_alignment<T>, T(0));
    for (int j = 0; j < matrix.cols(); ++j)
        for (int i = j; i < matrix.rows(); ++i)
            (j < pivots ? panel[j * stride + i]
                        : remainder[(j - pivots) * rest_stride + i - pivots]) =
                static_cast<T>(matrix(i, j));
    EXPECT_EQ(factor_front(panel.data(), remainder.data(), pivots, rest, {1e-14, true}), 0);

    const Eigen::MatrixXd head =
        matrix.topLeftCorner(pivots, pivots).llt().matrixL().toDenseMatrix();
    const Eigen::MatrixXd below =
        head.triangularView<Eigen::Lower>().solve(matrix.topRightCorner(pivots, rest)).transpose();
    const Eigen::MatrixXd left = matrix.bottomRightCorner(rest, rest) - below * below.transpose();
    double error = 0.0;
    const auto compare = [&](double is, double should) {
        error = std::max(error, std::abs(is - should));
    };
    for (int j = 0; j < pivots; ++j) {
        for (int i = j; i < pivots; ++i) compare(panel[j * stride + i], head(i, j));
        for (int i = 0; i < rest; ++i) compare(panel[j * stride + pivots + i], below(i, j));
    }
    for (int j = 0; j < rest; ++j)
        for (int i = j; i < rest; ++i) compare(remainder[j * rest_stride + i], left(i, j));
    return error / matrix.cwiseAbs().maxCoeff();
}

TEST(DenseFront, OfEverySizeIsTheCholeskyFactorAndItsSchurComplement) {
    std::mt19937_64 random(7);
    for (int pivots = 1; pivots <= 20; ++pivots) {
        for (int rest = 0; rest <= 20; ++rest) {
            const Eigen::MatrixXd matrix = positive_definite(pivots + rest, random);
            EXPECT_LE(error_of_front<double>(matrix, pivots), 1e-13) << pivots << " + " << rest;
            EXPECT_LE(error_of_front<float>(matrix, pivots), 1e-5) << pivots << " + " << rest;
        }
    }
}

// Three pivots, of which the second is negative, and one row that remains.
TEST(DenseFront, ADroppedPivotPassesNothingOn) {
    constexpr int stride = padded<double>(4);
    std::vector<double> panel(3 * stride + front_alignment<double>, 0.0);
    std::vector<double> remainder(padded<double>(1) + front_alignment<double>, 0.0);
    const double diagonal[] = {4.0, -1.0, 9.0}, row[] = {2.0, 5.0, 3.0};
    for (int j = 0; j < 3; ++j) {
        panel[j * stride + j] = diagonal[j];
        panel[j * stride + 3] = row[j];
    }
    remainder[0] = 10.0;
    EXPECT_EQ(factor_front(panel.data(), remainder.data(), 3, 1, {1e-14, true}), 1);
    EXPECT_EQ(panel[stride + 1], std::numeric_limits<double>::infinity());
    EXPECT_EQ(panel[stride + 3], 0.0);
    EXPECT_DOUBLE_EQ(remainder[0], 10.0 - 1.0 - 1.0);
}

TEST(DenseFront, SharedByThreadsIsThatOfOne) {
    std::mt19937_64 random(11);
    const Eigen::MatrixXd matrix = positive_definite(260, random);
    EXPECT_LE(error_of_front<double>(matrix, 203), 1e-12);
    EXPECT_LE(error_of_front<float>(matrix, 203), 1e-4);
}

}  // namespace
}  // namespace hepatica
