// SPDX-License-Identifier: GPL-3.0-or-later
// What a step costs on a device: measured there, or planned from what the emulator counts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gpu/study/device_table.h"

namespace hepatica::gpu {

struct GpuStudyOptions {
    std::vector<int> tetrahedra{10000};
    std::vector<std::string> elements{"corotated"};
    std::vector<std::string> solvers{"block-jacobi", "skeleton"};
    int contacts = 0;  // not 0: also a body of which about so many vertices touch an obstacle
    int steps = 10;
    std::optional<PlannedDevice> plan{};  // none: measured on the device of this computer
};

// Means over the steps, times the median. What a plan cannot know is empty.
struct GpuRow {
    int tetrahedra = 0;
    int contacts = 0;  // pairs of features in their pad at the end of the last step
    std::string element, solver;
    double ms = 0.0;
    double slowest_ms = 0.0;  // of the steps, where they are measured
    double iterations = 0.0;
    Traffic traffic;                        // of a step
    std::optional<double> solve_ms;         // of a step's linear solve
    std::optional<double> bandwidth_share;  // that it reaches of a copy on the device
    std::optional<double> cpu_ms;           // of the same step on all cores of this computer
    double device_steps = 0.0;              // the share of steps that the device made
    bool measured = false;
};

// A slender bar of bricks cut into tetrahedra, four cells across, clamped at one end, pulled and
// under gravity; with `contacts` then a slab that rests on a block, by block-jacobi; linear error
// 1 %, single precision. `row_done` hears of each row. Throws InputError where there is no device
// to measure.
std::vector<GpuRow> study_gpu(const GpuStudyOptions& options,
                              const std::function<void(const GpuRow&)>& row_done = {});

// A row as an object of JSON.
std::string json_of(const GpuRow& row);

// The paper has 98,304 rows for 16,384 contact points.
constexpr int rows_per_contact = 6;

}  // namespace hepatica::gpu
