// SPDX-License-Identifier: GPL-3.0-or-later
// Products of the device's matrix with a vector against the same sums in a dense matrix: rows of
// any length, empty ones and one that fills no block of threads, nodes that are held.
#include "gpu/kernels/product_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "gpu/step/row_chunks.h"
#include "gpu/step/whole_sum.h"
#include "tests/gpu/support/gpu_bodies.h"

namespace hepatica {
namespace {

using small::Matrix3;
using small::Vector3;

class RandomSystem {
  public:
    RandomSystem(gpu::Machine& machine, int nodes)
        : nodes_(nodes), p_(nodes), b_(nodes), dense_(dense_zero(nodes)), sums_(machine) {
        std::vector<int> row_begin{0}, column;
        std::vector<Matrix3<double>> block;
        std::vector<double> mass, tether;
        std::vector<unsigned char> held;
        for (int i = 0; i < nodes; ++i) {
            held.push_back(random_() % 5 == 0 ? 1 : 0);
            mass.push_back(number());
            tether.push_back(number());
            for (int c = 0; c < 3; ++c) {
                p_[i][c] = held[i] != 0 ? 0.0 : number();
                b_[i][c] = number();
            }
            for (int k = entries_of(i); k > 0; --k) {
                column.push_back(static_cast<int>(random_() % static_cast<unsigned>(nodes)));
                Matrix3<double> one;
                for (int r = 0; r < 9; ++r) one(r / 3, r % 3) = number();
                block.push_back(one);
            }
            row_begin.push_back(static_cast<int>(column.size()));
            fill_row(i, row_begin, column, block,
                     factors.mass * mass[i] + factors.tether * tether[i], held[i] != 0);
        }
        const gpu::RowChunks chunks = gpu::chunks_of(row_begin);
        row_begin_ = {machine, row_begin};
        column_ = {machine, column};
        chunk_begin_ = {machine, chunks.begin};
        chunk_entry_ = {machine, chunks.entry};
        row_of_ = {machine, chunks.row_of};
        block_ = {machine, gpu::in_planes<double>(block)};
        mass_ = {machine, mass};
        tether_ = {machine, tether};
        held_ = {machine, held};
        device_p_ = {machine, p_};
        device_b_ = {machine, b_};
        y_ = {machine, p_.size()};
        sums_.resize(p_.size(), static_cast<int>(chunks.begin.size()) - 1);
    }

    // y = A p on the machine; returns p . y.
    double multiply() {
        return sums_.read_rows(view(), device_p_.read(), gpu::KeepProduct<double>{y_.view()})[0];
    }
    // The same from vectors of four numbers; returns work / (p . y).
    double step_from_quads(gpu::Machine& machine, double work) {
        std::vector<gpu::Quad<double>> quads;
        for (const Vector3<double>& p : p_) quads.push_back(gpu::quad_of(p));
        const gpu::Array<gpu::Quad<double>> device(machine, quads);
        const gpu::Array<gpu::SolveScalars> scalars(
            machine, std::vector<gpu::SolveScalars>{{0.0, 0.0, work, 0.0, 0, 0}});
        sums_.rows(view(), device.read(), gpu::KeepProduct<double>{y_.view()},
                   gpu::ChooseStep{scalars.view()});
        gpu::SolveScalars now;
        scalars.download({&now, 1});
        return now.step;
    }
    // y = b - A p; returns y . y.
    double residual() {
        return sums_.read_rows(view(), device_p_.read(),
                               gpu::KeepResidual{device_b_.read(), y_.view()})[0];
    }
    Eigen::VectorXd y() const {
        std::vector<Vector3<double>> values(p_.size());
        y_.download(values);
        return stacked(values);
    }
    Eigen::VectorXd p() const { return stacked(p_); }
    Eigen::VectorXd b() const { return stacked(b_); }
    const Eigen::MatrixXd& dense() const { return dense_; }

  private:
    static constexpr gpu::SystemFactors factors{.mass = 1.7, .tether = 0.3, .stiffness = 2.5};

