// SPDX-License-Identifier: GPL-3.0-or-later
// Converts pending strokes to and from JSON, and checks what is read.
#include "core/patient/pending_stroke.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/patient_space.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace {

PendingStroke pending_stroke_from(const nlohmann::json& value, const std::string& place) {
    PendingStroke pending;
    pending.stroke.path_mm = path_from(value.at("path_mm"));
    pending.stroke.radius_mm = value.at("radius_mm").get<double>();
    pending.stroke.erases = value.at("erases").get<bool>();
    pending.after_edits = whole_number<std::size_t>(value.at("after_edits"));
    if (pending.stroke.path_mm.empty())
        throw InputError("a brush is led nowhere", place, "Give one point or more in path_mm");
    if (!(pending.stroke.radius_mm > 0.0 && pending.stroke.radius_mm <= widest_brush_mm))
        throw InputError(
            "a brush has a radius of " + std::to_string(pending.stroke.radius_mm) + " mm", place,
            "Give a radius above 0 and up to 50 mm");
    for (const Vec3& point : pending.stroke.path_mm)
        require_in_patient_space(point, "a brush", place);
    return pending;
}

}  // namespace

std::string strokes_to_json(const std::vector<PendingStroke>& strokes) {
    nlohmann::json list = nlohmann::json::array();
    for (const PendingStroke& pending : strokes)
        list.push_back({{"path_mm", json_of(pending.stroke.path_mm)},
                        {"radius_mm", pending.stroke.radius_mm},
                        {"erases", pending.stroke.erases},
                        {"after_edits", pending.after_edits}});
    return list.dump();
}

std::vector<PendingStroke> strokes_from_json(const std::string& text, const std::string& place) {
    std::vector<PendingStroke> strokes;
    try {
        for (const nlohmann::json& value : nlohmann::json::parse(text))
            strokes.push_back(pending_stroke_from(value, place));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(json_problem(error), place,
                         "Give each stroke path_mm, radius_mm, erases and after_edits");
    }
    return strokes;
}

}  // namespace hepatica
