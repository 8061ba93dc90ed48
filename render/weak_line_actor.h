// SPDX-License-Identifier: GPL-3.0-or-later
// Cut lines that have not torn yet: where a weakened joint still holds, a dash on each edge of the
// surface, so that the line that was drawn stays in the picture. A dash is a ribbon that faces the
// eye, as wide on the screen at any zoom, with a dark rim: not every driver draws lines wider than
// a pixel.
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

    // Returns true if the picture is another now.
    bool update(const Frame& frame);
    // For the next picture: towards the eye, so that the surface, which is drawn rounded, does not
    // cover it; and the size of one screen point at the focal plane.
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
