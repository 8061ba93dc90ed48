// SPDX-License-Identifier: GPL-3.0-or-later
// A thin rim of the background's colour around each vessel, seen only where it passes in front of
// another: which of two crossing vessels is nearer. It is the surface's back drawn once more, a
// little wider: before the background it has the background's own colour, and the vessel itself
// covers the rest of it.
#pragma once

#include <vtkSmartPointer.h>

#include "core/base/vector.h"
#include "render/palette.h"

class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkPlane;
class vtkPolyData;

namespace hepatica {

// Belongs to one OpenGL context; not thread-safe.
class HaloActor {
  public:
    // Of a closed surface with outward normals, whose arrays on the card are shared with whoever
    // else draws it.
    explicit HaloActor(vtkPolyData& surface);

    // Its width in mm for each mm of depth, so that it is the same everywhere on the screen, and by
    // what it is moved away from the eye, so that a vessel has none on itself.
    void set_place(double mm_per_depth, const Vec3& behind_mm);
    // The colours of the background at the picture's upper and lower edge, and the picture's height
    // in pixels.
    void set_background(const Colour& top, const Colour& bottom, int height);
    void set_clip(vtkPlane* plane);

    vtkActor* actor() const { return actor_; }

  private:
    vtkSmartPointer<vtkOpenGLPolyDataMapper> mapper_;
    vtkSmartPointer<vtkActor> actor_;
};

}  // namespace hepatica
