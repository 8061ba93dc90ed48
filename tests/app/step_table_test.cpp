// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/step_table.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(StepTable, HasALineAStepAndKeepsAMessageInItsField) {
    StepTable table;
    SessionStep step;
    step.step = 7;
    step.deform.newton_iterations = 2;
    step.deform.linear_solves = 3;
    step.deform.linear_iterations = 4;
    step.deform.tear.joints_parted = 5;
    step.deform.tear.joints_broken = 1;
    step.deform.tear.vertices_split = 6;
    step.deform.degraded = true;
    step.deform.message = "it said \"stop\",\nand did";
    table.add(step, {.wall_ms = 12.5, .processor_ms = 20.0});
    table.add({}, {});
    EXPECT_EQ(table.text(),
              "step,wall_ms,processor_ms,newton_iterations,solves,iterations,joints_parted,"
              "joints_broken,vertices_split,asleep,degraded,message\n"
              "7,12.5,20,2,3,4,5,1,6,0,1,\"it said 'stop', and did\"\n"
              "0,0,0,0,0,0,0,0,0,0,0,\"\"\n");
}

}  // namespace
}  // namespace hepatica
