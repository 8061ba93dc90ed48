// SPDX-License-Identifier: GPL-3.0-or-later
// Cut lines that have not torn yet: where a weakened joint still holds, a dash on each edge of the
// surface, so that the line that was drawn stays in the picture.
#pragma once

#include <vtkSmartPointer.h>

#include <array>

#include "core/base/vector.h"
#include "core/scene/frame.h"

class vtkActor;
class vtkPolyData;

namespace hepatica {

// Belongs to one renderer; not thread-safe.
class WeakLineActor {
  public:
    WeakLineActor();

    // Returns true if the picture is another now.
    bool update(const Frame& frame);
    // Towards the eye, so that the surface, which is drawn rounded, does not cover it; and the
    // pixels of a point.
    void set_place(const Vec3& to_eye, double pixel_ratio);
    // The line, and a dark rim about it.
    std::array<vtkActor*, 2> actors() const { return {rim_, actor_}; }

  private:
    std::vector<float> shown_;  // ends of the dashes [mm]
    vtkSmartPointer<vtkPolyData> dashes_;
    vtkSmartPointer<vtkActor> actor_, rim_;
};

}  // namespace hepatica
