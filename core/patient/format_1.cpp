// SPDX-License-Identifier: GPL-3.0-or-later
// Converts parameters, edits and labels of format 1.
#include "core/patient/format_1.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/json_number.h"

namespace hepatica {

namespace {

using Json = nlohmann::ordered_json;

VascularSystem system_of(int number, bool seeded) {
    if (seeded) return system_numbered(number).value_or(VascularSystem::unknown);
    if (number == 1) return VascularSystem::hepatic;
    if (number == 2) return VascularSystem::artery;
    return VascularSystem::unknown;
}

}  // namespace

std::string parameters_of_format_1(const std::string& parameters_json) {
    Json parameters = Json::parse(parameters_json);
    for (const char* mask : {"liver_mask", "vessel_mask"}) {
        if (!parameters.contains(mask)) continue;
        parameters[std::string(mask) + "_given"] = parameters[mask] != "";
        parameters.erase(mask);
    }
    if (parameters.contains("seeds"))
        for (Json& seed : parameters["seeds"])
            seed["system"] = name_of(system_of(whole_number<int>(seed.at("system")), true));
    if (parameters.contains("vessel_labels")) {
        int number = 0;
        for (Json& label : parameters["vessel_labels"]) {
            const int value = whole_number<int>(label);
            label = {{"label", value}, {"system", name_of(system_of(++number, true))}};
        }
    }
    return parameters.dump();
}

std::string edits_of_format_1(const std::string& edits_json, bool seeded) {
    Json edits = Json::parse(edits_json);
    for (Json& edit : edits)
        if (edit.contains("system"))
            edit["system"] = name_of(system_of(whole_number<int>(edit["system"]), seeded));
    return edits.dump();
}

bool is_seeded_format_1(const VesselTree& extracted) {
    return std::ranges::any_of(extracted.segments, [](const VesselSegment& segment) {
        return segment.system != VascularSystem::unknown;
    });
}

void rename_systems_of_format_1(VesselTree& tree) {
    for (VesselSegment& segment : tree.segments)
        segment.system = system_of(number_of(segment.system), false);
}

void relabel_format_1(Mask& mask, const VesselTree& extracted) {
    std::set<std::uint8_t> labels(mask.voxels.begin(), mask.voxels.end());
    labels.erase(0);
    std::set<VascularSystem> systems;
    for (const VesselSegment& segment : extracted.segments) systems.insert(segment.system);
    const VascularSystem only = systems.size() == 1 ? *systems.begin() : VascularSystem::unknown;
    for (std::uint8_t& voxel : mask.voxels)
        if (voxel != 0)
            voxel = static_cast<std::uint8_t>(labels.size() > 1 ? system_of(voxel, true) : only);
}

}  // namespace hepatica
