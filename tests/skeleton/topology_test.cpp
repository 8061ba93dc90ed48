// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/skeleton/topology.h"

#include <gtest/gtest.h>

#include "tests/support/test_masks.h"

namespace hepatica {

using namespace test;

void PrintTo(const Betti& b, std::ostream* out) {
    *out << b.components << " components, " << b.tunnels << " tunnels, " << b.cavities
         << " cavities";
}

TEST(Topology, EmptyMaskHasNothing) {
    EXPECT_EQ(betti_numbers(Mask(cube_grid(5))), (Betti{0, 0, 0}));
    EXPECT_EQ(betti_numbers(Mask{}), (Betti{0, 0, 0}));
}

TEST(Topology, FullGridIsOneBall) {
    EXPECT_EQ(betti_numbers(Mask(cube_grid(4), 7)), (Betti{1, 0, 0}));
}

TEST(Topology, TorusAndHollowCube) {
    EXPECT_EQ(betti_numbers(torus_mask()), (Betti{1, 1, 0}));
    EXPECT_EQ(betti_numbers(hollow_cube_mask()), (Betti{1, 0, 1}));
}

TEST(Topology, VoxelsThatTouchAtACornerAreOneComponent) {
    Mask mask(cube_grid(4));
    mask.at(0, 0, 0) = mask.at(1, 1, 1) = 1;
    EXPECT_EQ(betti_numbers(mask), (Betti{1, 0, 0}));
    mask.at(3, 3, 3) = 1;
    EXPECT_EQ(betti_numbers(mask), (Betti{2, 0, 0}));
}

TEST(Topology, RingOfDiagonalVoxelsHasATunnel) {
    Mask mask(cube_grid(3));
    mask.at(1, 0, 1) = mask.at(0, 1, 1) = mask.at(2, 1, 1) = mask.at(1, 2, 1) = 1;
    EXPECT_EQ(betti_numbers(mask), (Betti{1, 1, 0}));
}

TEST(Topology, CavityOpenOnlyThroughAnEdgeStaysACavity) {
    // The background is joined by faces alone: a diagonal gap does not open it.
    Mask mask(cube_grid(5));
    for (int z = 1; z < 4; ++z)
        for (int y = 1; y < 4; ++y)
            for (int x = 1; x < 4; ++x) mask.at(x, y, z) = 1;
    mask.at(2, 2, 2) = 0;
    mask.at(1, 1, 2) = 0;
    EXPECT_EQ(betti_numbers(mask), (Betti{1, 0, 1}));
    mask.at(1, 2, 2) = 0;
    EXPECT_EQ(betti_numbers(mask), (Betti{1, 0, 0}));
}

// Mirroring and exchanging axes change nothing.
TEST(Topology, DoesNotDependOnOrientation) {
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 300; ++trial) {
        const Mask mask = bernoulli_mask(6, 0.05 + 0.75 * uniform(random), random);
        Mask turned(mask.grid);
        for (int z = 0; z < 6; ++z)
            for (int y = 0; y < 6; ++y)
                for (int x = 0; x < 6; ++x) turned.at(5 - z, x, 5 - y) = mask.at(x, y, z);
        EXPECT_EQ(betti_numbers(turned), betti_numbers(mask));
    }
}

}  // namespace hepatica
