// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing and resampling of centrelines: from the staircase of voxel centres to smooth points
// about a voxel apart. All functions are thread-safe.
#pragma once

#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Gaussian averages over arc length, cut off at three standard deviations. In smooth_curve() the
// window shrinks towards the ends, and with `ends_stay` the end points keep their position. In
// smooth_values() `weights` (one per point, 0 or more) reduce the influence of doubtful values;
// empty: all equal. O(points times points in a window).
std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points_mm, double deviation_mm,
                               bool ends_stay);
std::vector<double> smooth_values(const std::vector<Vec3>& points_mm,
                                  const std::vector<double>& values,
                                  const std::vector<double>& weights, double deviation_mm);

// The weighted median of the values within `reach_mm` along the curve, with one weight per point.
// Unlike a mean it ignores the few sections that cut through a neighbouring vessel.
std::vector<double> median_values(const std::vector<Vec3>& points_mm,
                                  const std::vector<double>& values,
                                  const std::vector<double>& weights, double reach_mm);

// Arc length from the first point to each point.
std::vector<double> arclengths_mm(const std::vector<Vec3>& points_mm);

// A curve of two points or more resampled at even distances of about `step_mm` > 0, ends included,
// with linear radii. A curve shorter than a step keeps its two ends. No point but the last equals
// the one before, even where the curve turns back on itself. Throws InputError where there would be
// more than ten million steps.
struct Centreline {
    std::vector<Vec3> points_mm;
    std::vector<double> radii_mm;
};
Centreline resampled(const Centreline& curve, double step_mm);

// Unit tangents at the points, from chords between points `reach_mm` before and behind. Linear
// time.
std::vector<Vec3> tangents(const std::vector<Vec3>& points_mm, double reach_mm);

}  // namespace hepatica
