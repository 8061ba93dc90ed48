// SPDX-License-Identifier: GPL-3.0-or-later
// The groups of the stability suite; extremes.cpp puts them together.
#pragma once

#include <vector>

#include "core/study/extremes.h"

namespace hepatica {

// A clamped beam over modulus, step, Poisson's ratio and element.
void add_beam_grid(std::vector<ExtremeCase>& cases);
// Stiffness and density contrasts within a body; slivers; flat, inverted and crushed starts.
void add_contrast_and_shape_cases(std::vector<ExtremeCase>& cases);
// Grabs moved a metre in one step, gravity x 1000.
void add_tool_cases(std::vector<ExtremeCase>& cases);
// A hand that jumps beyond obstacles.
void add_obstacle_cases(std::vector<ExtremeCase>& cases);
// 100,000 steps at rest and in free flight.
void add_long_runs(std::vector<ExtremeCase>& cases);
// What must be refused by name: NaN, infinity, lone vertices, and values out of range.
void add_refusals(std::vector<ExtremeCase>& cases);

}  // namespace hepatica
