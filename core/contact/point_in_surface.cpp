// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/point_in_surface.h"

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

// Unlikely to be parallel to a mesh edge; the majority of the rays decides.
const std::array<Vec3, 3> rays{Vec3(0.5377, 0.8339, 0.1247), Vec3(-0.2259, 0.8622, -0.4534),
                               Vec3(0.3188, -0.4077, 0.8558)};

constexpr int majority = 2;

bool meets(const Box& box, const Vec3& from, const Vec3& ray) {
    double first = 0.0, last = INFINITY;
    for (int c = 0; c < 3; ++c) {
        const double a = (box.low[c] - from[c]) / ray[c], b = (box.high[c] - from[c]) / ray[c];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

// +1 where the ray leaves through the triangle, -1 where it enters, 0 where it misses it.
int crossing(const Triangle& x, const Vec3& from, const Vec3& ray) {
    const Vec3 a = x[0] - from, b = x[1] - from, c = x[2] - from;
    const double u = ray.dot(b.cross(c)), v = ray.dot(c.cross(a)), w = ray.dot(a.cross(b));
    const double side = a.dot((x[1] - x[0]).cross(x[2] - x[0]));
    if (u > 0.0 && v > 0.0 && w > 0.0 && side > 0.0) return 1;
    if (u < 0.0 && v < 0.0 && w < 0.0 && side < 0.0) return -1;
    return 0;
}

}  // namespace

bool lies_within(const Vec3& point, const SurfacePatches& surface, std::span<const int> patches,
                 std::span<const Box> boxes, std::span<const Vec3> positions_mm) {
    int votes = 0;
    for (const Vec3& ray : rays) {
        int leaves = 0;
        for (const int p : patches) {
            if (!meets(boxes[p], point, ray)) continue;
            for (const int t : surface.triangles_of(p))
                leaves += crossing(corners_of(surface.triangles()[t], positions_mm), point, ray);
        }
        votes += leaves > 0 ? 1 : -1;
        if (std::abs(votes) == majority) break;
    }
    return votes > 0;
}

std::vector<Box> boxes_of_patches(const SurfacePatches& surface,
                                  std::span<const Vec3> positions_mm) {
    std::vector<Box> boxes;
    for (std::size_t p = 0; p < surface.size(); ++p) boxes.push_back(surface.box(p, positions_mm));
    return boxes;
}

}  // namespace hepatica
