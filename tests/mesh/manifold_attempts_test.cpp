// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/manifold_attempts.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/quality.h"

namespace hepatica {
namespace {

// Two tetrahedra that share the edge 0-1 and nothing else: four triangles meet in it.
TetMesh two_on_one_edge() {
    TetMesh mesh;
    mesh.vertices_mm = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
    mesh.tetrahedra = {{0, 2, 3, 1}, {0, 4, 5, 1}};
    return mesh;
}

TetMesh one() {
    TetMesh mesh = two_on_one_edge();
    mesh.tetrahedra.pop_back();
    mesh.vertices_mm.resize(4);
    return mesh;
}

TEST(ManifoldAttempts, EndWithTheFirstThatIsClosed) {
    std::vector<double> scales;
    const ManifoldMesh made = first_manifold([&](double scale) {
        scales.push_back(scale);
        return scales.size() < 3 ? two_on_one_edge() : one();
    });
    EXPECT_TRUE(made.is_manifold);
    EXPECT_EQ(made.mesh.tetrahedra.size(), 1u);
    EXPECT_EQ(scales, (std::vector<double>{1.0, 0.93, 0.86}));
}

// The last was kept without a word.
TEST(ManifoldAttempts, ThatAllFailAreTold) {
    validate(two_on_one_edge());
    EXPECT_FALSE(quality_of(two_on_one_edge()).closed);
    int attempts = 0;
    const ManifoldMesh made = first_manifold([&](double) {
        ++attempts;
        return two_on_one_edge();
    });
    EXPECT_EQ(attempts, 4);
    EXPECT_FALSE(made.is_manifold);

    std::vector<std::string> warnings;
    report_unclosed(0, 2, &warnings);
    EXPECT_TRUE(warnings.empty());
    report_unclosed(0, 2, nullptr);
    report_unclosed(1, 2, &warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("1 of 2 bodies meets itself"), std::string::npos) << warnings[0];
    EXPECT_THROW(report_unclosed(1, 2, nullptr), InputError);
}

}  // namespace
}  // namespace hepatica
