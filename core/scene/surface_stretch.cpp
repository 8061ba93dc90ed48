// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/surface_stretch.h"

#include <algorithm>
#include <cmath>

namespace hepatica {

namespace {

constexpr double least_area_mm2 = 1e-6;  // triangles below it are ignored

}  // namespace

void SurfaceStretch::take_surface(const Frame& frame) {
    surface_ = frame.surface;
    triangles_.clear();
    for (const std::array<int, 3>& t : *surface_) {
        const Vec3& p = rest_mm_[frame.origin_of(t[0])];
        const Vec3 e1 = rest_mm_[frame.origin_of(t[1])] - p;
        const Vec3 e2 = rest_mm_[frame.origin_of(t[2])] - p;
        const double area = 0.5 * e1.cross(e2).norm();
        Rest rest;
        if (area > least_area_mm2) {
            const double length = e1.norm();
            const double height = 2.0 * area / length;
            rest = {1.0 / length, -e1.dot(e2) / (length * length * height), 1.0 / height};
        }
        triangles_.push_back(rest);
    }
}

double SurfaceStretch::squared(std::size_t triangle, const Frame& frame) const {
    const Rest& rest = triangles_[triangle];
    const std::array<int, 3>& t = (*surface_)[triangle];
    const Vec3 p = frame.place_mm(t[0]);
    const Vec3 d1 = frame.place_mm(t[1]) - p, d2 = frame.place_mm(t[2]) - p;
    // Columns of F: images of the plane's orthonormal basis.
    const Vec3 f1 = rest.a * d1, f2 = rest.b * d1 + rest.c * d2;
    const double xx = f1.squaredNorm(), yy = f2.squaredNorm(), xy = f1.dot(f2);
    return 0.5 * (xx + yy + std::hypot(xx - yy, 2.0 * xy));
}

void SurfaceStretch::see(const Frame& frame) {
    if (frame.surface != surface_) take_surface(frame);
    double most = 1.0;
    for (std::size_t i = 0; i < triangles_.size(); ++i) most = std::max(most, squared(i, frame));
    largest_ = std::sqrt(most);
}

std::vector<float> SurfaceStretch::of_vertices(const Frame& frame) {
    if (frame.surface != surface_) take_surface(frame);
    std::vector<float> most(frame.positions_mm.size() / 3, 1.0f);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const auto stretch = static_cast<float>(std::sqrt(squared(i, frame)));
        for (const int v : (*surface_)[i]) most[v] = std::max(most[v], stretch);
    }
    return most;
}

}  // namespace hepatica
