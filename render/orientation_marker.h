// SPDX-License-Identifier: GPL-3.0-or-later
// A small cube in the corner whose faces say which way the patient lies: L left, R right, A front,
// P back, S head, I feet.
#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

#include "render/annotations.h"

class vtkCamera;
class vtkRenderWindow;

namespace hepatica {

// A layer of its own over the window's first renderer; the window must outlive it.
class OrientationMarker {
  public:
    explicit OrientationMarker(vtkRenderWindow& window);
    ~OrientationMarker();

    // Turns the cube as the camera looks.
    void update(vtkCamera& camera, const PictureSize& size);
    void set_visible(bool visible) { renderer_->SetDraw(visible); }
    // Of the cube in a picture of that size, in its pixels.
    static double inset(const PictureSize& size);
    static double right_edge(const PictureSize& size);

  private:
    vtkRenderWindow& window_;
    vtkNew<vtkRenderer> renderer_;
};

}  // namespace hepatica
