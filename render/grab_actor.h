// SPDX-License-Identifier: GPL-3.0-or-later
// The pull as a line from the held point of the vessel to the mouse, with a bead where it holds.
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

    // Returns true if the picture is another now.
    bool update(const std::optional<GrabView>& grab);
    // Size of one screen point at the focal plane, so that line and bead look alike at any zoom.
    void set_scale(double mm_per_point);

    vtkActor* line() const { return line_; }
    vtkActor* point() const { return point_; }

  private:
    std::optional<GrabView> shown_;
    vtkSmartPointer<vtkLineSource> line_source_;
    vtkSmartPointer<vtkActor> line_;
    vtkSmartPointer<vtkActor> point_;
};

}  // namespace hepatica
