// SPDX-License-Identifier: GPL-3.0-or-later
// A pull, drawn as a line from the grabbed point of the vessel to its target under the mouse, with
// a small sphere at the target.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>

#include "core/scene/frame.h"

class vtkActor;
class vtkLineSource;

namespace hepatica {

class GrabActor {
  public:
    GrabActor();

    // None hides it. Returns true if the picture changed.
    bool update(const std::optional<GrabView>& grab);
    // Size of one screen point at the focal plane, so that the sphere has one size on the screen at
    // any zoom, and in device pixels.
    void set_scale(double mm_per_point, double pixel_ratio);

    vtkActor* line() const { return line_; }
    vtkActor* point() const { return point_; }

  private:
    std::optional<GrabView> shown_;
    vtkSmartPointer<vtkLineSource> line_source_;
    vtkSmartPointer<vtkActor> line_;
    vtkSmartPointer<vtkActor> point_;
};

}  // namespace hepatica
