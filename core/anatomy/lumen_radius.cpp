// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anatomy/lumen_radius.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "core/anatomy/interpolation.h"

namespace hepatica {

namespace {

constexpr int rays = 24;

// Distance along a ray to where the mask falls below one half.
double ray_length_mm(const Mask& mask, const Vec3& point_mm, const Vec3& ray, double step_mm,
                     double reach_mm) {
    double before = interpolate(mask, point_mm);
    for (double t = step_mm; t < reach_mm; t += step_mm) {
        const double value = interpolate(mask, point_mm + t * ray);
        if (value < 0.5) return t - step_mm * (0.5 - value) / (before - value);
        before = value;
    }
    return reach_mm;
}

}  // namespace

CrossSection mask_cross_section(const Mask& mask, const Vec3& point_mm, const Vec3& direction,
                                double reach_mm) {
    CrossSection section;
    if (interpolate(mask, point_mm) < 0.5) return section;
    const Vec3 u = direction.unitOrthogonal();
    const Vec3 v = direction.cross(u);
    const double step_mm = 0.25 * mask.grid.spacing_mm.minCoeff();
    double area = 0.0, shortest = reach_mm, longest = 0.0;
    Vec3 moment = Vec3::Zero();
    for (int k = 0; k < rays; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / rays;
        const Vec3 ray = std::cos(angle) * u + std::sin(angle) * v;
        const double r = ray_length_mm(mask, point_mm, ray, step_mm, reach_mm);
        area += r * r / 2.0;
        moment += r * r * r / 3.0 * ray;
        shortest = std::min(shortest, r);
        longest = std::max(longest, r);
    }
    section.radius_mm = std::sqrt(2.0 * area / rays);
    section.offset_mm = moment / area;
    section.roundness = shortest / longest;
    return section;
}

}  // namespace hepatica
