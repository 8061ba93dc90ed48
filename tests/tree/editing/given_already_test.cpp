// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/editing/given_already.h"

#include <gtest/gtest.h>

#include "core/tree/system_summary.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

TreeEdit given(TreeEditKind kind, const Vec3& at_mm, VascularSystem system) {
    TreeEdit edit;
    edit.kind = kind;
    edit.at_mm = at_mm;
    edit.system = system;
    return edit;
}

class GivenAlready : public ::testing::Test {
  protected:
    GivenAlready() {
        for (VesselSegment& segment : tree_.segments) segment.system = VascularSystem::portal;
        for (const int root : roots(tree_)) root_mm_ = tree_.segments[root].points_mm[1];
        for (std::size_t s = 0; s < tree_.segments.size(); ++s)
            if (children(tree_)[s].empty()) leaf_ = s;
    }
    Vec3 leaf_mm() const { return tree_.segments[leaf_].points_mm[1]; }

    VesselTree tree_ = test::forked_tree();
    Vec3 root_mm_ = Vec3::Zero();
    std::size_t leaf_ = 0;
};

TEST_F(GivenAlready, IsWhatHasTheSystemWithAllThatHangsOnIt) {
    for (const Vec3& place : {root_mm_, leaf_mm()}) {
        EXPECT_TRUE(is_given_already(
            tree_, given(TreeEditKind::reassign_system, place, VascularSystem::portal)));
        EXPECT_FALSE(is_given_already(
            tree_, given(TreeEditKind::reassign_system, place, VascularSystem::hepatic)));
    }
    tree_.segments[leaf_].system = VascularSystem::hepatic;
    EXPECT_FALSE(is_given_already(
        tree_, given(TreeEditKind::reassign_system, root_mm_, VascularSystem::portal)))
        << "what hangs on it would change";
    EXPECT_TRUE(
        is_given_already(tree_, given(TreeEditKind::seed_system, root_mm_, VascularSystem::portal)))
        << "as edited() refuses it";
    EXPECT_FALSE(is_given_already(
        tree_, given(TreeEditKind::seed_system, root_mm_, VascularSystem::hepatic)));
}

TEST_F(GivenAlready, SettlesADoubtWhereSomeOfItWasNotSure) {
    const auto settles = [this](TreeEditKind kind, const Vec3& at_mm, VascularSystem system) {
        return settles_a_doubt(tree_, given(kind, at_mm, system));
    };
    constexpr auto reassign = TreeEditKind::reassign_system;
    for (VesselSegment& segment : tree_.segments) segment.system_confidence = sure_confidence;
    EXPECT_FALSE(settles(reassign, root_mm_, VascularSystem::portal)) << "nothing is in doubt";
    tree_.segments[leaf_].system_confidence = 0.99 * sure_confidence;
    EXPECT_TRUE(settles(reassign, root_mm_, VascularSystem::portal)) << "a leaf hangs on it";
    EXPECT_TRUE(settles(reassign, leaf_mm(), VascularSystem::portal));
    EXPECT_FALSE(settles(reassign, leaf_mm(), VascularSystem::hepatic)) << "it changes more";
    EXPECT_FALSE(settles(TreeEditKind::seed_system, leaf_mm(), VascularSystem::portal))
        << "edited() refuses it";
    for (VesselSegment& segment : tree_.segments) segment.system = VascularSystem::unknown;
    EXPECT_FALSE(settles(reassign, leaf_mm(), VascularSystem::unknown)) << "nothing is stated";
}

TEST_F(GivenAlready, IsNothingElse) {
    EXPECT_FALSE(
        is_given_already(tree_, given(TreeEditKind::set_root, root_mm_, VascularSystem::portal)));
    EXPECT_FALSE(is_given_already(
        tree_, given(TreeEditKind::reassign_system, {500, 0, 0}, VascularSystem::portal)));
    EXPECT_FALSE(is_given_already(
        {}, given(TreeEditKind::reassign_system, root_mm_, VascularSystem::portal)));
}

}  // namespace
}  // namespace hepatica
