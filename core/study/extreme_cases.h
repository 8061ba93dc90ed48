// SPDX-License-Identifier: GPL-3.0-or-later
// The groups of rows of the stability suite; extremes.cpp combines them.
#pragma once

#include <vector>

#include "core/study/extremes.h"

namespace hepatica {

// A clamped beam over modulus, time step, Poisson's ratio and element.
void add_beam_grid(std::vector<ExtremeCase>& cases);
// Stiffness and density contrasts within a body; slivers; flat, inverted and crushed starts.
void add_contrast_and_shape_cases(std::vector<ExtremeCase>& cases);
// Grabs moved by a metre in one step; gravity x 1000.
void add_tool_cases(std::vector<ExtremeCase>& cases);
// A hand that jumps beyond obstacles.
void add_obstacle_cases(std::vector<ExtremeCase>& cases);
// 100,000 steps at rest, in free flight and spinning; free fall; overflow.
void add_long_runs(std::vector<ExtremeCase>& cases);
// Input that must be refused with an InputError: NaN, infinity, lone vertices, and values out of
// range.
void add_refusals(std::vector<ExtremeCase>& cases);

}  // namespace hepatica