    static Eigen::MatrixXd dense_zero(int nodes) {
        return Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
    }
    static Eigen::VectorXd stacked(const std::vector<Vector3<double>>& vectors) {
        Eigen::VectorXd all(3 * static_cast<Eigen::Index>(vectors.size()));
        for (std::size_t i = 0; i < vectors.size(); ++i)
            for (int c = 0; c < 3; ++c) all[3 * static_cast<Eigen::Index>(i) + c] = vectors[i][c];
        return all;
    }
    double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
    // One row is longer than a chunk, some are empty.
    int entries_of(int i) {
        if (i == nodes_ / 2) return gpu::RowChunksView::most_entries + 77;
        return static_cast<int>(random_() % 30u);
    }
    // A_ij (p_j - p_i) for each entry, and what stands on the diagonal; nothing where it is held.
    void fill_row(int i, const std::vector<int>& row_begin, const std::vector<int>& column,
                  const std::vector<Matrix3<double>>& block, double diagonal, bool held) {
        if (held) return;
        for (int k = row_begin[i]; k < row_begin[i + 1]; ++k) {
            Eigen::Matrix3d one;
            for (int r = 0; r < 9; ++r)
                one(r / 3, r % 3) = factors.stiffness * block[k](r / 3, r % 3);
            dense_.block<3, 3>(3 * i, 3 * column[k]) += one;
            dense_.block<3, 3>(3 * i, 3 * i) -= one;
        }
        dense_.block<3, 3>(3 * i, 3 * i) += diagonal * Eigen::Matrix3d::Identity();
    }
    gpu::SystemView<double> view() const {
        return {row_begin_.read(),
                column_.read(),
                {chunk_begin_.read(), chunk_entry_.read(), row_of_.read()},
                gpu::MatrixPlanes<double>(block_.read()),
                mass_.read(),
                tether_.read(),
                held_.read(),
                {},
                {},
                factors};
    }

    std::mt19937 random_{20261127};
    int nodes_;
    std::vector<Vector3<double>> p_, b_;
    Eigen::MatrixXd dense_;
    gpu::WholeSum sums_;
    gpu::Array<int> row_begin_, column_, chunk_begin_, chunk_entry_;
    gpu::Array<unsigned char> row_of_, held_;
    gpu::Array<double> block_, mass_, tether_;
    gpu::Array<Vector3<double>> device_p_, device_b_, y_;
};

void expect_products(gpu::Machine& machine, int nodes) {
    RandomSystem system(machine, nodes);
    const Eigen::VectorXd product = system.dense() * system.p();
    const double size = 1e-13 * (1.0 + product.norm()) * static_cast<double>(product.size());

    const double work = system.multiply();
    EXPECT_LT((system.y() - product).norm(), size);
    EXPECT_NEAR(work, system.p().dot(product), size * system.p().norm());

    // Conjugate gradients break down where p . A p is not positive: of both signs one is.
    const double step = system.step_from_quads(machine, 3.0);
    EXPECT_LT((system.y() - product).norm(), size);
    if (work > 0.0) {
        EXPECT_NEAR(step, 3.0 / work, 1e-12 * std::abs(3.0 / work));
    } else {
        EXPECT_EQ(step, 0.0);
    }

    const Eigen::VectorXd residual = system.b() - product;
    const double squared = system.residual();
    EXPECT_LT((system.y() - residual).norm(), size);
    EXPECT_NEAR(squared, residual.squaredNorm(), size * residual.norm());
}

class Products : public testing::TestWithParam<int> {};

TEST_P(Products, AreThoseOfADenseMatrix) {
    for (const gpu::BlockOrder order :
         {gpu::BlockOrder::ascending, gpu::BlockOrder::descending, gpu::BlockOrder::shuffled})
        expect_products(*gpu::make_emulator(order), GetParam());
}

TEST_P(Products, AreThoseOfADenseMatrixOnADevice) {
    const auto machine = test::machine_of("device");
    if (!machine) GTEST_SKIP() << test::no_device_because();
    expect_products(*machine, GetParam());
}

INSTANTIATE_TEST_SUITE_P(OfNodes, Products, testing::Values(1, 7, 65, 700));

}  // namespace
}  // namespace hepatica
