// SPDX-License-Identifier: GPL-3.0-or-later
// A JSON tree states the place of a fork in its node and in the points of its segments.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/base/error.h"
#include "core/tree/files/tree_io.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

std::filesystem::path file_of_test() {
    return std::filesystem::path(testing::TempDir()) / "hepatica_tree_ends.json";
}

std::string refusal_of(const VesselTree& tree) {
    write_tree_json(file_of_test(), tree);
    try {
        read_tree_json(file_of_test());
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), file_of_test().string());
        EXPECT_EQ(error.remedy(), "Let its first and last point be the positions of its nodes");
        return error.problem();
    }
    return "";
}

TEST(TreeJson, WhosePointsEndBesideTheirNodesIsRefused) {
    VesselTree tree = test::forked_tree();
    const int proximal = tree.segments[1].proximal_node, distal = tree.segments[1].distal_node;
    tree.segments[1].points_mm.front().z() += 0.05;  // rounded numbers
    EXPECT_EQ(refusal_of(tree), "");
    tree.segments[1].points_mm.front() = tree.nodes[proximal].position_mm + Vec3(0, 0, 2);
    EXPECT_EQ(refusal_of(tree), "has a segment 1 whose points end 2 mm away from its node " +
                                    std::to_string(proximal));
    tree = test::forked_tree();
    tree.segments[1].points_mm.back() = tree.nodes[distal].position_mm + Vec3(0, 0, 2);
    EXPECT_EQ(refusal_of(tree),
              "has a segment 1 whose points end 2 mm away from its node " + std::to_string(distal));
}

TEST(TreeJson, MayBeNamedInCapitals) {
    const auto file = std::filesystem::path(testing::TempDir()) / "HEPATICA_FORK.JSON";
    write_tree(file, test::forked_tree());
    test::expect_equal(read_tree(file), test::forked_tree());
}

}  // namespace
}  // namespace hepatica
