// SPDX-License-Identifier: GPL-3.0-or-later
// Elements in lanes against the same elements one by one: not close, equal to the last bit.
#include "core/deform/elements/lanes.h"

#include <gtest/gtest.h>

#include <random>

#include "core/deform/elements/tetrahedron_element.h"

namespace hepatica::small {
namespace {

template <class T, int N>
void expect_same_rotations() {
    std::mt19937_64 random(7);
    const auto value = [&] { return static_cast<T>(random() >> 11) * T(0x1.0p-52) - T(1); };
    for (int trial = 0; trial < 500; ++trial) {
        Matrix3<T> single[N];
        Matrix3<Lanes<T, N>> wide;
        for (int lane = 0; lane < N; ++lane) {
            // Near a rotation, anything, inverted, flat, and zero.
            const T spread = trial % 3 == 0 ? T(0.05) : T(1);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) single[lane](i, j) = (i == j) + spread * value();
            if ((trial + lane) % 11 == 0)
                for (int j = 0; j < 3; ++j) single[lane](2, j) = single[lane](1, j);
            if ((trial + lane) % 13 == 0) single[lane] = T(-1) * single[lane];
            if ((trial + lane) % 17 == 0) single[lane] = zero_matrix<T>();
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) wide(i, j).set(lane, single[lane](i, j));
        }
        const Matrix3<Lanes<T, N>> together = nearest_rotation(wide);
        for (int lane = 0; lane < N; ++lane) {
            const Matrix3<T> alone = nearest_rotation(single[lane]);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) EXPECT_EQ(together(i, j)[lane], alone(i, j));
        }
    }
}

TEST(Lanes, RotationsAreThoseOfTheScalar) {
    expect_same_rotations<double, 4>();
    expect_same_rotations<float, 8>();
}

template <int Nodes>
void expect_same_elements() {
    using Wide = Lanes<double, 4>;
    std::mt19937_64 random(Nodes);
    const auto value = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0; };
    for (int trial = 0; trial < 50; ++trial) {
        TetrahedronRest<double> rest[4];
        TetrahedronRest<Wide> wide_rest;
        Vector3<double> x[4][Nodes];
        Vector3<Wide> wide_x[Nodes];
        for (int lane = 0; lane < 4; ++lane) {
            const Vector3<double> corner[4] = {
                {{0, 0, 0}}, {{1.2, 0.1, 0}}, {{0.2, 1, 0.1}}, {{0.1, 0.2, 1.0 + 0.1 * lane}}};
            rest[lane] = tetrahedron_rest(corner[0], corner[1], corner[2], corner[3], 900.0 + lane,
                                          400.0 - lane);
            for (int a = 0; a < Nodes; ++a) {
                int p = a, q = a;
                if (a >= 4) edge_corners(a - 4, p, q);
                for (int i = 0; i < 3; ++i) {
                    x[lane][a][i] =
                        0.5 * (corner[p][i] + corner[q][i]) + (a == 0 ? 0.0 : 0.5 * value());
                    wide_x[a][i].set(lane, x[lane][a][i]);
                }
            }
            for (int a = 0; a < 3; ++a)
                for (int i = 0; i < 3; ++i)
                    wide_rest.gradient[a][i].set(lane, rest[lane].gradient[a][i]);
            wide_rest.volume.set(lane, rest[lane].volume);
            wide_rest.lambda.set(lane, rest[lane].lambda);
            wide_rest.mu.set(lane, rest[lane].mu);
        }
        constexpr int pairs = pair_count<Nodes>;
        Vector3<Wide> wide_force[Nodes];
        Matrix3<Wide> wide_blocks[pairs];
        const Wide wide_energy = evaluate_tetrahedron<Nodes, Tangent::rotated, CorotatedLaw>(
            wide_rest, wide_x, wide_force, wide_blocks);
        for (int lane = 0; lane < 4; ++lane) {
            Vector3<double> force[Nodes];
            Matrix3<double> blocks[pairs];
            const double energy = evaluate_tetrahedron<Nodes, Tangent::rotated, CorotatedLaw>(
                rest[lane], x[lane], force, blocks);
            EXPECT_EQ(wide_energy[lane], energy);
            for (int a = 0; a < Nodes; ++a)
                for (int i = 0; i < 3; ++i) EXPECT_EQ(wide_force[a][i][lane], force[a][i]);
            for (int k = 0; k < pairs; ++k)
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j)
                        EXPECT_EQ(wide_blocks[k](i, j)[lane], blocks[k](i, j));
        }
    }
}

TEST(Lanes, LinearTetrahedraAreThoseOfTheScalar) {
    expect_same_elements<4>();
}

TEST(Lanes, QuadraticTetrahedraAreThoseOfTheScalar) {
    expect_same_elements<10>();
}

}  // namespace
}  // namespace hepatica::small
