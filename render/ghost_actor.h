// SPDX-License-Identifier: GPL-3.0-or-later
// An organ around its vessels, or a tumour among them: a translucent surface that does not move,
// more opaque at its outline than where it faces the eye, so that vessels remain visible through
// it.
#pragma once

#include <vtkSmartPointer.h>

#include "core/mesh/tet_mesh.h"
#include "render/palette.h"

class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkPlane;

namespace hepatica {

struct GhostLook {
    Colour colour{};
    double facing = 0.0;  // opacity where the surface faces the eye
    double rim = 0.0;     // added at the outline
};

inline constexpr GhostLook liver_ghost{palette::liver, 0.08, 0.45};
inline constexpr GhostLook tumour_ghost{palette::tumour, 0.35, 0.45};

class GhostActor {
  public:
    explicit GhostActor(const GhostLook& look);

    void set_surface(const TriangleMesh& surface);  // an empty one shows nothing
    void set_visible(bool visible);
    // Draws only the part on the plane's positive side; null draws all.
    void set_clip(vtkPlane* plane);
    bool shows() const { return visible_ && !empty_; }
    vtkActor* actor() const { return actor_; }

  private:
    void apply_visibility();

    vtkSmartPointer<vtkOpenGLPolyDataMapper> mapper_;
    vtkSmartPointer<vtkActor> actor_;
    bool visible_ = true;
    bool empty_ = true;
};

}  // namespace hepatica
