// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/vascular_system.h"

#include <gtest/gtest.h>

#include <set>

namespace hepatica {
namespace {

TEST(VascularSystem, NumbersAndNamesLeadBackToTheSystem) {
    std::set<std::string> names, titles;
    for (const VascularSystem system : vascular_systems) {
        EXPECT_EQ(system_numbered(number_of(system)), system);
        EXPECT_EQ(system_named(name_of(system)), system);
        EXPECT_EQ(system_named(std::to_string(number_of(system))), system);
        EXPECT_NE(list_of_systems().find(name_of(system)), std::string::npos);
        names.insert(name_of(system));
        titles.insert(title_of(system));
    }
    EXPECT_EQ(names.size(), vascular_systems.size());
    EXPECT_EQ(titles.size(), vascular_systems.size());
}

// Masks and files of other programs are read by these numbers.
TEST(VascularSystem, TheNumbersStayWhatTheyAre) {
    EXPECT_EQ(system_numbered(1), VascularSystem::portal);
    EXPECT_EQ(system_numbered(2), VascularSystem::hepatic);
    EXPECT_EQ(system_numbered(3), VascularSystem::artery);
    EXPECT_EQ(system_numbered(255), VascularSystem::unknown);
    for (const int number : {-1, 0, 4, 254, 256, 257}) EXPECT_FALSE(system_numbered(number));
    for (const char* text : {"", "0", "4", "Portal", "portal ", "1.0"})
        EXPECT_FALSE(system_named(text)) << text;
}

TEST(VascularSystem, WhatNobodyNamedIsUnknown) {
    EXPECT_EQ(VesselSeed{}.system, VascularSystem::unknown);
}

}  // namespace
}  // namespace hepatica
