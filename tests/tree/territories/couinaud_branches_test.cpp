// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/territories/couinaud_branches.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hepatica {
namespace {

CouinaudFrame frame_of_an_adult() {
    CouinaudFrame frame;
    frame.trunk = 0;
    frame.confluence_mm = Vec3(-27, 34, 44);
    frame.bifurcation_mm = Vec3(-40, 10, -10);
    frame.border_azimuth_rad = {0.4, 1.2, 1.8};
    frame.right_branch_mm = Vec3(-65, 10, -6);
    frame.left_branch_mm = Vec3(0, -30, 12);
    return frame;
}

// A portal vein of straight segments: `ends[i]` is where segment i ends, `parents[i]` its parent.
VesselTree portal_vein(const std::vector<Vec3>& ends, const std::vector<int>& parents) {
    VesselTree tree;
    tree.nodes.push_back({Vec3(-20, 24, -38), 6.0});
    for (std::size_t i = 0; i < ends.size(); ++i) {
        VesselSegment segment;
        segment.system = VascularSystem::portal;
        segment.parent = parents[i];
        segment.proximal_node = parents[i] < 0 ? 0 : parents[i] + 1;
        segment.distal_node = static_cast<int>(tree.nodes.size());
        segment.points_mm = {tree.nodes[segment.proximal_node].position_mm, ends[i]};
        segment.radii_mm = {2.0, 2.0};
        tree.nodes.push_back({ends[i], 2.0});
        tree.segments.push_back(segment);
    }
    return tree;
}

constexpr double never = -std::numeric_limits<double>::infinity();

// The energy of the header, written down once more.
double score(const std::vector<int>& state, const VesselTree& tree, const CouinaudFrame& frame) {
    using namespace branch_chain;
    std::vector<bool> divides(state.size(), false);
    for (const VesselSegment& segment : tree.segments)
        if (segment.parent >= 0) divides[segment.parent] = true;
    double sum = 0.0;
    for (std::size_t s = 0; s < state.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        const auto likelihood =
            segment_likelihoods(frame, 0.5 * (segment.points_mm[0] + segment.points_mm[1]));
        double best = least;
        for (const double one : likelihood) best = std::max(best, one);
        const double at = state[s] == 0 ? common * best : std::max(likelihood[state[s] - 1], least);
        sum += std::log(at) * length_mm(segment) / (witness_share * length_mm(tree));
        if (state[s] == 0 && !divides[s]) return never;
        if (static_cast<int>(s) == frame.trunk && state[s] != 0) return never;
        if (segment.parent < 0 || state[segment.parent] == state[s]) continue;
        const int above = state[segment.parent];
        if (state[s] == 0 || above == 1) return never;
        sum -= above == 0 ? leaving : changing;
    }
    return sum;
}

// Oracle: all 9^6 labellings, one by one. Many labels are unsure here: the branches are short and
// lie near borders.
TEST(CouinaudBranches, AreTheMostLikelyOfAllLabellingsWithTheirProbabilities) {
    const CouinaudFrame frame = frame_of_an_adult();
    const VesselTree tree = portal_vein({Vec3(-40, 10, -10), Vec3(-66, 6, -4), Vec3(-12, -14, 4),
                                         Vec3(-75, -6, -7), Vec3(-80, 8, -4), Vec3(-8, -22, 8)},
                                        {-1, 0, 0, 1, 1, 2});
    VesselTree longer = tree;  // most of the portal vein lies elsewhere, so that these count little
    longer.segments[0].points_mm = {Vec3(-20, 24, -5000), Vec3(-40, 10, -10)};
    std::vector<int> state(tree.segments.size(), 0), best;
    double most = never, total = 0.0;
    std::vector<std::array<double, 9>> weight(state.size(), std::array<double, 9>{});
    double reference = 0.0;
    for (int code = 0; code < 531441; ++code) {
        for (int rest = code, s = 0; s < 6; ++s, rest /= 9) state[s] = rest % 9;
        const double value = score(state, longer, frame);
        if (value == never) continue;
        if (total == 0.0) reference = value;
        const double w = std::exp(value - reference);
        total += w;
        for (std::size_t s = 0; s < state.size(); ++s) weight[s][state[s]] += w;
        if (value > most) {
            most = value;
            best = state;
        }
    }
    const std::vector<BranchLabel> labels = label_branches(longer, frame);
    int unsure = 0;
    for (std::size_t s = 0; s < labels.size(); ++s) {
        if (best[s] != 0) {
            EXPECT_EQ(labels[s].segment, best[s]) << s;
            EXPECT_NEAR(labels[s].confidence, weight[s][best[s]] / total, 1e-9) << s;
            if (labels[s].confidence < 0.9) ++unsure;
        }
    }
    EXPECT_GE(unsure, 2);
}

// A short twig of segment 8's branch that runs across the plane to segment 4 supplies segment 8
// still; a long one that goes on there is a branch of segment 4.
TEST(CouinaudBranches, ATwigAcrossAPlaneKeepsItsBranchsSegment) {
    const CouinaudFrame frame = frame_of_an_adult();
    const Vec3 hilum(-40, 10, -10), fork(-72, -14, 20);
    for (const double length : {6.0, 90.0}) {
        const Vec3 twig = Vec3(-48, -45, 22) + length * Vec3(0.8, -0.2, 0.0);
        VesselTree tree = portal_vein(
            {hilum, fork, Vec3(-84, -20, 45), Vec3(-52, -42, 22), twig, Vec3(-52, -45, 60)},
            {-1, 0, 1, 1, 3, 3});
        tree.segments[0].points_mm[0].z() = -3000.0;  // as long as a whole portal vein
        const std::vector<BranchLabel> labels = label_branches(tree, frame);
        EXPECT_EQ(labels[2].segment, 8);
        EXPECT_EQ(labels[4].segment, length < 10.0 ? 8 : 4) << length;
    }
}

}  // namespace
}  // namespace hepatica
