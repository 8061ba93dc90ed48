// SPDX-License-Identifier: GPL-3.0-or-later
// Cut lines that have not torn yet: a dash on each surface edge whose weakened joint still holds,
// so that the drawn line remains visible.
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

    // Returns true if the picture changed.
    bool update(const Frame& frame);
    // Moves the dashes 1 mm towards the eye, so that the rounded surface does not cover them, and
    // sets the line width for the pixels of a point.
    void set_place(const Vec3& to_eye, double pixel_ratio);
    // The line, and a dark rim about it.
    std::array<vtkActor*, 2> actors() const { return {rim_, actor_}; }

  private:
    std::vector<float> shown_;  // ends of the dashes in mm
    vtkSmartPointer<vtkPolyData> dashes_;
    vtkSmartPointer<vtkActor> actor_, rim_;
};

}  // namespace hepatica
