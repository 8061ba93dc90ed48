// SPDX-License-Identifier: GPL-3.0-or-later
// The part of space that a patient can lie in. A number in a file that points beyond it is damage
// or a wrong unit, and arithmetic goes wrong there: at 1e21 mm neighbouring doubles are 131 m
// apart, so that a curve through such points never gets any longer.
#pragma once

#include <string>

#include "core/base/vector.h"

namespace hepatica {

// Ten metres: ten times what any scanner reaches, and 1e-12 mm between neighbouring doubles.
constexpr double farthest_mm = 10'000.0;

// Whether all coordinates lie within farthest_mm; false for NaN.
inline bool is_in_patient_space(const Vec3& position_mm) {
    return position_mm.cwiseAbs().maxCoeff() <= farthest_mm && position_mm.allFinite();
}

// Throws InputError that names `place`, what lies there and the offending value.
void require_in_patient_space(const Vec3& position_mm, const std::string& what,
                              const std::string& place);

// "X, Y, Z mm" to a tenth of a millimetre, for messages.
std::string place_text(const Vec3& position_mm);

}  // namespace hepatica
