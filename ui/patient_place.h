// SPDX-License-Identifier: GPL-3.0-or-later
// A place in the patient as radiologists read it: how far to his left or right, back or front, head
// or feet, from the origin of the CT.
#pragma once

#include <QString>

#include "core/base/vector.h"

namespace hepatica {

// "L 12  P 40  H 155 mm", as the slices say it.
QString patient_place(const Vec3& position_mm);

}  // namespace hepatica
