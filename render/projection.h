// SPDX-License-Identifier: GPL-3.0-or-later
// Perspective projection of a camera: from the pixels of a picture to viewing rays, and from points
// to pixels. It is a copy of the camera's state when it was constructed.
#pragma once

#include "core/base/vector.h"

class vtkCamera;

namespace hepatica {

// Device pixels from the upper left corner of the picture, y down.
struct Pixel {
    double x = 0.0;
    double y = 0.0;
};

// A ray from the eye through a pixel; `direction` has unit length.
struct ViewRay {
    Vec3 origin_mm = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
};

// The picture's directions, of unit length, and the camera's focal point.
struct ViewAxes {
    Vec3 right = Vec3::UnitX();
    Vec3 up = Vec3::UnitZ();
    Vec3 forward = Vec3::UnitY();  // away from the eye
    Vec3 focus_mm = Vec3::Zero();
};

ViewAxes axes_of(vtkCamera& camera);

class Projection {
  public:
    // `width`, `height`: size of the picture in pixels.
    Projection(vtkCamera& camera, int width, int height);

    ViewRay ray_through(const Pixel& pixel) const;
    // Whether it lies before the eye; other points have no pixel.
    bool sees(const Vec3& position_mm) const;
    Pixel pixel_of(const Vec3& position_mm) const;
    // The point under the pixel in the plane through `depth_mm` parallel to the picture.
    Vec3 point_at_depth(const Pixel& pixel, const Vec3& depth_mm) const;

  private:
    ViewAxes axes_;
    Vec3 eye_mm_;
    double width_, height_;
    double per_pixel_;  // size of a pixel at distance 1
};

}  // namespace hepatica
