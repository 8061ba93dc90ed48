// SPDX-License-Identifier: GPL-3.0-or-later
// The dial between speed and accuracy. It keeps the Pareto front of settings whose cost and error
// were measured, and chooses one of them.
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
    std::string reference;         // the solution against which the error was measured
    std::string back_end = "cpu";  // that it was measured with, and the device that this is
    std::string device{};          // by its own name; empty: the processor
};

// Thread safety: const access only.
class QualityDial {
  public:
    // Throws InputError where nothing was measured or a value is not finite.
    explicit QualityDial(std::vector<QualityPoint> measured);

    // The Pareto front, the cheapest first: cost rises and error falls along it.
    std::span<const QualityPoint> front() const { return front_; }

    // The most accurate point whose cost is at most c0 (c1 / c0)^quality, where c0 and c1 are the
    // smallest and largest cost. quality is clamped to [0, 1].
    const QualityPoint& at(double quality) const { return front_[index_at(quality)]; }
    std::size_t index_at(double quality) const;

    // The quality at which `at` returns front()[index].
    double quality_of(std::size_t index) const;

  private:
    std::vector<QualityPoint> front_;
};

// Indices of the Pareto front of (cost, error), the cheapest first; of equal points the first.
std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error);

}  // namespace hepatica
