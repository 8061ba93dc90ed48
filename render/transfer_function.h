// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer function from Hounsfield units to colour and opacity, by which a CT is rendered as a
// volume. Opacity follows the grey window of the slices. Colours are fixed per tissue (fat
// yellowish, liver brown-red, enhanced blood reddish, bone ivory); a maximum intensity projection
// is grey.
#pragma once

#include <vector>

#include "render/palette.h"
#include "render/view_look.h"
#include "render/volume_look.h"

namespace hepatica {

struct TransferPoint {
    double hu = 0.0;
    double opacity = 0.0;  // 0 to 1, of one millimetre; of the whole ray for a maximum intensity
    Colour colour{};
};

// Piecewise linear, constant beyond the first and last point. Hounsfield units ascend; opacity
// never falls, and rises with the density, which is clamped to [0, 1]. `room` determines the greys
// alone, which range from its background to its text colour.
std::vector<TransferPoint> transfer_function(const VolumeLook& look, const ViewLook& room);

struct GradientPoint {
    double hu_per_mm = 0.0;
    double share = 0.0;  // factor of the opacity, 0 to 1
};

// Factor of the opacity by the gradient. It suppresses regions where Hounsfield units hardly
// change, so that of an organ the surface is seen, and hardly its inside and the noise in it.
// Piecewise linear, ascending. Not for a maximum intensity projection.
std::vector<GradientPoint> gradient_function();

}  // namespace hepatica
