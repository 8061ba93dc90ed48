// SPDX-License-Identifier: GPL-3.0-or-later
// What the JSON files of trees and of edits have in common.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

inline nlohmann::json json_of(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

inline nlohmann::json json_of(const std::vector<Vec3>& path) {
    nlohmann::json points = nlohmann::json::array();
    for (const Vec3& p : path) points.push_back(json_of(p));
    return points;
}

// Throws nlohmann::json::exception where the value is not an array of three numbers.
inline Vec3 vec3_from(const nlohmann::json& value) {
    return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

inline std::vector<Vec3> path_from(const nlohmann::json& value) {
    std::vector<Vec3> path;
    for (const nlohmann::json& point : value) path.push_back(vec3_from(point));
    return path;
}

}  // namespace hepatica
