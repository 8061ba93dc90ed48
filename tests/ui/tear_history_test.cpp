// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tear_history.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

Frame frame_at(double time_s, const TearView& tear) {
    Frame frame;
    frame.time_s = time_s;
    frame.tear = tear;
    return frame;
}

TearView torn(int broken, int pieces, double leak_g_s, double produced_nats = 0.0) {
    TearView tear;
    tear.joints_broken = broken;
    tear.pieces = pieces;
    tear.leak_g_s = leak_g_s;
    tear.entropy_nats = 5.0 + produced_nats;
    tear.entropy_produced_nats = produced_nats;
    return tear;
}

std::vector<std::string> words(const TearHistory& history) {
    std::vector<std::string> all;
    for (const TearHistory::Event& event : history.events()) all.push_back(event.text);
    return all;
}

TEST(TearHistory, BeginsWhereVesselsMayTearAndKeepsBothEntropies) {
    TearHistory history;
    EXPECT_FALSE(history.follow(Frame{}));
    EXPECT_TRUE(history.empty());
    EXPECT_TRUE(history.follow(frame_at(7.0, torn(0, 1, 0.0))));
    EXPECT_FALSE(history.follow(frame_at(7.0, torn(0, 1, 0.0)))) << "the same moment";
    EXPECT_TRUE(history.follow(frame_at(7.5, torn(3, 1, 0.0, 0.25))));
    const Chart chart = history.chart();
    ASSERT_EQ(chart.curves.size(), 2u);
    EXPECT_EQ(chart.curves[0].x, (std::vector<double>{0.0, 0.5}));
    EXPECT_EQ(chart.curves[0].y, (std::vector<double>{5.0, 5.25}));
    EXPECT_EQ(chart.curves[1].y, (std::vector<double>{0.0, 0.25}));
}

TEST(TearHistory, SaysWhenSomethingHappens) {
    TearHistory history;
    history.follow(frame_at(0.0, torn(0, 1, 0.0)));
    history.follow(frame_at(1.0, torn(2, 1, 0.0)));
    history.follow(frame_at(2.0, torn(6, 2, 3.0)));
    history.follow(frame_at(3.0, torn(6, 2, 3.5)));
    history.follow(frame_at(4.0, torn(6, 2, 0.0)));
    TearView stopped = torn(6, 2, 0.0);
    stopped.stopped_by = "entropy";
    history.follow(frame_at(5.0, stopped));
    history.follow(frame_at(6.0, torn(0, 1, 0.0)));
    EXPECT_EQ(words(history),
              (std::vector<std::string>{"cut or torn", "piece off", "bleeding", "no more bleeding",
                                        "tear stopped", "whole"}));
    EXPECT_EQ(history.events()[1].time_s, 2.0);
}

TEST(TearHistory, OfAPatientInSeveralPiecesNoneIsTornOff) {
    TearHistory history;
    history.follow(frame_at(0.0, torn(0, 3, 0.0)));
    history.follow(frame_at(1.0, torn(0, 3, 0.0)));
    EXPECT_TRUE(words(history).empty());
}

TEST(TearHistory, GoesBackWithTheTimeAndForgetsWithTheTear) {
    TearHistory history;
    for (int i = 0; i < 10; ++i) history.follow(frame_at(i, torn(i > 5 ? 1 : 0, 1, 0.0)));
    EXPECT_EQ(words(history), std::vector<std::string>{"cut or torn"});
    history.follow(frame_at(3.0, torn(0, 1, 0.0)));
    EXPECT_EQ(history.chart().curves[0].x.back(), 3.0);
    EXPECT_EQ(history.chart().curves[0].x.size(), 4u);
    EXPECT_TRUE(history.follow(Frame{}));
    EXPECT_TRUE(history.empty());
    EXPECT_TRUE(history.events().empty());
}

TEST(TearHistory, ALongPlayKeepsItsEndsInFewPoints) {
    TearHistory history;
    const int frames = 3 * static_cast<int>(TearHistory::most_points);
    for (int i = 0; i <= frames; ++i) history.follow(frame_at(0.25 * i, torn(0, 1, 0.0)));
    const std::vector<double> x = history.chart().curves[0].x;
    EXPECT_LE(x.size(), TearHistory::most_points);
    EXPECT_GT(x.size(), TearHistory::most_points / 4);
    EXPECT_EQ(x.front(), 0.0);
    EXPECT_EQ(x.back(), 0.25 * frames);
    EXPECT_TRUE(std::ranges::is_sorted(x));
}

}  // namespace
}  // namespace hepatica
