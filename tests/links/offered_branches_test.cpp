// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/links/offered_branches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/links/drawn_lines.h"

namespace hepatica {
namespace {

using testing::IsEmpty;

constexpr double edge_mm = 0.5;

// A trunk along x that is kept, and lines that the model has dropped.
class OfferedBranches : public testing::Test {
  protected:
    OfferedBranches() : lines_(test::cubes(96, edge_mm)) {
        test::draw_along_x(lines_, 5, 90, 20, 48);
    }
    void cut_up() { pieces_ = line_pieces(lines_, test::thickened(lines_, 2.0), 8.0); }
    bool is_trunk(const LinePiece& piece) const {
        return std::ranges::all_of(piece.points_mm, [](const Vec3& p) {
            return std::abs(p.y() - 20 * edge_mm) < 2 * edge_mm;
        });
    }
    // With this share of vessel along all dropped lines, and another beyond a place along y.
    std::vector<Bridge> offered(double share, double beyond_y_mm = 1e9, double there = 0.0) {
        std::vector<double> shares;
        std::vector<std::uint8_t> chosen;
        for (const LinePiece& piece : pieces_) {
            const Vec3& middle = piece.points_mm[piece.points_mm.size() / 2];
            shares.push_back(middle.y() > beyond_y_mm ? there : share);
            chosen.push_back(is_trunk(piece) ? 1 : 0);
        }
        return offered_branches(pieces_, shares, chosen);
    }

    Mask lines_;
    std::vector<LinePiece> pieces_;
};

TEST_F(OfferedBranches, LeadFromWhatIsKeptToTheTip) {
    test::draw_along_y(lines_, 48, 21, 70, 48);
    cut_up();
    const std::vector<Bridge> branches = offered(0.7);
    ASSERT_EQ(branches.size(), 1u);
    const Bridge& branch = branches[0];
    EXPECT_TRUE(branch.is_branch());
    EXPECT_FALSE(branch.built);
    EXPECT_NEAR(branch.confidence, 0.7, 1e-9);
    EXPECT_LT((branch.path_mm.front() - Vec3(24, 10, 24)).norm(), 2.0 * edge_mm);
    EXPECT_LT((branch.path_mm.back() - Vec3(24, 35, 24)).norm(), edge_mm);
    EXPECT_NEAR(branch.gap_mm, 25.0, 2.0 * edge_mm);
    ASSERT_EQ(branch.radii_mm.size(), branch.path_mm.size());
    EXPECT_NEAR(branch.radii_mm[branch.radii_mm.size() / 2], 2.0 * edge_mm, edge_mm);
    for (std::size_t i = 1; i < branch.path_mm.size(); ++i)
        EXPECT_GE(branch.path_mm[i].y(), branch.path_mm[i - 1].y()) << "outwards, " << i;
}

TEST_F(OfferedBranches, OfATwigBeginsOnTheBranchThatCarriesIt) {
    test::draw_along_y(lines_, 48, 21, 80, 48);
    test::draw_along_x(lines_, 49, 70, 55, 48);
    cut_up();
    const std::vector<Bridge> branches = offered(0.6);
    ASSERT_EQ(branches.size(), 2u);
    const auto longer = std::ranges::max_element(branches, {}, &Bridge::gap_mm);
    const auto twig = std::ranges::min_element(branches, {}, &Bridge::gap_mm);
    EXPECT_NEAR(longer->gap_mm, 30.0, 2.0);
    EXPECT_NEAR(twig->gap_mm, 11.0, 2.0);
    const Vec3& begin = twig->path_mm.front();
    const auto to_twig = [&](const Vec3& p) { return (p - begin).norm(); };
    EXPECT_LT(to_twig(*std::ranges::min_element(longer->path_mm, {}, to_twig)), 2.0 * edge_mm);
}

TEST_F(OfferedBranches, EndWhereTheModelSeesNoVesselAnyMore) {
    test::draw_along_y(lines_, 48, 21, 90, 48);
    cut_up();
    const double whole = offered(0.6).at(0).gap_mm;
    const std::vector<Bridge> branches = offered(0.6, 30.0, 0.05);
    ASSERT_EQ(branches.size(), 1u);
    EXPECT_LT(branches[0].gap_mm, whole - 10.0);
    EXPECT_NEAR(branches[0].confidence, 0.6, 1e-9);
    EXPECT_THAT(offered(0.05), IsEmpty());
}

TEST_F(OfferedBranches, CloseNoLoopAndHangOnSomething) {
    test::draw_along_x(lines_, 5, 90, 60, 48);
    test::draw_along_y(lines_, 48, 21, 59, 48);
    cut_up();
    std::vector<double> shares(pieces_.size(), 0.8);
    std::vector<std::uint8_t> both;
    for (const LinePiece& piece : pieces_)
        both.push_back(std::abs(piece.points_mm.front().y() - piece.points_mm.back().y()) < 1.0);
    EXPECT_THAT(offered_branches(pieces_, shares, both), IsEmpty());
    const std::vector<std::uint8_t> none(pieces_.size(), 0);
    EXPECT_THAT(offered_branches(pieces_, shares, none), IsEmpty());
    EXPECT_THAT(offered_branches({}, {}, {}), IsEmpty());
}

TEST_F(OfferedBranches, ThatAreShortAreNotWorthAQuestion) {
    test::draw_along_y(lines_, 48, 21, 26, 48);
    cut_up();
    EXPECT_THAT(offered(0.9), IsEmpty());
}

TEST_F(OfferedBranches, StandInTheOrderOfTheirConfidence) {
    for (const int x : {20, 40, 60, 80}) test::draw_along_y(lines_, x, 21, 40 + x / 2, 48);
    cut_up();
    std::vector<double> shares;
    std::vector<std::uint8_t> chosen;
    for (const LinePiece& piece : pieces_) {
        shares.push_back(0.55 + piece.points_mm[1].x() / 200.0);
        chosen.push_back(is_trunk(piece) ? 1 : 0);
    }
    const std::vector<Bridge> branches = offered_branches(pieces_, shares, chosen);
    ASSERT_EQ(branches.size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(branches, std::ranges::greater{}, &Bridge::confidence));
    EXPECT_GT(branches.front().confidence, branches.back().confidence + 0.05);
}

}  // namespace
}  // namespace hepatica
