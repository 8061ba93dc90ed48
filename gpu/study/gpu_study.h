// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a step on a device: measured there, or planned from what the emulator counts.
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
    int contacts = 0;  // not 0: also a body with about this many vertices touching an obstacle
    int steps = 10;
    std::optional<PlannedDevice> plan{};  // none: measured on the device of this computer
};

// Times are medians, everything else means over the steps. What a plan cannot know is empty.
struct GpuRow {
    int tetrahedra = 0;
    int contacts = 0;  // pairs of features within the pad at the end of the last step
    std::string element, solver;
    double ms = 0.0;
    double slowest_ms = 0.0;  // of the slowest step, where measured
    double iterations = 0.0;
    Traffic traffic;                 // of a step
    std::optional<double> solve_ms;  // of a step's linear solve
    std::optional<double>
        bandwidth_share;           // memory bandwidth of the solve relative to a plain kernel
    std::optional<double> cpu_ms;  // of the same step on all cores of this computer
    double device_steps = 0.0;     // share of steps made by the device
    bool measured = false;
};

// Studies a slender bar of bricks cut into tetrahedra, four cells across, clamped at one end,
// pulled and under gravity; with `contacts` also a slab resting on a block, solved with
// block-jacobi. Linear solves to an energy error of 1 %, in single precision. `row_done` receives
// each row. Throws InputError where there is no device to measure.
std::vector<GpuRow> study_gpu(const GpuStudyOptions& options,
                              const std::function<void(const GpuRow&)>& row_done = {});

// A text as a JSON string, in quotes. UTF-8 stays as it is.
std::string json_text(const std::string& text);

// A row as a JSON object.
std::string json_of(const GpuRow& row);

// The paper has 98,304 rows for 16,384 contact points.
constexpr int rows_per_contact = 6;

}  // namespace hepatica::gpu
