// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/measured_dial.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/json_problem.h"
#include "core/scene/setting_json.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

// Version 1 was measured with a pull by three radii, and costs were medians; 2 without tension.
// Version 4 has points of a device, which programs that know 3 would take for the processor's.
constexpr int oldest_version = 3, device_version = 4;
const std::string processor = "cpu";
constexpr double most_error = 0.5;
constexpr const char* synthetic_reference =
    "a small synthetic patient, corotated in 8 substeps a frame, solved exactly, pulled by 30 mm "
    "in half a second and back (the mesh's own error is not in it)";

[[noreturn]] void refuse(const std::string& problem) {
    throw InputError(problem, "dial.json of the case",
                     "Measure again: hepatica-cli dial CASE --anew; or remove the file");
}

std::vector<QualityPoint> points_from(const Json& json) {
    std::vector<QualityPoint> points;
    const std::string reference = json.at("reference").get<std::string>();
    for (const Json& point : json.at("points"))
        points.push_back({setting_from_json(point.at("setting")),
                          point.at("frame_ms").get<double>(),
                          point.at("error_relative").get<double>(), reference,
                          point.value("back_end", processor), point.value("device", "")});
    return points;
}

StepperOptions in_substeps(int substeps) {
    StepperOptions options;
    options.substeps = substeps;
    return options;
}

}  // namespace

QualityDial built_in_dial(std::size_t tetrahedra) {
    // The front of the dial.json that these commands write to CASE:
    //     hepatica-cli phantom P --seed 2 --dims 128,128,96 --spacing 1.6,1.6,1.7 --generations 4
    //     hepatica-cli reconstruct P/ct --vessel-mask P/truth_mask.nii.gz --out CASE
    //         --tetrahedra 3000
    //     hepatica-cli dial CASE
    constexpr double measured_tetrahedra = 4616.0;
    const double size = static_cast<double>(tetrahedra) / measured_tetrahedra;
    return QualityDial({{in_substeps(1), 1.92 * size, 0.0214, synthetic_reference},
                        {in_substeps(2), 6.76 * size, 0.0172, synthetic_reference},
                        {in_substeps(3), 8.86 * size, 0.0144, synthetic_reference},
                        {in_substeps(4), 10.7 * size, 0.0135, synthetic_reference},
                        {in_substeps(8), 15.3 * size, 0.0134, synthetic_reference}});
}

bool is_of_own_body(const std::string& reference) {
    return reference != synthetic_reference;
}

std::vector<QualityPoint> measured_points(const PatientCase& patient) {
    if (patient.dial_json.empty()) return {};
    const Json json = Json::parse(patient.dial_json, nullptr, false);
    if (json.is_discarded() || !json.is_object()) refuse("is damaged");
    try {
        if (json.at("format") != "hepatica-dial" || json.at("version") > device_version)
            refuse("has another format or version");
        if (json.at("version") < oldest_version) return {};
        if (json.at("patient_hash") != to_hex(hash_of(patient))) return {};
        return points_from(json);
    } catch (const Json::exception& error) {
        refuse(json_problem(error));
    }
}

bool is_measured_with(const DeformBackEnd& back_end, const QualityPoint& point) {
    return point.back_end == back_end.name && point.device == back_end.device;
}

std::vector<QualityPoint> points_for(const DeformBackEnd& back_end,
                                     const std::vector<QualityPoint>& measured) {
    std::vector<QualityPoint> points;
    bool own = false;
    for (const QualityPoint& point : measured) {
        const bool here = is_measured_with(back_end, point);
        if (!here && !(back_end.beside_processor && point.back_end == processor)) continue;
        points.push_back(point);
        points.back().options.on_processor = !here;
        own = own || here;
    }
    return own ? points : std::vector<QualityPoint>();
}

std::string words_on_left_out(const DeformBackEnd& back_end,
                              const std::vector<QualityPoint>& measured) {
    for (const QualityPoint& point : measured)
        if (point.back_end != processor && !is_measured_with(back_end, point))
            return "Settings of the dial that were measured on " + point.device + " (" +
                   point.back_end + ") are left out: it does not make the steps here";
    return {};
}

QualityDial dial_of_points(std::vector<QualityPoint> points) {
    const auto good = [](const QualityPoint& point) { return point.error_relative <= most_error; };
    if (std::ranges::any_of(points, good))
        std::erase_if(points, [&](const QualityPoint& point) { return !good(point); });
    return QualityDial(std::move(points));
}

QualityDial dial_of(const PatientCase& patient, const DeformBackEnd& back_end) {
    std::vector<QualityPoint> points = points_for(back_end, measured_points(patient));
    return points.empty() ? built_in_dial(patient.mesh.tetrahedra.size())
                          : dial_of_points(std::move(points));
}

std::string dial_json(const std::vector<QualityPoint>& points, const PatientCase& patient) {
    const bool devices = std::ranges::any_of(
        points, [](const QualityPoint& point) { return point.back_end != processor; });
    Json json{{"format", "hepatica-dial"},
              {"version", devices ? device_version : oldest_version},
              {"patient_hash", to_hex(hash_of(patient))},
              {"reference", points.empty() ? "" : points.front().reference}};
    for (const QualityPoint& point : points) {
        Json one{{"setting", to_json(point.options)},
                 {"back_end", point.back_end},
                 {"frame_ms", point.frame_ms},
                 {"error_relative", point.error_relative}};
        if (!point.device.empty()) one["device"] = point.device;
        json["points"].push_back(std::move(one));
    }
    return json.dump(2) + "\n";
}

QualityDial dial_that_tears(const QualityDial& dial) {
    std::vector<QualityPoint> points;
    for (const QualityPoint& point : dial.front())
        if (point.options.order == ElementOrder::linear &&
            point.options.solver != LinearSolverKind::skeleton)
            points.push_back(point);
    if (points.empty())
        throw InputError("none of its settings can tear", "the dial",
                         "Measure it again, or play without tearing");
    return QualityDial(std::move(points));
}

}  // namespace hepatica
