// SPDX-License-Identifier: GPL-3.0-or-later
// Places that a lesson speaks of, as translucent balls of one size on the screen, through which the
// vessel is seen.
#pragma once

#include <vtkSmartPointer.h>

#include <vector>

#include "core/base/vector.h"

class vtkActor;
class vtkRenderer;

namespace hepatica {

class MarkActors {
  public:
    // The renderer must outlive it.
    explicit MarkActors(vtkRenderer& renderer) : renderer_(renderer) {}

    // Returns true if the picture is another now.
    bool update(const std::vector<Vec3>& places_mm);
    // Size of one screen point at the focal plane.
    void set_scale(double mm_per_point);

  private:
    vtkRenderer& renderer_;
    std::vector<Vec3> shown_;
    std::vector<vtkSmartPointer<vtkActor>> balls_;
};

}  // namespace hepatica
