// SPDX-License-Identifier: GPL-3.0-or-later
// The liver around its vessels: a translucent surface that does not move, opaque at its outline and
// nearly clear where it faces the eye, so that it hides nothing.
#pragma once

#include <vtkSmartPointer.h>

#include "core/mesh/tet_mesh.h"

class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkPlane;

namespace hepatica {

class GhostActor {
  public:
    GhostActor();

    void set_surface(const TriangleMesh& surface);  // an empty one shows nothing
    void set_visible(bool visible);
    // Draws only what is on the plane's positive side; null: all.
    void set_clip(vtkPlane* plane);
    vtkActor* actor() const { return actor_; }

  private:
    void apply_visibility();

    vtkSmartPointer<vtkOpenGLPolyDataMapper> mapper_;
    vtkSmartPointer<vtkActor> actor_;
    bool visible_ = true;
    bool empty_ = true;
};

}  // namespace hepatica
