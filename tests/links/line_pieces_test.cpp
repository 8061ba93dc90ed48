// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/links/line_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/links/drawn_lines.h"

namespace hepatica {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LinePieces, CutsALineIntoAChainOfEvenPieces) {
    Mask line(test::cubes(48, 0.5));
    test::draw_along_x(line, 4, 44, 20, 20);  // 20 mm
    const auto pieces = line_pieces(line, line, 8.0);
    ASSERT_EQ(pieces.size(), 3u);
    double sum = 0.0;
    for (const LinePiece& piece : pieces) {
        EXPECT_NEAR(piece.length_mm, 20.0 / 3.0, 0.51);
        EXPECT_NEAR(piece.link_length_mm, 20.0, 1e-9);
        EXPECT_EQ(piece.points_mm.size(), piece.radii_mm.size());
        sum += piece.length_mm;
    }
    EXPECT_NEAR(sum, 20.0, 1e-9);
    EXPECT_THAT(pieces[0].neighbours, ElementsAre(1));
    EXPECT_THAT(pieces[1].neighbours, ElementsAre(0, 2));
    EXPECT_THAT(pieces[2].neighbours, ElementsAre(1));
    EXPECT_EQ(pieces[0].free_ends, 1);
    EXPECT_EQ(pieces[1].free_ends, 0);
    EXPECT_EQ(pieces[2].free_ends, 1);
    EXPECT_EQ(pieces[0].points_mm.back(), pieces[1].points_mm.front());
}

TEST(LinePieces, MeetAtABifurcation) {
    Mask lines(test::cubes(32, 1.0));
    test::draw_along_x(lines, 4, 27, 15, 15);
    test::draw_along_y(lines, 15, 16, 27, 15);
    const auto pieces = line_pieces(lines, lines, 100.0);
    ASSERT_EQ(pieces.size(), 3u);
    for (const LinePiece& piece : pieces) {
        EXPECT_EQ(piece.neighbours.size(), 2u);
        EXPECT_EQ(piece.free_ends, 1);
    }
}

TEST(LinePieces, ComponentsHangTogether) {
    Mask lines(test::cubes(48, 1.0));
    test::draw_along_x(lines, 2, 44, 10, 10);
    test::draw_along_x(lines, 2, 12, 30, 30);
    const auto pieces = line_pieces(lines, lines, 8.0);
    const std::vector<int> component = components_of(pieces);
    ASSERT_EQ(component.size(), pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t k = 0; k < pieces.size(); ++k)
            EXPECT_EQ(component[i] == component[k],
                      pieces[i].points_mm[0].y() == pieces[k].points_mm[0].y());
}

TEST(LinePieces, NothingGivesNothing) {
    const Mask none(test::cubes(8, 1.0));
    EXPECT_THAT(line_pieces(none, none, 8.0), IsEmpty());
    EXPECT_THAT(components_of({}), IsEmpty());
}

}  // namespace
}  // namespace hepatica
