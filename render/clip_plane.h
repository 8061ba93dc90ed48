// SPDX-License-Identifier: GPL-3.0-or-later
// A plane that cuts the picture open: what lies in front of it is neither drawn nor picked.
#pragma once

#include "core/base/vector.h"

namespace hepatica {

struct ClipPlane {
    Vec3 point_mm = Vec3::Zero();
    Vec3 inward = Vec3::UnitY();  // unit length, towards the part that is drawn
};

}  // namespace hepatica
