// SPDX-License-Identifier: GPL-3.0-or-later
// What a person measured on a patient, as it is kept with his case: measurements.json, which may be
// removed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

enum class MeasurementKind { distance, angle, diameter };

// In patient coordinates. A distance has two points, an angle three with its vertex between the
// others, a diameter two on the wall about the centreline.
struct KeptMeasurement {
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<Vec3> points_mm;
    // Of a diameter: by what share the lumen is narrower than expected (below 0: wider); nothing
    // where that is not known.
    std::optional<double> stenosis{};
    bool operator==(const KeptMeasurement&) const = default;
};

std::string measurements_to_json(const std::vector<KeptMeasurement>& measurements);

// Throws InputError that names `place`, the measurement and its value, and says what helps.
std::vector<KeptMeasurement> measurements_from_json(const std::string& text,
                                                    const std::string& place);

}  // namespace hepatica
