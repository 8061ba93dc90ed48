// SPDX-License-Identifier: GPL-3.0-or-later
// A plane that opens the picture: what lies on its near side is neither drawn nor met by the mouse.
#pragma once

#include "core/base/vector.h"

namespace hepatica {

struct ClipPlane {
    Vec3 point_mm = Vec3::Zero();
    Vec3 inward = Vec3::UnitY();  // of unit length, into the part that is drawn
};

}  // namespace hepatica
