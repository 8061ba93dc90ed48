// SPDX-License-Identifier: GPL-3.0-or-later
// A position in patient coordinates as radiologists read it: distance to the left or right, back or
// front, head or feet from the origin of the CT.
#pragma once

#include <QString>

#include "core/base/vector.h"

namespace hepatica {

// "L 12  P 40  H 155 mm" for no decimals; the decimal separator is that of the language.
QString patient_place(const Vec3& position_mm, int decimals = 0);

}  // namespace hepatica
