// SPDX-License-Identifier: GPL-3.0-or-later
// The dial: speed against accuracy as measured, not guessed. From settings with their measured cost
// and error it keeps the Pareto front and picks from it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

// One setting and what it was measured to cost and to miss.
struct QualityPoint {
    StepperOptions options;
    double frame_ms = 0.0;        // what 95 of 100 frames of 1/60 s take at most, > 0
    double error_relative = 0.0;  // of the motion, >= 0
    std::string reference;        // what that error was measured against
};

// Thread safety: const access only.
class QualityDial {
  public:
    // Throws InputError where nothing was measured or a value is not finite.
    explicit QualityDial(std::vector<QualityPoint> measured);

    // The points that no other beats in both cost and error, cheapest first: error falls along it.
    std::span<const QualityPoint> front() const { return front_; }

    // quality 0: the cheapest point; 1: the most accurate; in between the most accurate that costs
    // no more than the quality asks for, on a logarithmic scale. Values outside are clamped.
    const QualityPoint& at(double quality) const { return front_[index_at(quality)]; }
    std::size_t index_at(double quality) const;

    // The quality at which `at` returns front()[index].
    double quality_of(std::size_t index) const;

  private:
    std::vector<QualityPoint> front_;
};

// Indices of the Pareto front of (cost, error), cheapest first; of equals the first.
std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error);

}  // namespace hepatica
