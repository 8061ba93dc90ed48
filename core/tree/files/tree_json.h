// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the JSON of trees, edits and cases.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/vector.h"
#include "core/tree/system_summary.h"

namespace hepatica {

// Radii of drawn and of offered vessels. The files of trees hold none that is smaller (tree_io.h).
inline constexpr double thinnest_drawn_mm = 0.001, widest_drawn_mm = 50.0;

inline nlohmann::json json_of(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

inline nlohmann::json json_of(const std::vector<Vec3>& path) {
    nlohmann::json points = nlohmann::json::array();
    for (const Vec3& p : path) points.push_back(json_of(p));
    return points;
}

inline nlohmann::json json_of(const std::vector<SystemSummary>& systems) {
    nlohmann::json list = nlohmann::json::array();
    for (const SystemSummary& summary : systems) {
        nlohmann::json roots = nlohmann::json::array();
        for (const SystemRoot& root : summary.roots)
            roots.push_back({{"at_mm", json_of(root.at_mm)}, {"radius_mm", root.radius_mm}});
        list.push_back({{"system", name_of(summary.system)},
                        {"length_mm", summary.length_mm},
                        {"roots", std::move(roots)},
                        {"confidence", summary.confidence},
                        {"loops", summary.loops}});
    }
    return list;
}

// Reads an array of three numbers. Throws nlohmann::json::exception for anything else.
inline Vec3 vec3_from(const nlohmann::json& value) {
    if (value.is_array() && value.size() != 3)
        throw nlohmann::detail::type_error::create(
            302, "must be three numbers, but is a list of " + std::to_string(value.size()), &value);
    return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

inline std::vector<Vec3> path_from(const nlohmann::json& value) {
    std::vector<Vec3> path;
    for (const nlohmann::json& point : value) path.push_back(vec3_from(point));
    return path;
}

}  // namespace hepatica
