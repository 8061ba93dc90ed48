// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/surface_features.h"

#include <gtest/gtest.h>

#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"

namespace hepatica {
namespace {

// What the lists of features hold, counted one by one. The surface is one patch, so that each
// feature is of one patch; per triangle there is a little more: the lists of the patch.
TEST(SurfaceFeatures, SayHowMuchMemoryTheirListsTake) {
    const TetMesh brick = kuhn_brick(Vec3(60, 20, 20), {12, 4, 4});
    const auto triangles = boundary_triangles(brick);
    const SurfaceFeatures features(SurfacePatches(triangles, static_cast<int>(triangles.size())),
                                   brick.vertices_mm);
    ASSERT_EQ(features.surface().size(), 1u);
    constexpr std::size_t list = sizeof(std::vector<int>), number = sizeof(int);
    std::size_t bytes = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const int triangle = static_cast<int>(t);
        bytes += 3 * number + sizeof(features.patch_of(triangle));
        bytes += list + features.nodes_owned_by(triangle).size_bytes();
        bytes += list + features.edges_owned_by(triangle).size_bytes();
    }
    for (std::size_t e = 0; e < features.edges().size(); ++e)
        bytes += 2 * number + sizeof(double) + list +
                 features.patches_of_edge(static_cast<int>(e)).size_bytes();
    for (std::size_t n = 0; n < brick.vertices_mm.size(); ++n)
        bytes += sizeof(double) + list + features.patches_of_node(static_cast<int>(n)).size_bytes();
    bytes += features.nodes().size() * number;
    EXPECT_GE(features.bytes(), bytes);
    EXPECT_LE(features.bytes(), bytes + 3 * number * triangles.size());
}

}  // namespace
}  // namespace hepatica
