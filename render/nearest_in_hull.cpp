// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/nearest_in_hull.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hepatica {
namespace {

constexpr double tolerance_mm = 1e-3;
constexpr int most_steps = 1000;

}  // namespace

// Frank and Wolfe's method with pairwise steps (Lacoste-Julien and Jaggi 2015), which come nearer
// by a constant factor: weight goes from the point that pulls away most to the one that leads
// nearest.
Vec3 nearest_in_hull(std::span<const Vec3> points, const Vec3& place) {
    const auto nearest = std::ranges::min_element(
        points, {}, [&place](const Vec3& point) { return (point - place).squaredNorm(); });
    std::vector<double> weights(points.size(), 0.0);
    weights[static_cast<std::size_t>(nearest - points.begin())] = 1.0;
    Vec3 at = *nearest;
    for (int k = 0; k < most_steps; ++k) {
        const Vec3 away = at - place;
        if (away.norm() <= tolerance_mm) return place;
        std::size_t best = 0, worst = points.size();
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (away.dot(points[p]) < away.dot(points[best])) best = p;
            const bool is_used = weights[p] > 0.0;
            if (is_used &&
                (worst == points.size() || away.dot(points[p]) > away.dot(points[worst])))
                worst = p;
        }
        if (away.dot(at - points[best]) <= tolerance_mm * tolerance_mm || best == worst) break;
        const Vec3 way = points[best] - points[worst];
        const double share = std::min(weights[worst], -away.dot(way) / way.squaredNorm());
        weights[worst] -= share;
        weights[best] += share;
        at += share * way;
    }
    return at;
}

}  // namespace hepatica
