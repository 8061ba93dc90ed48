// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/body/torn_body.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

// Three vertices; then 3 was split from 0, 4 from 3, and 5 from 2.
TEST(TornBody, EverySplitVertexComesFromOneOfThoseBefore) {
    const std::vector<int> parents{0, 1, 2, 0, 3, 2};
    EXPECT_EQ(nodes_before(parents, 3), (std::vector<int>{0, 1, 2, 0, 0, 2}));
    EXPECT_EQ(nodes_before(parents, 4), (std::vector<int>{0, 1, 2, 3, 3, 2}));
    EXPECT_EQ(nodes_before(parents, 6), (std::vector<int>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(nodes_before({}, 0), std::vector<int>{});
}

TEST(TornBody, ASplitVertexHasWhatItsParentHas) {
    const std::vector<int> parents{0, 1, 2, 0, 3, 2};
    std::vector<double> masses{1.0, 2.0, 3.0};
    inherit(parents, masses);
    EXPECT_EQ(masses, (std::vector<double>{1.0, 2.0, 3.0, 1.0, 1.0, 3.0}));
    inherit(std::span(parents).first(4), masses);  // made whole again, in part
    EXPECT_EQ(masses, (std::vector<double>{1.0, 2.0, 3.0, 1.0}));
}

}  // namespace
}  // namespace hepatica
