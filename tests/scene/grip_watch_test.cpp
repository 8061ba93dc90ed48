// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of jaws that close and open: that they hold something, nothing, or no longer do.
#include "core/scene/grip_watch.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(GripWatch, TellsOfEachClosingAndOpeningOnce) {
    using enum GripWatch::Seen;
    GripWatch watch;
    ToolView jaws;
    jaws.opening_mm = 12.0;
    EXPECT_EQ(watch.see(jaws, false), nothing_new);
    jaws.opening_mm = 3.0;  // on their way
    EXPECT_EQ(watch.see(jaws, true), nothing_new);
    jaws.opening_mm = 0.0;
    EXPECT_EQ(watch.see(jaws, true), closed_on_nothing);
    EXPECT_EQ(watch.see(jaws, true), nothing_new);
    jaws.opening_mm = 12.0;
    EXPECT_EQ(watch.see(jaws, false), opened);
    EXPECT_EQ(watch.see(jaws, false), nothing_new);
    jaws = {};
    jaws.opening_mm = 2.0;  // a vessel between them
    jaws.grip_un = 5e4;
    EXPECT_EQ(watch.see(jaws, true), closed_on_something);
    jaws.grip_un = 0.0;  // for a step
    EXPECT_EQ(watch.see(jaws, true), nothing_new) << "they have not met";
    jaws.grip_un = 5e4;
    EXPECT_EQ(watch.see(jaws, true), nothing_new);
    jaws.grip_un = 0.0;
    jaws.opening_mm = 0.0;
    EXPECT_EQ(watch.see(jaws, true), slipped);
    EXPECT_EQ(watch.see(jaws, true), nothing_new);
    jaws.opening_mm = 2.0;  // let go by the hand
    EXPECT_EQ(watch.see(jaws, false), opened);
}

}  // namespace
}  // namespace hepatica
