// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/measurement.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/patient_space.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format = "hepatica-measurements";
constexpr int version = 1;

constexpr const char* remedy =
    "Correct that value, or remove the file: the case is whole without it";

constexpr std::pair<MeasurementKind, const char*> names[] = {
    {MeasurementKind::distance, "distance"},
    {MeasurementKind::angle, "angle"},
    {MeasurementKind::diameter, "diameter"},
};

const char* name_of(MeasurementKind kind) {
    for (const auto& [known, name] : names)
        if (known == kind) return name;
    return "";
}

std::size_t points_of(MeasurementKind kind) {
    return kind == MeasurementKind::angle ? 3 : 2;
}

MeasurementKind kind_named(const std::string& wanted, const std::string& place) {
    for (const auto& [kind, name] : names)
        if (wanted == name) return kind;
    throw InputError("nothing measures a " + wanted, place, remedy);
}

KeptMeasurement measurement_from(const Json& value, const std::string& place) {
    KeptMeasurement measurement;
    measurement.kind = kind_named(value.at("kind").get<std::string>(), place);
    measurement.points_mm = path_from(value.at("points_mm"));
    if (const std::size_t points = points_of(measurement.kind);
        measurement.points_mm.size() != points)
        throw InputError("has " + std::to_string(measurement.points_mm.size()) +
                             " points_mm in place of " + std::to_string(points),
                         place, remedy);
    for (const Vec3& point : measurement.points_mm)
        if (!is_in_patient_space(point))
            throw InputError(
                "measures at " + place_text(point) + ", which is farther than 10 m from the origin",
                place, remedy);
    if (!value.contains("stenosis")) return measurement;
    const auto stenosis = value.at("stenosis").get<double>();
    if (!std::isfinite(stenosis) || stenosis > 1.0)
        throw InputError("has a stenosis of " + value.at("stenosis").dump() + ", which is above 1",
                         place, remedy);
    measurement.stenosis = stenosis;
    return measurement;
}

}  // namespace

std::string measurements_to_json(const std::vector<KeptMeasurement>& measurements) {
    Json list = Json::array();
    for (const KeptMeasurement& measurement : measurements) {
        Json value{{"kind", name_of(measurement.kind)},
                   {"points_mm", Json(json_of(measurement.points_mm))}};
        if (measurement.stenosis) value["stenosis"] = *measurement.stenosis;
        list.push_back(std::move(value));
    }
    const Json json{{"format", format}, {"version", version}, {"measurements", list}};
    return json.dump(1) + "\n";
}

std::vector<KeptMeasurement> measurements_from_json(const std::string& text,
                                                    const std::string& place) {
    try {
        const Json json = Json::parse(text);
        if (json.at("format") != format)
            throw InputError("has the format " + json.at("format").dump(), place, remedy);
        if (const int found = whole_number<int>(json.at("version")); found != version)
            throw InputError(
                "has version " + std::to_string(found) + "; this program reads version 1", place,
                "Take a newer program, or remove the file");
        std::vector<KeptMeasurement> measurements;
        for (const Json& value : json.at("measurements"))
            measurements.push_back(measurement_from(
                value, place + ", measurement " + std::to_string(measurements.size() + 1)));
        return measurements;
    } catch (const nlohmann::json::exception& error) {
        throw InputError(json_problem(error), place, remedy);
    }
}

}  // namespace hepatica
