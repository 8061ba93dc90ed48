// SPDX-License-Identifier: GPL-3.0-or-later
// The check and the text of positions.
#include "core/base/patient_space.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

#include "core/base/error.h"

namespace hepatica {

void require_in_patient_space(const Vec3& position_mm, const std::string& what,
                              const std::string& place) {
    if (is_in_patient_space(position_mm)) return;
    std::ostringstream problem;
    problem << "has " << what << " at " << position_mm.x() << ", " << position_mm.y() << ", "
            << position_mm.z() << " mm, which is farther than " << farthest_mm / 1000.0
            << " m from the origin of its coordinates";
    throw InputError(problem.str(), place,
                     "Check the unit of its positions and export it again in millimetres");
}

void require_reachable(const Vec3& position_mm, const std::string& what) {
    if (is_in_patient_space(position_mm)) return;
    throw InputError("is not within 10 m of the origin", what,
                     "Give numbers from -10000 to 10000 mm");
}

std::string place_text(const Vec3& position_mm) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(1);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const double tenths = std::round(10.0 * position_mm[axis]);
        text << (axis == 0 ? "" : ", ") << (tenths == 0.0 ? 0.0 : 0.1 * tenths);  // avoids "-0.0"
    }
    text << " mm";
    return text.str();
}

}  // namespace hepatica
