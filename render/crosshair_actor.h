// SPDX-License-Identifier: GPL-3.0-or-later
// Three short lines along the patient's axes through the point where the slices cross.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>

#include "core/base/vector.h"

class vtkActor;

namespace hepatica {

class CrosshairActor {
  public:
    CrosshairActor();

    // None hides it. Returns true if the picture changed.
    bool show(const std::optional<Vec3>& position_mm);

    // Size of one screen point in device pixels.
    void set_pixel_ratio(double pixel_ratio);

    vtkActor* actor() const { return actor_; }

  private:
    std::optional<Vec3> shown_;
    vtkSmartPointer<vtkActor> actor_;
};

}  // namespace hepatica
