// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/links/way_to_sure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hepatica {
namespace {

LinePiece piece_of(double length_mm, std::vector<int> neighbours) {
    LinePiece piece;
    piece.length_mm = length_mm;
    piece.neighbours = std::move(neighbours);
    return piece;
}

TEST(WayToSure, IsCountedAlongTheChain) {
    const std::vector<LinePiece> chain{piece_of(4, {1}), piece_of(6, {0, 2}), piece_of(8, {1})};
    const std::vector<double> lines{2.0, 1.1, 1.3}, radii{2.0, 1.0, 3.0};
    const auto ways = ways_to_sure(chain, lines, radii);
    EXPECT_DOUBLE_EQ(ways[0].distance_mm, 0.0);
    EXPECT_DOUBLE_EQ(ways[1].distance_mm, 5.0);
    EXPECT_DOUBLE_EQ(ways[2].distance_mm, 12.0);
    EXPECT_DOUBLE_EQ(ways[0].weakest_line, 2.0);
    EXPECT_DOUBLE_EQ(ways[1].weakest_line, 1.1);
    EXPECT_DOUBLE_EQ(ways[2].weakest_line, 1.1);
}

TEST(WayToSure, NothingIsSureThatIsThinOrFaint) {
    const std::vector<LinePiece> alone{piece_of(4, {}), piece_of(4, {})};
    const std::vector<double> lines{1.5, 9.0}, radii{9.0, 1.4};
    for (const WayToSure& way : ways_to_sure(alone, lines, radii)) {
        EXPECT_DOUBLE_EQ(way.distance_mm, farthest_sure_mm);
        EXPECT_DOUBLE_EQ(way.weakest_line, 0.0);
    }
}

// Against all simple ways, tried one by one.
struct AllWays {
    const std::vector<LinePiece>& pieces;
    const std::vector<double>& lines;
    const std::vector<double>& radii;
    double shortest = farthest_sure_mm, strongest = 0.0;
    std::vector<int> on_way = {};

    void walk(int at, double length, double weakest) {
        weakest = std::min(weakest, lines[at]);
        if (lines[at] >= sure_line && radii[at] >= sure_radius_mm) {
            shortest = std::min(shortest, length);
            strongest = std::max(strongest, weakest);
        }
        on_way.push_back(at);
        for (const int next : pieces[at].neighbours)
            if (std::ranges::find(on_way, next) == on_way.end())
                walk(next, length + 0.5 * (pieces[at].length_mm + pieces[next].length_mm), weakest);
        on_way.pop_back();
    }
};

TEST(WayToSure, IsTheBestOfAllWays) {
    std::mt19937 random(7);
    const auto draw = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 1000) / 1000.0;
    };
    for (int trial = 0; trial < 60; ++trial) {
        constexpr int count = 8;
        std::vector<LinePiece> pieces(count);
        std::vector<double> lines, radii;
        for (LinePiece& piece : pieces) {
            piece.length_mm = draw(1.0, 30.0);
            lines.push_back(draw(0.8, 2.4));
            radii.push_back(draw(0.5, 2.5));
        }
        for (int a = 0; a < count; ++a)
            for (int b = 0; b < a; ++b)
                if (random() % 4 == 0) {
                    pieces[a].neighbours.push_back(b);
                    pieces[b].neighbours.push_back(a);
                }
        const auto ways = ways_to_sure(pieces, lines, radii);
        for (int i = 0; i < count; ++i) {
            AllWays all{pieces, lines, radii};
            all.walk(i, 0.0, 100.0);
            EXPECT_NEAR(ways[i].distance_mm, all.shortest, 1e-9) << trial << " " << i;
            EXPECT_NEAR(ways[i].weakest_line, all.strongest, 1e-12) << trial << " " << i;
        }
    }
}

}  // namespace
}  // namespace hepatica
