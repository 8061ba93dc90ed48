// SPDX-License-Identifier: GPL-3.0-or-later
// What the JSON files of trees and of edits have in common.
#pragma once

#include <nlohmann/json.hpp>

#include "core/base/vector.h"

namespace hepatica {

inline nlohmann::json json_of(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

// Throws nlohmann::json::exception where the value is not an array of three numbers.
inline Vec3 vec3_from(const nlohmann::json& value) {
    return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

}  // namespace hepatica
