// SPDX-License-Identifier: GPL-3.0-or-later
// Centrelines as curves: from the staircase of voxel centres to smooth points about a voxel apart.
#pragma once

#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Values along a curve averaged by a Gaussian over arclength, cut off at three deviations. Weights
// (one per point, 0 or more) let doubtful values count less; empty means all alike. Points at which
// the curve begins and ends keep their position if `ends_stay`.
std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points_mm, double deviation_mm,
                               bool ends_stay);
std::vector<double> smooth_values(const std::vector<Vec3>& points_mm,
                                  const std::vector<double>& values,
                                  const std::vector<double>& weights, double deviation_mm);

// The weighted median of the values within `reach_mm` along the curve: unlike a mean it does not
// follow the few sections that cut through a neighbour.
std::vector<double> median_values(const std::vector<Vec3>& points_mm,
                                  const std::vector<double>& values,
                                  const std::vector<double>& weights, double reach_mm);

// Distance along the curve from its first point to each point.
std::vector<double> arclengths_mm(const std::vector<Vec3>& points_mm);

// A curve with its radii resampled at even distances of about `step_mm`, ends included. A curve
// shorter than a step keeps its two ends. No point but the last equals the one before, also where
// the curve turns back on itself. Throws InputError where there would be more than ten
// million steps.
struct Centreline {
    std::vector<Vec3> points_mm;
    std::vector<double> radii_mm;
};
Centreline resampled(const Centreline& curve, double step_mm);

// Unit directions of the curve at its points, from the points within `reach_mm` on both sides.
std::vector<Vec3> tangents(const std::vector<Vec3>& points_mm, double reach_mm);

}  // namespace hepatica
