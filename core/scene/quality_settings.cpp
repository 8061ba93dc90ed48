// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/quality_settings.h"

#include <string>

#include "core/base/error.h"

namespace hepatica {

namespace {

// Rows "corotated, 1080 elements" of tradeoff.csv, written by
//     hepatica-cli tradeoff --quick --out FOLDER
// Columns frame_ms and motion_error_relative; others of this mesh are beaten by these. Quadratic
// elements miss less but are no setting of the play: they multiply a patient's nodes by eight.
std::vector<QualityPoint> measured() {
    const std::string reference =
        "the first half second of a clamped beam's fall, quadratic elements, 32 substeps a frame";
    StepperOptions fastest;
    fastest.solver = LinearSolverKind::block_jacobi;
    fastest.linear = {.energy_tolerance = 0.0, .max_iterations = 5};
    const StepperOptions usual;
    StepperOptions finest;
    finest.substeps = 4;
    return {{fastest, 0.251465, 0.827917, reference},
            {usual, 0.294379, 0.357714, reference},
            {finest, 1.34292, 0.33573, reference}};
}

}  // namespace

const QualityPoint& quality_point(double quality) {
    if (!(quality >= 0.0 && quality <= 1.0))
        throw InputError("is " + std::to_string(quality), "quality", "Choose a value from 0 to 1");
    static const QualityDial dial(measured());
    return dial.at(quality);
}

}  // namespace hepatica
