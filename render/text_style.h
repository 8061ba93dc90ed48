// SPDX-License-Identifier: GPL-3.0-or-later
// One typeface for every picture: DejaVu Sans where it is installed, else VTK's own Arial.
#pragma once

#include "render/palette.h"

class vtkRenderer;
class vtkTextActor;
class vtkTextProperty;

namespace hepatica {

// Sets typeface, size in pixels and colour, without bold, italics or shadow.
void style_text(vtkTextProperty& text, int size, const Colour& colour);

// Places the lower left corner of a text at (x, y) in pixels, or as near to it as the text fits
// into the picture. The text's position must be in display coordinates.
void stand_inside(vtkTextActor& text, vtkRenderer& renderer, double x, double y);

}  // namespace hepatica
