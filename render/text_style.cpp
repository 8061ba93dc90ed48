// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/text_style.h"

#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace hepatica {
namespace {

constexpr const char* typeface = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

}  // namespace

void style_text(vtkTextProperty& text, int size, const Colour& colour) {
    std::error_code ignored;
    if (std::filesystem::exists(typeface, ignored)) {
        text.SetFontFamily(VTK_FONT_FILE);
        text.SetFontFile(typeface);
    } else {
        text.SetFontFamilyToArial();
    }
    text.SetFontSize(size);
    text.SetColor(colour[0], colour[1], colour[2]);
    text.SetBold(0);
    text.SetItalic(0);
    text.SetShadow(0);
}

std::array<double, 2> place_inside(const std::array<double, 2>& wanted,
                                   const std::array<double, 2>& size, vtkTextActor& text,
                                   vtkRenderer& renderer) {
    // Margin to the picture's edge, where a window may draw its frame: 4 pixels, 8 on a dense
    // screen.
    const double edge_pixels = 0.3 * text.GetTextProperty()->GetFontSize();
    const int* picture = renderer.GetSize();
    std::array<double, 2> place = wanted;
    for (int axis = 0; axis < 2; ++axis)
        place[axis] = std::clamp(place[axis], edge_pixels,
                                 std::max(edge_pixels, picture[axis] - size[axis] - edge_pixels));
    return place;
}

}  // namespace hepatica
