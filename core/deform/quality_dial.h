// SPDX-License-Identifier: GPL-3.0-or-later
// The dial: speed against accuracy as measured, not guessed. From settings with their measured cost
// and error it keeps the Pareto front and picks from it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/deform/cpu_stepper.h"

namespace hepatica {

// One setting and what it was measured to cost and to miss.
struct QualityPoint {
    StepperOptions options;
    double frame_ms = 0.0;        // wall time for 1/60 s of simulated time, > 0
    double error_relative = 0.0;  // of the displacement at rest, >= 0
    std::string reference;        // what that error was measured against
};

// Thread safety: const access only.
class QualityDial {
  public:
    // Throws InputError where nothing was measured or a value is not finite.
    explicit QualityDial(std::vector<QualityPoint> measured);

    // The points that no other beats in both cost and error, cheapest first: error falls along it.
    std::span<const QualityPoint> front() const { return front_; }

    // The most accurate point whose frame fits the budget; the cheapest where none does.
    const QualityPoint& within(double frame_budget_ms) const;

    // quality 0: the cheapest point; 1: the most accurate; in between by the logarithm of the cost.
    // Values outside are clamped.
    const QualityPoint& at(double quality) const;

    // The quality at which `at` returns front()[index].
    double quality_of(std::size_t index) const;

  private:
    std::vector<QualityPoint> front_;
};

// Indices of the Pareto front of (cost, error), cheapest first; of equals the first.
std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error);

// Error of positions against a reference, root mean square over the vertices, relative to how far
// the reference has moved from rest.
double displacement_error(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                          std::span<const Vec3> rest_mm);

// Where a body of one's own comes to rest under gravity: the same mesh in quadratic order (linear
// for hexahedra), Newton's method and linear solves converged. One position per vertex. Throws
// InputError where nothing of the body is fixed: it would never rest.
std::vector<Vec3> converged_rest(const BodyDescription& body, const Vec3& gravity_mm_per_s2);

// Runs one setting for `frames` of 1/60 s under gravity from rest, damped enough to come to rest
// again; cost is the median frame, error is that of the last frame against converged_rest.
QualityPoint measure_quality(const BodyDescription& body, const StepperOptions& options, int frames,
                             const Vec3& gravity_mm_per_s2,
                             std::span<const Vec3> converged_rest_mm);

}  // namespace hepatica
