// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/predicate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/lesson/metrics.h"

namespace hepatica {
namespace {

// 10,800 steps of 1/60 s are 180 s, though their sum is a little more.
TEST(Predicate, TheRoundingOfASumOfStepsBreaksNoBound) {
    double time_s = 0.0;
    for (int i = 0; i < 10800; ++i) time_s += 1.0 / 60.0;
    ASSERT_NE(time_s, 180.0);
    for (const bool at_least : {false, true})
        EXPECT_TRUE((Predicate{Quantity::time_s, -1, at_least, 180.0}.holds(time_s)));
    const Predicate most{Quantity::time_s, -1, false, 180.0};
    EXPECT_FALSE(most.holds(180.0 + 1.0 / 60.0));
    EXPECT_EQ(to_words_beside(most, time_s + 1.0 / 60.0), "180.02 s");
}

TEST(Predicate, TheTableStandsInTheOrderOfTheEnumeration) {
    std::set<std::string> names;
    int place = 0;
    for (const QuantityWords& words : quantities()) {
        EXPECT_EQ(static_cast<int>(words.quantity), place++);
        EXPECT_EQ(&words_of(words.quantity), &words);
        EXPECT_TRUE(names.insert(words.name).second) << words.name;
    }
    EXPECT_EQ(place, static_cast<int>(Quantity::touch_mm) + 1);
}

TEST(Predicate, HoldsAtItsBoundAndNotForWhatIsNotKnown) {
    const Predicate least{Quantity::time_s, -1, true, 2.0}, most{Quantity::time_s, -1, false, 2.0};
    EXPECT_TRUE(least.holds(2.0));
    EXPECT_FALSE(least.holds(1.999));
    EXPECT_TRUE(most.holds(2.0));
    EXPECT_FALSE(most.holds(2.001));
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(least.holds(unknown));
    EXPECT_FALSE(most.holds(unknown));
    EXPECT_EQ(least.worse(1.0, 3.0), 1.0);
    EXPECT_EQ(most.worse(1.0, 3.0), 3.0);
}

TEST(Predicate, SaysWhatItAsksFor) {
    const std::vector<std::string> marks{"the mark"};
    EXPECT_EQ(to_words({Quantity::force_mn, -1, false, 600.0}, marks), "force at most 600 mN");
    EXPECT_EQ(to_words({Quantity::moved_mm, 0, true, 10.0}, marks),
              "way moved by the mark at least 10 mm");
    EXPECT_EQ(to_words(Quantity::contacts, 3.0), "3");
    EXPECT_EQ(to_words(Quantity::moved_mm, 6.857e-7), "0 mm");
    EXPECT_EQ(to_words_beside({Quantity::force_mn, -1, false, 600.0}, 600.04), "600.04 mN");
    EXPECT_EQ(to_words_beside({Quantity::force_mn, -1, false, 600.0}, 712.449), "712.4 mN");
}

// Whatever can be asked for has a value, and its own one.
TEST(Metrics, EveryQuantityIsReadFromItsOwnPlace) {
    LessonMetrics metrics{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 16, 14, 15, 17};
    LessonMoment moment{21, 22, 23, 24, 25, 26, true, false, {{31, 32, 33}}};
    const auto value = [&](Quantity quantity, int mark = -1) {
        return value_of({quantity, mark, true, 0.0}, metrics, moment, 18.0);
    };
    EXPECT_EQ(value(Quantity::time_s), 1);
    EXPECT_EQ(value(Quantity::path_mm), 2);
    EXPECT_EQ(value(Quantity::peak_force_mn), 3);
    EXPECT_EQ(value(Quantity::impulse_mn_s), 4);
    EXPECT_EQ(value(Quantity::contacts), 5);
    EXPECT_EQ(value(Quantity::contact_s), 6);
    EXPECT_EQ(value(Quantity::largest_stretch), 7);
    EXPECT_EQ(value(Quantity::joints_broken), 8);
    EXPECT_EQ(value(Quantity::pieces_off), 9);
    EXPECT_EQ(value(Quantity::torn_area_mm2), 10);
    EXPECT_EQ(value(Quantity::blood_lost_g), 11);
    EXPECT_EQ(value(Quantity::injected_g), 12);
    EXPECT_EQ(value(Quantity::delivered_g), 16);
    EXPECT_EQ(value(Quantity::dose_target_g), 14);
    EXPECT_EQ(value(Quantity::dose_elsewhere_g), 15);
    EXPECT_EQ(value(Quantity::reflux_g), 17);
    EXPECT_EQ(value(Quantity::dose_target_share), 14.0 / 16.0);
    EXPECT_EQ(value(Quantity::step_time_s), 18);
    EXPECT_EQ(value(Quantity::force_mn), 21);
    EXPECT_EQ(value(Quantity::grip_mn), 22);
    EXPECT_EQ(value(Quantity::stretch), 23);
    EXPECT_EQ(value(Quantity::leak_g_s), 24);
    EXPECT_EQ(value(Quantity::target_filled), 25);
    EXPECT_EQ(value(Quantity::elsewhere_filled), 26);
    EXPECT_EQ(value(Quantity::drug_present), 1);
    EXPECT_EQ(value(Quantity::holding), 0);
    EXPECT_EQ(value(Quantity::distance_mm, 0), 31);
    EXPECT_EQ(value(Quantity::moved_mm, 0), 32);
    EXPECT_EQ(value(Quantity::touch_mm, 0), 33);
}

TEST(Metrics, AMarkThatThereIsNotHasNoValue) {
    LessonMoment moment;
    moment.marks = {{31, 32, 33}};
    for (const Quantity quantity : {Quantity::distance_mm, Quantity::moved_mm, Quantity::touch_mm})
        for (const int mark : {-1, 1})
            EXPECT_TRUE(std::isnan(value_of({quantity, mark, true, 0.0}, {}, moment, 0.0))) << mark;
}

TEST(Metrics, StandInJsonAndInATable) {
    LessonMetrics metrics;
    metrics.path_mm = 0.1;
    metrics.contacts = 2;
    const auto json = to_json(metrics);
    EXPECT_EQ(json["path_mm"], 0.1);
    EXPECT_EQ(json["contacts"], 2);
    EXPECT_EQ(nlohmann::ordered_json::parse(json.dump())["dose_target_share"], nullptr)
        << "a share of nothing";
    const std::string table = to_csv(metrics);
    EXPECT_EQ(table.substr(0, 18), "metric,value,unit\n");
    EXPECT_NE(table.find("path_mm,0.1,mm\n"), std::string::npos) << table;
    EXPECT_NE(table.find("dose_target_share,,\n"), std::string::npos) << table;
}

}  // namespace
}  // namespace hepatica
