// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of the background and the text of the three-dimensional view.
#pragma once

#include "render/palette.h"

namespace hepatica {

struct ViewLook {
    Colour top{}, bottom{};  // upper and lower edge of the background
    Colour distance{};       // colour into which distant vessels fade
    Colour text{}, faint_text{};
    Colour measure = palette::measure;  // measurements
    bool bright_vessels = false;        // see palette::vessel_system()
    Colour tool = palette::tool;        // tools, and the line to what they are led to
};

inline constexpr ViewLook dark_look{palette::background_top, palette::background_bottom,
                                    palette::distance,       palette::text,
                                    palette::faint_text,     palette::measure};
inline constexpr ViewLook light_look{{0.93, 0.94, 0.96},
                                     {0.80, 0.83, 0.87},
                                     {0.86, 0.88, 0.91},
                                     {0.08, 0.10, 0.12},
                                     {0.27, 0.31, 0.36},
                                     {0.50, 0.22, 0.02},
                                     false,
                                     {0.30, 0.34, 0.39}};
inline constexpr ViewLook high_contrast_look{{0.0, 0.0, 0.0},
                                             {0.0, 0.0, 0.0},
                                             {0.0, 0.0, 0.0},
                                             {1.0, 1.0, 1.0},
                                             {1.0, 1.0, 1.0},
                                             palette::measure,
                                             true};

}  // namespace hepatica
