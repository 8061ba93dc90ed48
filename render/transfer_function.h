// SPDX-License-Identifier: GPL-3.0-or-later
// From Hounsfield units to colour and opacity, by which a CT is drawn as a volume. Opacity follows
// the grey window of the slices. Colours are those of the tissue and stay where they are: fat,
// liver brown-red, enhanced blood reddish, bone ivory; a maximum intensity is grey.
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

// Between its points linear, beyond them as at the nearest. Hounsfield units rise from point to
// point, and opacity never falls; it rises with the density, whose values outside of [0, 1] are
// clamped. Of the room's look depend the greys alone: the brighter, the nearer to its writing.
std::vector<TransferPoint> transfer_function(const VolumeLook& look, const ViewLook& room);

struct GradientPoint {
    double hu_per_mm = 0.0;
    double share = 0.0;  // of the opacity, 0 to 1
};

// What is left of the opacity where Hounsfield units hardly change: of an organ its surface is
// seen, its inside and the noise in it hardly. Linear as above, rising. Not for a maximum
// intensity.
std::vector<GradientPoint> gradient_function();

}  // namespace hepatica
