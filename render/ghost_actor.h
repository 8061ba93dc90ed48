// SPDX-License-Identifier: GPL-3.0-or-later
// The liver as a ghost around its vessels: a still, see-through surface whose rim shows and whose
// face does not hide what is inside.
#pragma once

#include <vtkSmartPointer.h>

#include "core/mesh/tet_mesh.h"

class vtkActor;

namespace hepatica {

class GhostActor {
  public:
    GhostActor();

    void set_surface(const TriangleMesh& surface);  // an empty one shows nothing
    void set_visible(bool visible);
    vtkActor* actor() const { return actor_; }

  private:
    void apply_visibility();

    vtkSmartPointer<vtkActor> actor_;
    bool visible_ = true;
    bool empty_ = true;
};

}  // namespace hepatica
