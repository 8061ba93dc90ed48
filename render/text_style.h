// SPDX-License-Identifier: GPL-3.0-or-later
// One typeface for every picture: DejaVu Sans where it is installed, else VTK's own Arial.
#pragma once

#include "render/palette.h"

class vtkTextProperty;

namespace hepatica {

// `size` in pixels.
void style_text(vtkTextProperty& text, int size, const Colour& colour);

}  // namespace hepatica
