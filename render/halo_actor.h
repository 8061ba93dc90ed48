// SPDX-License-Identifier: GPL-3.0-or-later
// A thin rim of the background's colour around each vessel, visible only where it passes in front
// of another, so that one sees which of two crossing vessels is nearer. It is drawn as the back
// faces of the surface, moved outward along the normals: over the background it has the
// background's colour, and elsewhere the vessel itself covers it.
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
    // `surface` must be closed, with outward normals. Its arrays on the card are shared with other
    // actors that draw it.
    explicit HaloActor(vtkPolyData& surface);

    // `mm_per_depth`: width in mm for each mm of depth, which makes it constant on the screen.
    // `behind_mm`: shift away from the eye, so that a vessel casts no rim on itself.
    void set_place(double mm_per_depth, const Vec3& behind_mm);
    // The background's colours at the upper and lower edge of the picture, and the picture's height
    // in pixels.
    void set_background(const Colour& top, const Colour& bottom, int height);
    void set_clip(vtkPlane* plane);

    vtkActor* actor() const { return actor_; }

  private:
    vtkSmartPointer<vtkOpenGLPolyDataMapper> mapper_;
    vtkSmartPointer<vtkActor> actor_;
};

}  // namespace hepatica
