// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/text_style.h"

#include <vtkTextProperty.h>

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

}  // namespace hepatica
