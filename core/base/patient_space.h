// SPDX-License-Identifier: GPL-3.0-or-later
// The region of space in which a patient can lie. A position beyond it in a file indicates damage
// or a wrong unit, and arithmetic fails there: at 1e21 mm neighbouring doubles are 131 m apart, so
// that a curve through such points never gets longer.
#pragma once

#include <string>

#include "core/base/vector.h"

namespace hepatica {

// Ten metres: ten times the reach of any scanner, with about 1e-12 mm between neighbouring doubles.
constexpr double farthest_mm = 10'000.0;

// Whether all coordinates lie within farthest_mm; false for NaN.
inline bool is_in_patient_space(const Vec3& position_mm) {
    return position_mm.cwiseAbs().maxCoeff() <= farthest_mm && position_mm.allFinite();
}

// Throws InputError with `place`, `what` and the position, unless it is in patient space.
void require_in_patient_space(const Vec3& position_mm, const std::string& what,
                              const std::string& place);

// Throws InputError about `what` ("the point to hold") unless it is in patient space: what reaches
// a body from outside must lie where a body can be.
void require_reachable(const Vec3& position_mm, const std::string& what);

// "X, Y, Z mm" to a tenth of a millimetre, for messages.
std::string place_text(const Vec3& position_mm);

}  // namespace hepatica
