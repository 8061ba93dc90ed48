// SPDX-License-Identifier: GPL-3.0-or-later
// Implements Gaussian smoothing, weighted medians, resampling and tangents along a curve.
#include "core/tree/extraction/centreline.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr double most_pieces = 1e7;  // a whole vascular system has some 1e5

// Calls visit(j, weight) for the points j within reach_mm of point i along the curve, with Gaussian
// weights.
template <class Visit>
void visit_window(const std::vector<double>& at_mm, std::size_t i, double reach_mm,
                  double deviation_mm, const Visit& visit) {
    std::size_t first = i;
    while (first > 0 && at_mm[i] - at_mm[first - 1] <= reach_mm) --first;
    for (std::size_t j = first; j < at_mm.size() && at_mm[j] - at_mm[i] <= reach_mm; ++j) {
        const double t = (at_mm[j] - at_mm[i]) / deviation_mm;
        visit(j, std::exp(-0.5 * t * t));
    }
}

}  // namespace

std::vector<double> arclengths_mm(const std::vector<Vec3>& points_mm) {
    std::vector<double> at(points_mm.size(), 0.0);
    for (std::size_t i = 1; i < at.size(); ++i)
        at[i] = at[i - 1] + (points_mm[i] - points_mm[i - 1]).norm();
    return at;
}

std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points_mm, double deviation_mm,
                               bool ends_stay) {
    if (points_mm.size() < 3 || deviation_mm <= 0.0) return points_mm;
    const std::vector<double> at = arclengths_mm(points_mm);
    std::vector<Vec3> smooth(points_mm.size());
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        // The window is symmetric and shrinks towards the ends, so that the curve keeps its length.
        const double reach = std::min({3.0 * deviation_mm, at[i], at.back() - at[i]});
        Vec3 sum = Vec3::Zero();
        double weights = 0.0;
        visit_window(at, i, reach + 1e-9, deviation_mm, [&](std::size_t j, double weight) {
            sum += weight * points_mm[j];
            weights += weight;
        });
        smooth[i] = sum / weights;
    }
    if (ends_stay) {
        smooth.front() = points_mm.front();
        smooth.back() = points_mm.back();
    }
    return smooth;
}

std::vector<double> smooth_values(const std::vector<Vec3>& points_mm,
                                  const std::vector<double>& values,
                                  const std::vector<double>& weights, double deviation_mm) {
    const std::vector<double> at = arclengths_mm(points_mm);
    std::vector<double> smooth(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        double sum = 0.0, total = 0.0;
        visit_window(at, i, 3.0 * deviation_mm, deviation_mm, [&](std::size_t j, double weight) {
            if (!weights.empty()) weight *= weights[j];
            sum += weight * values[j];
            total += weight;
        });
        smooth[i] = total > 0.0 ? sum / total : values[i];
    }
    return smooth;
}

std::vector<double> median_values(const std::vector<Vec3>& points_mm,
                                  const std::vector<double>& values,
                                  const std::vector<double>& weights, double reach_mm) {
    const std::vector<double> at = arclengths_mm(points_mm);
    std::vector<double> medians(values.size());
    std::vector<std::pair<double, double>> window;  // value, weight
    for (std::size_t i = 0; i < values.size(); ++i) {
        window.clear();
        double total = 0.0;
        visit_window(at, i, reach_mm, reach_mm, [&](std::size_t j, double) {
            window.emplace_back(values[j], weights[j]);
            total += weights[j];
        });
        std::ranges::sort(window);
        double below = 0.0;
        for (const auto& [value, weight] : window) {
            medians[i] = value;
            below += weight;
            if (below >= 0.5 * total) break;
        }
    }
    return medians;
}

namespace {

int piece_count(double length_mm, double step_mm) {
    const double pieces = std::round(length_mm / step_mm);
    if (pieces <= most_pieces) return std::max(1, static_cast<int>(pieces));
    std::ostringstream problem;
    problem << "is " << length_mm << " mm long, more than " << most_pieces << " steps of "
            << step_mm << " mm";
    throw InputError(problem.str(), "a vessel", "Check the unit of the positions: millimetres");
}

}  // namespace

Centreline resampled(const Centreline& curve, double step_mm) {
    const std::vector<double> at = arclengths_mm(curve.points_mm);
    const int pieces = piece_count(at.back(), step_mm);
    Centreline even;
    std::size_t i = 0;
    for (int k = 0; k <= pieces; ++k) {
        const double wanted = at.back() * k / pieces;
        while (i + 2 < at.size() && at[i + 1] < wanted) ++i;
        const double gap = at[i + 1] - at[i];
        const double share = gap > 0.0 ? std::clamp((wanted - at[i]) / gap, 0.0, 1.0) : 0.0;
        const Vec3 place =
            curve.points_mm[i] + share * (curve.points_mm[i + 1] - curve.points_mm[i]);
        // Where the curve turns back on itself, a step can end where it began.
        if (k > 0 && k < pieces && place == even.points_mm.back()) continue;
        even.points_mm.push_back(place);
        even.radii_mm.push_back(curve.radii_mm[i] +
                                share * (curve.radii_mm[i + 1] - curve.radii_mm[i]));
    }
    even.points_mm.front() = curve.points_mm.front();
    even.points_mm.back() = curve.points_mm.back();
    // The last step, too, can end where it began; the end stays.
    const std::size_t count = even.points_mm.size();
    if (count > 2 && even.points_mm[count - 1] == even.points_mm[count - 2]) {
        even.points_mm.erase(even.points_mm.end() - 2);
        even.radii_mm.erase(even.radii_mm.end() - 2);
    }
    return even;
}

std::vector<Vec3> tangents(const std::vector<Vec3>& points_mm, double reach_mm) {
    const std::vector<double> at = arclengths_mm(points_mm);
    std::vector<Vec3> found(points_mm.size());
    // Both only grow with i, so that the time is linear.
    std::size_t first = 0, last = 0;
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        last = std::max(last, i);
        while (first + 1 <= i && at[i] - at[first + 1] >= reach_mm) ++first;
        while (last + 1 < at.size() && at[last] - at[i] < reach_mm) ++last;
        const Vec3 chord = points_mm[last] - points_mm[first];
        found[i] = chord.norm() > 0.0 ? Vec3(chord.normalized()) : Vec3(0, 0, 1);
    }
    return found;
}

}  // namespace hepatica
