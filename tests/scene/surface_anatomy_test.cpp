// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/surface_anatomy.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

VesselSegment straight(int parent, VascularSystem system, const Vec3& from, const Vec3& to) {
    VesselSegment segment;
    segment.parent = parent;
    segment.system = system;
    segment.points_mm = {from, to};
    segment.radii_mm = {1.0, 1.0};
    return segment;
}

// A portal trunk of 10 mm that forks, and a hepatic vein beside it.
class Anatomy : public testing::Test {
  protected:
    static SurfaceAnatomy anatomy() {
        VesselTree tree;
        tree.segments = {straight(-1, VascularSystem::portal, Vec3(0, 0, 0), Vec3(0, 0, 10)),
                         straight(0, VascularSystem::portal, Vec3(0, 0, 10), Vec3(20, 0, 10)),
                         straight(0, VascularSystem::portal, Vec3(0, 0, 10), Vec3(-20, 0, 10)),
                         straight(-1, VascularSystem::hepatic, Vec3(100, 0, 0), Vec3(100, 0, 30))};
        // Vertices a millimetre beside the trunk's beginning and end, a branch, and the vein.
        const std::vector<Vec3> vertices{Vec3(0, 1, 2), Vec3(0, 1, 8), Vec3(15, 1, 10),
                                         Vec3(101, 0, 20)};
        Job job;
        return {tree, vertices, job};
    }
    const SurfaceAnatomy anatomy_ = anatomy();
};

TEST_F(Anatomy, KnowsTheVesselOfEachVertex) {
    EXPECT_EQ(anatomy_.tree_point(2).segment, 1);
    EXPECT_NEAR(anatomy_.tree_point(2).arclength_mm, 15.0, 1e-12);
    EXPECT_EQ(anatomy_.tree_point(-1).segment, -1);
    EXPECT_EQ(anatomy_.tree_point(4).segment, -1);
    using enum VascularSystem;
    EXPECT_EQ(anatomy_.vertex_systems(),
              (std::vector<VascularSystem>{portal, portal, portal, hepatic}));
}

TEST_F(Anatomy, MarksWhatLiesDownstream) {
    using Marks = std::vector<std::uint8_t>;
    EXPECT_EQ(anatomy_.downstream_of({0, 5.0}), (Marks{0, 1, 1, 0}));
    EXPECT_EQ(anatomy_.downstream_of({1, 0.0}), (Marks{0, 0, 1, 0}));
    EXPECT_EQ(anatomy_.downstream_of({2, 0.0}), (Marks{0, 0, 0, 0}));
}

TEST_F(Anatomy, CountsEndsOfTheOwnSystem) {
    EXPECT_EQ(anatomy_.ends_downstream_of(0), 2);
    EXPECT_EQ(anatomy_.ends_downstream_of(1), 1);
    EXPECT_EQ(anatomy_.ends_downstream_of(-1), 0);
    EXPECT_EQ(anatomy_.ends_in_system_of(2), 2);
    EXPECT_EQ(anatomy_.ends_in_system_of(3), 1);
}

// A share of one tree's flow says nothing of what another tree of the system gets.
TEST(AnatomyOfTrees, SaysOfWhichTreeASharesIs) {
    VesselTree tree;
    tree.segments = {straight(-1, VascularSystem::portal, Vec3(0, 0, 0), Vec3(0, 0, 10)),
                     straight(0, VascularSystem::portal, Vec3(0, 0, 10), Vec3(20, 0, 10)),
                     straight(0, VascularSystem::portal, Vec3(0, 0, 10), Vec3(-20, 0, 10)),
                     straight(-1, VascularSystem::portal, Vec3(50, 0, 0), Vec3(50, 0, 10))};
    Job job;
    const SurfaceAnatomy anatomy(tree, std::vector<Vec3>{}, job);
    EXPECT_EQ(anatomy.ends_in_tree_of(1), 2);
    EXPECT_EQ(anatomy.ends_in_tree_of(3), 1);
    EXPECT_EQ(anatomy.ends_in_system_of(3), 3);
    EXPECT_EQ(anatomy.ends_in_tree_of(-1), 0);
    const std::vector<double> shares{1.0, 0.4, 0.6, 1.0};
    EXPECT_EQ(anatomy.describe({3, 5.0}, shares),
              "Branch 4 (portal vein), 5 of 10 mm along: 1 of 1 ends of this tree lie downstream; "
              "they get 100 % of its flow; 2 more ends of the system hang on other roots");
}

TEST_F(Anatomy, DescribesAPointInWords) {
    EXPECT_EQ(anatomy_.describe({0, 5.0}, {}),
              "Branch 1 (portal vein), 5 of 10 mm along: 2 of 2 ends lie downstream");
    const std::vector<double> shares{1.0, 0.905, 0.095, 1.0};
    EXPECT_EQ(
        anatomy_.describe({2, 3.0}, shares),
        "Branch 3 (portal vein), 3 of 20 mm along: 1 of 2 ends lie downstream; they get 9.5 % "
        "of the flow");
    EXPECT_EQ(anatomy_.describe({3, 30.0}, shares),
              "Branch 4 (hepatic veins), 30 of 30 mm along: 1 of 1 ends lie downstream; they get "
              "100 % of the flow");
    EXPECT_EQ(anatomy_.describe({-1, 0.0}, shares), "");
}

}  // namespace
}  // namespace hepatica
