// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/projection.h"

#include <vtkCamera.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace hepatica {

ViewAxes axes_of(vtkCamera& camera) {
    const Vec3 forward(camera.GetDirectionOfProjection());
    const Vec3 right = forward.cross(Vec3(camera.GetViewUp())).normalized();
    return {right, right.cross(forward), forward, Vec3(camera.GetFocalPoint())};
}

Projection::Projection(vtkCamera& camera, int width, int height)
    : axes_(axes_of(camera)),
      eye_mm_(camera.GetPosition()),
      width_(width),
      height_(height),
      per_pixel_(2.0 * std::tan(0.5 * camera.GetViewAngle() * std::numbers::pi / 180.0) /
                 std::max(height, 1)) {}

ViewRay Projection::ray_through(const Pixel& pixel) const {
    const Vec3 direction = axes_.forward + per_pixel_ * (pixel.x - 0.5 * width_) * axes_.right -
                           per_pixel_ * (pixel.y - 0.5 * height_) * axes_.up;
    return {eye_mm_, direction.normalized()};
}

bool Projection::sees(const Vec3& position_mm) const {
    return (position_mm - eye_mm_).dot(axes_.forward) > 0.0;
}

Pixel Projection::pixel_of(const Vec3& position_mm) const {
    const Vec3 offset = position_mm - eye_mm_;
    const double per_pixel = per_pixel_ * offset.dot(axes_.forward);
    return {0.5 * width_ + offset.dot(axes_.right) / per_pixel,
            0.5 * height_ - offset.dot(axes_.up) / per_pixel};
}

Vec3 Projection::point_at_depth(const Pixel& pixel, const Vec3& depth_mm) const {
    const ViewRay ray = ray_through(pixel);
    const double along =
        (depth_mm - ray.origin_mm).dot(axes_.forward) / ray.direction.dot(axes_.forward);
    return ray.origin_mm + along * ray.direction;
}

}  // namespace hepatica
