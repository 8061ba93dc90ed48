// SPDX-License-Identifier: GPL-3.0-or-later
// What vessel_tree.h promises of a tree, broken in one place at a time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "core/base/error.h"
#include "core/tree/vessel_tree.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

using Break = std::function<void(VesselTree&)>;

std::string problem_of(const Break& damage) {
    VesselTree tree = test::forked_tree();
    damage(tree);
    try {
        validate(tree);
    } catch (const InputError& error) {
        return error.place() + ": " + error.problem();
    }
    return "";
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ValidTree, IsTheForkAndEachFaultInItIsNamedWithItsSegment) {
    EXPECT_EQ(problem_of([](VesselTree&) {}), "");
    const struct {
        const char* words;
        Break damage;
    } faults[] = {
        {"fewer than two points", [](VesselTree& t) { t.segments[1].points_mm.resize(1); }},
        {"one radius per point", [](VesselTree& t) { t.segments[1].radii_mm.pop_back(); }},
        {"bridges a gap", [](VesselTree& t) { t.segments[1].bridged = {1}; }},
        {"not finite", [](VesselTree& t) { t.segments[1].points_mm.front().x() = nan; }},
        {"not finite", [](VesselTree& t) { t.segments[1].points_mm.back().z() = infinity; }},
        {"radius", [](VesselTree& t) { t.segments[1].radii_mm.front() = 0.0; }},
        {"radius", [](VesselTree& t) { t.segments[1].radii_mm.back() = infinity; }},
        {"radius", [](VesselTree& t) { t.segments[1].radii_mm.back() = nan; }},
        {"two equal consecutive points",
         [](VesselTree& t) { t.segments[1].points_mm[1] = t.segments[1].points_mm[0]; }},
        {"two equal consecutive points",
         [](VesselTree& t) {
             std::vector<Vec3>& points = t.segments[1].points_mm;
             points[points.size() - 2] = points.back();
         }},
        {"a node that does not exist",
         [](VesselTree& t) { t.segments[1].distal_node = static_cast<int>(t.nodes.size()); }},
        {"a node that does not exist", [](VesselTree& t) { t.segments[1].distal_node = -1; }},
        {"a node that does not exist",
         [](VesselTree& t) { t.segments[1].proximal_node = static_cast<int>(t.nodes.size()); }},
        {"a node that does not exist", [](VesselTree& t) { t.segments[1].proximal_node = -1; }},
        {"before its parent", [](VesselTree& t) { t.segments[1].parent = 1; }},
        {"where its parent ends",
         [](VesselTree& t) { t.segments[1].proximal_node = t.segments[1].distal_node; }},
        {"confidence", [](VesselTree& t) { t.segments[1].system_confidence = 1.01; }},
        {"confidence", [](VesselTree& t) { t.segments[1].system_confidence = -0.01; }},
        {"confidence", [](VesselTree& t) { t.segments[1].system_confidence = nan; }},
    };
    for (const auto& [words, damage] : faults) {
        const std::string problem = problem_of(damage);
        EXPECT_THAT(problem, testing::HasSubstr(words));
        EXPECT_THAT(problem, testing::HasSubstr("segment 1"));
    }
}

TEST(ValidTree, MayBeEmptyAndSureOrNotAtAll) {
    EXPECT_NO_THROW(validate(VesselTree{}));
    for (const double confidence : {0.0, 1.0})
        EXPECT_EQ(problem_of([confidence](VesselTree& tree) {
                      for (VesselSegment& segment : tree.segments)
                          segment.system_confidence = confidence;
                  }),
                  "");
}

}  // namespace
}  // namespace hepatica
