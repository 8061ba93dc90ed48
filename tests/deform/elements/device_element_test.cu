// SPDX-License-Identifier: GPL-3.0-or-later
// The element functions on a CUDA device against the same functions on the host.
#include <gtest/gtest.h>

#include <cmath>

#include "core/deform/elements/hexahedron_element.h"
#include "core/deform/elements/spring_element.h"
#include "core/deform/elements/tetrahedron_element.h"

namespace {

using namespace hepatica::small;

struct Result {
    double energy[7];
    Vector3<double> force[7][10];
    Matrix3<double> block[7][45];
};

// A bent tetrahedron of ten nodes; the linear elements use its corners, the hexahedron a brick.
HEPATICA_HOST_DEVICE void evaluate_all(Result& result) {
    const Vector3<double> rest[4] = {
        {{0, 0, 0}}, {{1.2, 0.1, 0}}, {{0.2, 1, 0.1}}, {{0.1, 0.2, 1.1}}};
    Vector3<double> x[10];
    for (int a = 0; a < 4; ++a) x[a] = rest[a];
    for (int edge = 0; edge < 6; ++edge) {
        int a = 0, b = 0;
        edge_corners(edge, a, b);
        x[4 + edge] = 0.5 * (rest[a] + rest[b]);
    }
    for (int a = 0; a < 10; ++a)
        for (int i = 0; i < 3; ++i) x[a][i] += 0.07 * ((7 * a + 3 * i) % 5 - 2);
    const auto shape = tetrahedron_rest(rest[0], rest[1], rest[2], rest[3], 900.0, 400.0);
    result.energy[0] = evaluate_tetrahedron<4, Tangent::rotated, CorotatedLaw>(
        shape, x, result.force[0], result.block[0]);
    result.energy[1] = evaluate_tetrahedron<10, Tangent::rotated, CorotatedLaw>(
        shape, x, result.force[1], result.block[1]);
    result.energy[2] = evaluate_tetrahedron<4, Tangent::projected, NeoHookeanLaw>(
        shape, x, result.force[2], result.block[2]);
    result.energy[3] = evaluate_tetrahedron<10, Tangent::projected, NeoHookeanLaw>(
        shape, x, result.force[3], result.block[3]);
    result.energy[4] =
        evaluate_springs(spring_rest(rest, 900.0, 400.0), x, result.force[4], result.block[4]);
    Vector3<double> brick[8];
    for (int a = 0; a < 8; ++a) {
        int s[3];
        hepatica::small::detail::hexahedron_corner(a, s);
        brick[a] = {{0.5 * s[0], 0.6 * s[1], 0.7 * s[2]}};
    }
    HexahedronRest<double> hexahedron;
    hexahedron_rest(brick, 900.0, 400.0, hexahedron);
    for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i) brick[a][i] += 0.05 * ((5 * a + 2 * i) % 7 - 3);
    result.energy[5] = evaluate_hexahedron(hexahedron, brick, result.force[5], result.block[5]);
    Vector3<double> turned[4];
    result.energy[6] = evaluate_turned_gradients(shape, x, result.force[6], turned);
    for (int a = 0; a < 4; ++a) result.block[6][a] = outer(turned[a], turned[a]);
}

__global__ void evaluate_on_device(Result* result) {
    evaluate_all(*result);
}

TEST(DeviceElements, GiveWhatTheHostGives) {
    int devices = 0;
    if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0)
        GTEST_SKIP() << "this machine has no CUDA device";
    Result* on_device = nullptr;
    ASSERT_EQ(cudaMallocManaged(&on_device, sizeof(Result)), cudaSuccess);
    *on_device = Result{};
    evaluate_on_device<<<1, 1>>>(on_device);
    ASSERT_EQ(cudaDeviceSynchronize(), cudaSuccess);
    static Result host{};
    evaluate_all(host);
    for (int k = 0; k < 7; ++k) {
        EXPECT_NEAR(on_device->energy[k], host.energy[k], 1e-11 * std::abs(host.energy[k]));
        for (int a = 0; a < 10; ++a)
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(on_device->force[k][a][i], host.force[k][a][i], 1e-8);
        for (int b = 0; b < 45; ++b)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    EXPECT_NEAR(on_device->block[k][b](i, j), host.block[k][b](i, j), 1e-7);
    }
    cudaFree(on_device);
}

}  // namespace
