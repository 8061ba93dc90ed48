// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the options of a reconstruction as JSON, and reads those needed to repeat its second half.
#include "core/reconstruction/reconstruct_parameters.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/sha256.h"

namespace hepatica {

namespace {

constexpr const char* trunk_key = "portal_trunk_mm";
constexpr const char* systems_given_key = "systems_given";

// None where the value is not an array of three numbers.
std::optional<Vec3> place_in(const nlohmann::json& json) {
    if (!json.is_array() || json.size() != 3 ||
        !std::ranges::all_of(json, [](const auto& number) { return number.is_number(); }))
        return std::nullopt;
    return Vec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
}

// Without malformed ones.
std::vector<VesselSeed> seeds_in(const nlohmann::json& json) {
    std::vector<VesselSeed> seeds;
    if (!json.contains("seeds") || !json["seeds"].is_array()) return seeds;
    for (const auto& seed : json["seeds"]) {
        try {
            const auto at = seed.at("position_mm").get<std::array<double, 3>>();
            const auto system = system_named(seed.at("system").get<std::string>());
            if (system) seeds.push_back({Vec3(at[0], at[1], at[2]), *system});
        } catch (const nlohmann::json::exception&) {
            continue;
        }
    }
    return seeds;
}

bool says(const nlohmann::json& json, const char* key) {
    return json.contains(key) && json[key].is_boolean() && json[key].get<bool>();
}

}  // namespace

bool takes_models(const ReconstructOptions& options) {
    return !options.vessel_mask && !options.window_hu &&
           options.method == SegmentationMethod::coherent;
}

std::string parameters_json(const ReconstructOptions& options) {
    nlohmann::ordered_json json;
    json["liver_mask_given"] = options.liver_mask.has_value();
    json["vessel_mask_given"] = options.vessel_mask.has_value();
    if (!options.tumour_masks.empty()) json["tumour_masks_given"] = options.tumour_masks.size();
    json["method"] = name_of(options.method);
    if (options.model) json["model_sha256"] = sha256_of_file(*options.model);
    if (options.offers && !options.model && takes_models(options))
        json["offers_sha256"] = sha256_of_file(*options.offers);
    if (options.window_hu)
        json["window_hu"] = {options.window_hu->first, options.window_hu->second};
    for (const VesselSeed& seed : options.seeds)
        json["seeds"].push_back(
            {{"position_mm", {seed.position_mm.x(), seed.position_mm.y(), seed.position_mm.z()}},
             {"system", name_of(seed.system)}});
    if (!options.liver_labels.empty()) json["liver_labels"] = options.liver_labels;
    for (const VesselLabel& label : options.vessel_labels)
        json["vessel_labels"].push_back(
            {{"label", label.label}, {"system", name_of(label.system)}});
    json["thinning"] = options.thinning == ThinningMethod::queue ? "queue" : "parallel";
    json["bridge_confidence"] = options.bridge_confidence;
    json["refinement_recursions"] = options.refinement_recursions;
    json["spacing_mm"] = options.spacing_mm;
    json["mesh"] = {{"facet_size_in_radii", options.mesh.facet_size_in_radii},
                    {"cell_size_in_radii", options.mesh.cell_size_in_radii},
                    {"target_tetrahedra", options.mesh.target_tetrahedra},
                    {"minimum_radius_mm", options.mesh.minimum_radius_mm}};
    return json.dump();
}

void keep_portal_trunk(const std::optional<Vec3>& trunk_mm, std::string& parameters_json) {
    if (!trunk_mm) return;
    auto json = nlohmann::ordered_json::parse(parameters_json);
    json[trunk_key] = {trunk_mm->x(), trunk_mm->y(), trunk_mm->z()};
    parameters_json = json.dump();
}

void keep_systems_given(bool given, std::string& parameters_json) {
    auto json = nlohmann::ordered_json::parse(parameters_json);
    json[systems_given_key] = given;
    parameters_json = json.dump();
}

GivenParts given_parts(const std::string& parameters_json) {
    GivenParts given;
    const auto json = nlohmann::json::parse(parameters_json, nullptr, false);
    if (!json.is_object()) return given;
    given.liver_mask = says(json, "liver_mask_given");
    given.vessel_mask = says(json, "vessel_mask_given");
    if (json.contains("tumour_masks_given") && json["tumour_masks_given"].is_number_unsigned())
        given.tumour_masks = json["tumour_masks_given"].get<std::size_t>();
    if (json.contains("window_hu")) {
        const auto& window = json["window_hu"];
        if (window.is_array() && window.size() == 2 && window[0].is_number() &&
            window[1].is_number())
            given.window_hu = {window[0].get<double>(), window[1].get<double>()};
    }
    given.seeds = seeds_in(json);
    return given;
}

FromVoxelsOptions from_voxels_options(const std::string& parameters_json) {
    FromVoxelsOptions options;
    const auto json = nlohmann::json::parse(parameters_json, nullptr, false);
    if (!json.is_object()) return options;
    const auto has = [&](const char* key, auto is) {
        return json.contains(key) && (json[key].*is)();
    };
    options.seeds = seeds_in(json);
    // Systems of a given mask are kept. An older case does not say whether its mask had some.
    const char* said = json.contains(systems_given_key) ? systems_given_key : "vessel_mask_given";
    options.find_systems = !options.seeds.empty() || !says(json, said);
    if (has("bridge_confidence", &nlohmann::json::is_number))
        options.bridge_confidence = json["bridge_confidence"].get<double>();
    if (json.contains("thinning") && json["thinning"] == "parallel")
        options.thinning = ThinningMethod::parallel;
    if (json.contains(trunk_key)) options.portal_trunk_mm = place_in(json[trunk_key]);
    options.shorten_trunk = options.portal_trunk_mm.has_value();
    return options;
}

}  // namespace hepatica
