// SPDX-License-Identifier: GPL-3.0-or-later
// One typeface for every picture: DejaVu Sans where it is installed, else VTK's own Arial.
#pragma once

#include <array>

#include "render/palette.h"

class vtkRenderer;
class vtkTextActor;
class vtkTextProperty;

namespace hepatica {

// Sets typeface, size in pixels and colour, without bold, italics or shadow.
void style_text(vtkTextProperty& text, int size, const Colour& colour);

// The place nearest to `wanted`, in pixels, for the lower left corner of a text of this size, so
// that it lies within the picture.
std::array<double, 2> place_inside(const std::array<double, 2>& wanted,
                                   const std::array<double, 2>& size, vtkTextActor& text,
                                   vtkRenderer& renderer);

}  // namespace hepatica
