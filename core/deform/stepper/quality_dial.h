// SPDX-License-Identifier: GPL-3.0-or-later
// The dial between speed and accuracy. It keeps the Pareto front of settings whose cost and error
// were measured, and selects one of them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

// One setting with its measured cost and error.
struct QualityPoint {
    StepperOptions options;
    double frame_ms = 0.0;         // 95th percentile of the time of a frame of 1/60 s, > 0
    double error_relative = 0.0;   // relative error of the motion, >= 0
    std::string reference;         // the solution that the error is relative to
    std::string back_end = "cpu";  // the back end of the measurement
    std::string device{};          // name of its device; empty: the processor
};

// Thread safety: const access only.
class QualityDial {
  public:
    // Throws InputError where there is no measurement or a value is not finite or negative.
    explicit QualityDial(std::vector<QualityPoint> measured);

    // The Pareto front, cheapest first: cost rises and error falls along it.
    std::span<const QualityPoint> front() const { return front_; }

    // The most accurate point whose cost is at most c0 (c1 / c0)^quality, where c0 and c1 are the
    // smallest and largest cost. A quality outside [0, 1] counts as the nearest end.
    const QualityPoint& at(double quality) const { return front_[index_at(quality)]; }
    std::size_t index_at(double quality) const;

    // The quality at which `at` returns front()[index].
    double quality_of(std::size_t index) const;

  private:
    std::vector<QualityPoint> front_;
};

// Indices of the Pareto front of (cost, error), cheapest first; the first of equal points.
std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error);

}  // namespace hepatica
