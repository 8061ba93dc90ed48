// SPDX-License-Identifier: GPL-3.0-or-later
// Cut lines that have not torn yet: a dash on each surface edge whose weakened joint still holds,
// so that the drawn line remains visible. A dash is a ribbon that faces the eye, as wide on the
// screen at any zoom, with a dark rim, because not every driver draws lines wider than a pixel.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <vector>

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
    // For the next picture: moves the dashes towards the eye, so that the rounded surface does not
    // cover them; and the size of a screen point at the focal plane.
    void set_place(const Vec3& to_eye, double mm_per_point);
    // The rim, and the line on it.
    std::array<vtkActor*, 2> actors() const { return {rim_.actor, line_.actor}; }

  private:
    struct Ribbons {
        vtkSmartPointer<vtkPolyData> quads;
        vtkSmartPointer<vtkActor> actor;
        void lay(const std::vector<float>& ends, const Vec3& to_eye, double wide_mm,
                 double lift_mm) const;
    };

    std::vector<float> shown_;  // ends of the dashes [mm]
    Ribbons rim_, line_;
};

}  // namespace hepatica
