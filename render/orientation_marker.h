// SPDX-License-Identifier: GPL-3.0-or-later
// A small cube in the corner whose faces name the patient's directions: L left, R right, A
// anterior, P posterior, S superior, I inferior.
#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

#include "render/annotations.h"

class vtkCamera;
class vtkRenderWindow;

namespace hepatica {

// Uses a layer of its own over the window's first renderer; the window must outlive it.
class OrientationMarker {
  public:
    explicit OrientationMarker(vtkRenderWindow& window);
    ~OrientationMarker();

    // Turns the cube to match the camera and places it in the lower left corner.
    void update(vtkCamera& camera, const PictureSize& size);
    void set_visible(bool visible) { renderer_->SetDraw(visible); }
    // Distance of the cube from the picture's edge, and its right edge, in pixels.
    static double inset(const PictureSize& size);
    static double right_edge(const PictureSize& size);

  private:
    vtkRenderWindow& window_;
    vtkNew<vtkRenderer> renderer_;
};

}  // namespace hepatica
