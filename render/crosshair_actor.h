// SPDX-License-Identifier: GPL-3.0-or-later
// Three short lines along the patient's axes through a point: where the slices cross.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>

#include "core/base/vector.h"

class vtkActor;

namespace hepatica {

class CrosshairActor {
  public:
    CrosshairActor();

    // Returns true if the picture is another now.
    bool show(const std::optional<Vec3>& position_mm);

    vtkActor* actor() const { return actor_; }

  private:
    std::optional<Vec3> shown_;
    vtkSmartPointer<vtkActor> actor_;
};

}  // namespace hepatica
