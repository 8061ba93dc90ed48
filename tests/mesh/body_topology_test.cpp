// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/body_topology.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace hepatica {
namespace {

using Triangles = BodyTopology::Triangles;

// Two triangles with a common edge from vertex 1 to vertex 2.
const Triangles square{{0, 1, 2}, {2, 1, 3}};

TEST(BodyTopology, AWholeBodysVerticesAreTheirOwnParents) {
    const BodyTopology topology(4, square);
    EXPECT_EQ(topology.version(), 1u);
    ASSERT_EQ(topology.vertex_count(), 4u);
    for (int v = 0; v < 4; ++v) EXPECT_EQ(topology.parent(v), v);
    EXPECT_EQ(*topology.triangles(), square);
}

// The common edge opens, and one of its clones is split once more.
TEST(BodyTopology, WhatIsKeptPerVertexFollowsTheParentsThroughSplits) {
    BodyTopology topology(4, square);
    const auto before = topology.triangles();
    std::vector<std::string> names{"a", "b", "c", "d"};
    topology.split(std::vector<int>{1, 2}, {{0, 1, 2}, {5, 4, 3}});
    EXPECT_EQ(topology.version(), 2u);
    EXPECT_EQ(topology.vertex_count(), 6u);
    EXPECT_EQ(topology.parent(4), 1);
    EXPECT_EQ(topology.parent(5), 2);
    EXPECT_EQ(*before, square);  // a frame that is shown keeps its own
    EXPECT_EQ((*topology.triangles())[1], (std::array<int, 3>{5, 4, 3}));
    topology.split(std::vector<int>{5, 6}, {{0, 1, 2}, {7, 4, 3}});
    EXPECT_EQ(topology.version(), 3u);
    inherit(topology, names);  // over both splits at once
    EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "c", "d", "b", "c", "c", "c"}));
    inherit(topology, names);
    EXPECT_EQ(names.size(), 8u);
}

TEST(BodyTopology, AVertexWithoutAParentIsABugAndChangesNothing) {
    BodyTopology topology(4, square);
    for (const std::vector<int>& parents :
         {std::vector<int>{-1}, std::vector<int>{4}, std::vector<int>{0, 6}})
        EXPECT_THROW(topology.split(parents, square), std::logic_error);
    EXPECT_THROW(topology.split(std::vector<int>{1}, {{0, 1, 5}}), std::logic_error);
    EXPECT_THROW(topology.split(std::vector<int>{1}, {{0, -1, 2}}), std::logic_error);
    EXPECT_EQ(topology.version(), 1u);
    EXPECT_EQ(topology.vertex_count(), 4u);
    EXPECT_EQ(*topology.triangles(), square);
    EXPECT_THROW(BodyTopology(3, square), std::logic_error);
}

}  // namespace
}  // namespace hepatica
