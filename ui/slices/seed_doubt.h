// SPDX-License-Identifier: GPL-3.0-or-later
// What speaks against a seed that was set in the slices. It is told and never refused: who sets a
// seed may know better. No widgets.
#pragma once

#include <QString>

#include "core/image/mask.h"
#include "core/image/volume.h"

namespace hepatica {

// In the window's language; empty: nothing. A vessel with contrast has 80 to 500 HU, here in the
// mean of 27 voxels, and lies no farther from the liver than lies_far_outside() says. `organs`: of
// the case (organ_label); without a liver among them nothing is said of that.
QString doubt_of_seed(const Vec3& position_mm, const Volume& ct, const Mask& organs);

}  // namespace hepatica
