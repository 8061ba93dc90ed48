// SPDX-License-Identifier: GPL-3.0-or-later
// Products of a block matrix, against a dense one and against themselves.
#include "core/deform/solvers/block_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace hepatica {
namespace {

// Each row has its diagonal block and those of a few others, in both triangles.
BlockMatrix random_rows(int rows, std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    Eigen::MatrixXd used = Eigen::MatrixXd::Identity(rows, rows);
    for (int pair = 0; pair < 3 * rows; ++pair) {
        const auto i = static_cast<int>(random() % rows), j = static_cast<int>(random() % rows);
        used(i, j) = used(j, i) = 1.0;
    }
    BlockMatrix matrix;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < rows; ++j) {
            if (used(i, j) == 0.0) continue;
            if (i == j) matrix.diagonal.push_back(static_cast<int>(matrix.column.size()));
            matrix.column.push_back(j);
            matrix.block.emplace_back(Mat3::NullaryExpr([&] { return number(random); }));
        }
        matrix.row_begin.push_back(static_cast<int>(matrix.column.size()));
    }
    return matrix;
}

std::vector<Vec3> random_points(int count, std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::vector<Vec3> points(static_cast<std::size_t>(count));
    for (Vec3& point : points) point = Vec3::NullaryExpr([&] { return number(random); });
    return points;
}

// The dense product, row by row.
Vec3 row_times(const BlockMatrix& matrix, int i, const std::vector<Vec3>& x) {
    Vec3 sum = Vec3::Zero();
    for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k)
        sum += matrix.block[k] * x[matrix.column[k]];
    return sum;
}

TEST(BlockMatrixProduct, IsThatOfItsBlocks) {
    std::mt19937 random(1);
    for (const int rows : {1, 7, 300, 1000}) {
        const BlockMatrix matrix = random_rows(rows, random);
        const std::vector<Vec3> x = random_points(rows, random);
        std::vector<Vec3> y;
        multiply(matrix, x, y);
        ASSERT_EQ(y.size(), x.size());
        for (int i = 0; i < rows; ++i)
            EXPECT_LT((y[i] - row_times(matrix, i, x)).norm(), 1e-13) << i << " of " << rows;
    }
}

// To the last bit: what is left out are zeros.
TEST(BlockMatrixProduct, IsTheSameWhereRowsAreKnownToBeAlone) {
    std::mt19937 random(2);
    BlockMatrix matrix = random_rows(700, random);
    std::vector<std::uint8_t> alone(700);
    for (std::uint8_t& one : alone) one = random() % 3 == 0 ? 1 : 0;
    for (int i = 0; i < 700; ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k)
            if (matrix.column[k] != i && (alone[i] != 0 || alone[matrix.column[k]] != 0))
                matrix.block[k].setZero();
    const std::vector<Vec3> x = random_points(700, random);
    std::vector<Vec3> whole, passed_over;
    multiply(matrix, x, whole);
    matrix.alone = alone;
    multiply(matrix, x, passed_over);
    EXPECT_EQ(passed_over, whole);
    // Nothing of the others is read.
    for (int i = 0; i < 700; ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k)
            if (alone[i] != 0 && matrix.column[k] != i) matrix.block[k].setConstant(7.0);
    multiply(matrix, x, passed_over);
    EXPECT_EQ(passed_over, whole);
}

}  // namespace
}  // namespace hepatica
