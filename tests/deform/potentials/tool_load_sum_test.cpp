// SPDX-License-Identifier: GPL-3.0-or-later
// The grip of jaws is what both of them press with.
#include "core/deform/potentials/tool_load_sum.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

// Two jaws, one above the other; opening by a millimetre moves each by half of one.
Tool jaws() {
    Tool tool = single_tool(Capsule{.centre_mm = Vec3(0, 0, 3), .radius_mm = 1.0});
    tool.parts.push_back(tool.parts.front());
    tool.parts[0].opens = Vec3(0, 0, 0.5);
    tool.parts[1].shape.centre_mm = Vec3(0, 0, -3);
    tool.parts[1].opens = Vec3(0, 0, -0.5);
    return tool;
}

// The vessel between them is pressed down by the upper jaw, up by the lower one.
PadContact pressed_by(int part, double force_un) {
    PadContact contact;
    contact.part = part;
    contact.force_un = force_un;
    contact.normal = Vec3(0, 0, part == 0 ? -1.0 : 1.0);
    contact.at_mm = Vec3(0, 0, part == 0 ? 2.0 : -2.0);
    return contact;
}

TEST(ToolLoadSum, AJawThatLeansOnAVesselAloneGripsNothing) {
    const Tool tool = jaws();
    for (const int part : {0, 1}) {
        ToolLoadSum sum(tool);
        sum.press(pressed_by(part, 80e3));
        EXPECT_EQ(sum.load().grip_un, 0.0);
        EXPECT_DOUBLE_EQ(sum.load().force_un.norm(), 80e3);
    }
}

TEST(ToolLoadSum, TheGripIsTheLesserOfBothNormalForces) {
    const Tool tool = jaws();
    ToolLoadSum sum(tool);
    sum.press(pressed_by(0, 80e3));
    sum.press(pressed_by(1, 50e3));
    EXPECT_DOUBLE_EQ(sum.load().grip_un, 50e3);
    sum.press(pressed_by(1, 60e3), 0.5);
    EXPECT_DOUBLE_EQ(sum.load().grip_un, 80e3);
}

// Pressed from outside, the jaws are pushed together: they hold nothing.
TEST(ToolLoadSum, WhatPressesFromOutsideIsNoGrip) {
    const Tool tool = jaws();
    ToolLoadSum sum(tool);
    for (const int part : {0, 1}) {
        PadContact contact = pressed_by(part, 10e3);
        contact.normal = -contact.normal;
        sum.press(contact);
    }
    EXPECT_EQ(sum.load().grip_un, 0.0);
}

TEST(ToolLoadSum, AToolWithoutJawsHasNoGrip) {
    const Tool tool = single_tool(Capsule{.centre_mm = Vec3(0, 0, 3), .radius_mm = 1.0});
    ToolLoadSum sum(tool);
    sum.press(pressed_by(0, 80e3));
    EXPECT_EQ(sum.load().grip_un, 0.0);
}

}  // namespace
}  // namespace hepatica
