// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of bridges (gap_bridging.h): gaps and branches alike.
#include <algorithm>

#include "core/base/error.h"
#include "core/base/json_problem.h"
#include "core/base/patient_space.h"
#include "core/tree/extraction/gap_bridging.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace {

void read_radii(const nlohmann::json& radii, const std::string& place, Bridge& bridge) {
    bridge.radii_mm = radii.get<std::vector<double>>();
    const bool fit = bridge.radii_mm.size() == bridge.path_mm.size() &&
                     std::ranges::all_of(bridge.radii_mm, [](double radius_mm) {
                         return radius_mm >= thinnest_drawn_mm && radius_mm <= widest_drawn_mm;
                     });
    if (!fit)
        throw InputError(
            "an offered branch does not have a radius from 0.001 to 50 mm for each of "
            "its points",
            place, "Reconstruct the patient again");
}

}  // namespace

std::string bridges_to_json(const std::vector<Bridge>& bridges) {
    nlohmann::json list = nlohmann::json::array();
    for (const Bridge& bridge : bridges) {
        list.push_back({{"confidence", bridge.confidence},
                        {"gap_mm", bridge.gap_mm},
                        {"from_radius_mm", bridge.from_radius_mm},
                        {"to_radius_mm", bridge.to_radius_mm},
                        {"built", bridge.built},
                        {"path_mm", json_of(bridge.path_mm)}});
        if (bridge.is_branch()) list.back()["radii_mm"] = bridge.radii_mm;
    }
    return list.dump(1);
}

std::vector<Bridge> bridges_from_json(const std::string& text, const std::string& place) {
    std::vector<Bridge> bridges;
    try {
        for (const nlohmann::json& value : nlohmann::json::parse(text)) {
            Bridge& bridge = bridges.emplace_back();
            bridge.confidence = value.at("confidence").get<double>();
            bridge.gap_mm = value.at("gap_mm").get<double>();
            bridge.from_radius_mm = value.at("from_radius_mm").get<double>();
            bridge.to_radius_mm = value.at("to_radius_mm").get<double>();
            bridge.built = value.at("built").get<bool>();
            bridge.path_mm = path_from(value.at("path_mm"));
            for (const Vec3& point : bridge.path_mm)
                require_in_patient_space(point, "a bridge", place);
            if (bridge.path_mm.size() < 2)
                throw InputError("a bridge has fewer than two points", place,
                                 "Reconstruct the patient again");
            if (value.contains("radii_mm")) read_radii(value["radii_mm"], place, bridge);
        }
    } catch (const nlohmann::json::exception& error) {
        throw InputError(json_problem(error), place, "Give a JSON array of bridges");
    }
    return bridges;
}

}  // namespace hepatica
