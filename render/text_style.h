// SPDX-License-Identifier: GPL-3.0-or-later
// One typeface for every picture: DejaVu Sans where it is installed, else VTK's own Arial.
#pragma once

#include "render/palette.h"

class vtkRenderer;
class vtkTextActor;
class vtkTextProperty;

namespace hepatica {

// `size` in pixels.
void style_text(vtkTextProperty& text, int size, const Colour& colour);

// Puts the lower left corner of a text, whose position is given in pixels, there; or as near as all
// of it lies within the picture.
void stand_inside(vtkTextActor& text, vtkRenderer& renderer, double x, double y);

}  // namespace hepatica
