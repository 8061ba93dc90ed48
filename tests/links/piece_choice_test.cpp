// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/links/piece_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/links/drawn_lines.h"

namespace hepatica {
namespace {

using testing::Each;
using testing::ElementsAre;

std::vector<LinePiece> chain_of(const std::vector<double>& lengths_mm) {
    std::vector<LinePiece> chain(lengths_mm.size());
    const auto count = static_cast<int>(chain.size());
    for (int i = 0; i < count; ++i) {
        chain[i].length_mm = lengths_mm[i];
        if (i > 0) chain[i].neighbours.push_back(i - 1);
        if (i + 1 < count) chain[i].neighbours.push_back(i + 1);
    }
    return chain;
}

TEST(ChosenPieces, KeepsWhatIsLikelierVesselThanAsked) {
    const auto alone = chain_of({8});
    EXPECT_THAT(chosen_pieces(alone, {0.61}, 0.6), ElementsAre(1));
    EXPECT_THAT(chosen_pieces(alone, {0.59}, 0.6), ElementsAre(0));
}

TEST(ChosenPieces, AShortDoubtBetweenSureOnesStaysAndALongOneGoes) {
    EXPECT_THAT(chosen_pieces(chain_of({8, 1, 8}), {0.9, 0.1, 0.9}, 0.5), ElementsAre(1, 1, 1));
    EXPECT_THAT(chosen_pieces(chain_of({8, 8, 8}), {0.9, 0.1, 0.9}, 0.5), ElementsAre(1, 0, 1));
    // Likewise the other way round.
    EXPECT_THAT(chosen_pieces(chain_of({8, 1, 8}), {0.1, 0.9, 0.1}, 0.5), ElementsAre(0, 0, 0));
}

class WithoutDropped : public testing::Test {
  protected:
    // A trunk of 4 voxels in radius along x and a branch of 2 along y.
    WithoutDropped() : lines_(test::cubes(64, 0.5)), trunk_(lines_.grid), branch_(lines_.grid) {
        test::draw_along_x(trunk_, 5, 58, 20, 32);
        test::draw_along_y(branch_, 30, 21, 55, 32);
        for (std::size_t i = 0; i < lines_.voxels.size(); ++i)
            lines_.voxels[i] = trunk_.voxels[i] | branch_.voxels[i];
        const Mask wide = test::thickened(trunk_, 4.0), narrow = test::thickened(branch_, 2.0);
        vessels_ = wide;
        for (std::size_t i = 0; i < vessels_.voxels.size(); ++i)
            vessels_.voxels[i] |= narrow.voxels[i];
        trunk_lumen_ = wide;
        pieces_ = line_pieces(lines_, vessels_, 8.0);
    }

    Mask lines_, trunk_, branch_, vessels_, trunk_lumen_;
    std::vector<LinePiece> pieces_;
};

TEST_F(WithoutDropped, ABranchGoesAndItsTrunkStaysWhole) {
    std::vector<std::uint8_t> chosen;
    for (const LinePiece& piece : pieces_)
        chosen.push_back(std::abs(piece.points_mm.back().y() - piece.points_mm.front().y()) < 1.0);
    const Mask left = without_dropped(vessels_, pieces_, chosen, Job());
    std::size_t lost = 0, stays = 0;
    for (std::size_t i = 0; i < left.voxels.size(); ++i) {
        EXPECT_LE(left.voxels[i], vessels_.voxels[i]);
        const Index3 at = left.grid.index_of(i);
        stays += left.voxels[i] && at[1] > 27;  // a few voxels beyond the trunk's wall at 24
        if (!trunk_lumen_.voxels[i] || left.voxels[i]) continue;
        ++lost;
        EXPECT_LE(std::hypot(at[0] - 30, at[2] - 32), 3.0);
        EXPECT_GE(at[1], 21);  // not the trunk's axis
    }
    EXPECT_LE(lost, 38u);  // three layers of the branch's mouth
    EXPECT_EQ(stays, 0u);
}

TEST_F(WithoutDropped, AllOrNothing) {
    const std::vector<std::uint8_t> all(pieces_.size(), 1), none(pieces_.size(), 0);
    EXPECT_EQ(without_dropped(vessels_, pieces_, all, Job()).voxels, vessels_.voxels);
    EXPECT_THAT(without_dropped(vessels_, pieces_, none, Job()).voxels, Each(0));
}

TEST_F(WithoutDropped, WhatHangsTogetherWithNoPieceStays) {
    Mask with_dot = vessels_;
    with_dot.at(60, 60, 60) = 1;
    const std::vector<std::uint8_t> none(pieces_.size(), 0);
    const Mask left = without_dropped(with_dot, pieces_, none, Job());
    EXPECT_EQ(left.at(60, 60, 60), 1);
    EXPECT_EQ(std::count(left.voxels.begin(), left.voxels.end(), 1), 1);
}

}  // namespace
}  // namespace hepatica
