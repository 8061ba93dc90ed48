// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/measured_dial.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/scene/setting_json.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

constexpr int dial_version = 1;

[[noreturn]] void refuse(const std::string& problem) {
    throw InputError(problem, "dial.json of the case",
                     "Measure again: hepatica-cli tradeoff CASE --out FOLDER; or remove the file");
}

std::vector<QualityPoint> points_from(const Json& json) {
    std::vector<QualityPoint> points;
    const std::string reference = json.at("reference").get<std::string>();
    for (const Json& point : json.at("points"))
        points.push_back({setting_from_json(point.at("setting")),
                          point.at("frame_ms").get<double>(),
                          point.at("error_relative").get<double>(), reference});
    return points;
}

StepperOptions corotated(int substeps, ElementOrder order = ElementOrder::linear) {
    StepperOptions options;
    options.substeps = substeps;
    options.order = order;
    return options;
}

}  // namespace

QualityDial built_in_dial(std::size_t tetrahedra) {
    // The front of tradeoff.csv, written by
    //     hepatica-cli phantom FOLDER && hepatica-cli reconstruct FOLDER/ct.nii.gz --out CASE
    //     hepatica-cli tradeoff CASE --out FOLDER
    constexpr double measured_tetrahedra = 19673.0;
    const std::string reference = "the built-in patient";
    const double size = static_cast<double>(tetrahedra) / measured_tetrahedra;
    return QualityDial({{corotated(1), 20.0 * size, 0.3, reference},
                        {corotated(2), 40.0 * size, 0.25, reference}});
}

QualityDial dial_of(const PatientCase& patient) {
    if (patient.dial_json.empty()) return built_in_dial(patient.mesh.tetrahedra.size());
    const Json json = Json::parse(patient.dial_json, nullptr, false);
    if (json.is_discarded() || !json.is_object()) refuse("is damaged");
    try {
        if (json.at("format") != "hepatica-dial" || json.at("version") != dial_version)
            refuse("has another format or version");
        if (json.at("patient_hash") != to_hex(hash_of(patient)))
            return built_in_dial(patient.mesh.tetrahedra.size());
        return QualityDial(points_from(json));
    } catch (const Json::exception& error) {
        refuse(std::string("is damaged (") + error.what() + ")");
    }
}

std::string dial_json(const std::vector<QualityPoint>& points, const PatientCase& patient) {
    Json json{{"format", "hepatica-dial"},
              {"version", dial_version},
              {"patient_hash", to_hex(hash_of(patient))},
              {"reference", points.empty() ? "" : points.front().reference}};
    for (const QualityPoint& point : points)
        json["points"].push_back({{"setting", to_json(point.options)},
                                  {"frame_ms", point.frame_ms},
                                  {"error_relative", point.error_relative}});
    return json.dump(2) + "\n";
}

}  // namespace hepatica
