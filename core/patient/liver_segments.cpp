// SPDX-License-Identifier: GPL-3.0-or-later
// Calls the division into Couinaud's segments and records its doubts.
#include "core/patient/liver_segments.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/patient/case_header.h"
#include "core/tree/territories/couinaud_segments.h"

namespace hepatica {

namespace {

constexpr const char* liver_given = "liver_mask_given";

// Throws InputError where the case's parameter is not a truth value.
bool liver_was_found(const CaseSource& source) {
    const auto parameters = nlohmann::json::parse(source.parameters_json, nullptr, false);
    if (!parameters.is_object() || !parameters.contains(liver_given)) return false;
    const nlohmann::json& given = parameters[liver_given];
    if (!given.is_boolean())
        refuse_case(case_file::header, std::string("its parameter ") + liver_given + " is " +
                                           given.dump() + ", not true or false");
    return !given.get<bool>();
}

}  // namespace

Mask liver_of(const Mask& organs) {
    if (std::ranges::find(organs.voxels, organ_label::liver) == organs.voxels.end()) return {};
    Mask liver = organs;
    for (std::uint8_t& voxel : liver.voxels)
        voxel = voxel == organ_label::liver || voxel >= organ_label::first_tumour ? 1 : 0;
    return liver;
}

void label_segments(PatientCase& patient, Job& job) {
    if (patient.organs.voxels.empty()) return;
    patient.couinaud = {};
    if (patient.doubts) patient.doubts->segments.reset();
    const Mask liver = liver_of(patient.organs);
    if (liver.voxels.empty()) return;
    auto found = couinaud_segments(patient.tree, liver, job);
    if (!found) return;
    patient.couinaud = std::move(found->labels);
    if (!patient.doubts) return;
    SegmentDoubts doubts;
    doubts.unsure_share = found->unsure_share;
    const auto volumes = segment_volumes_ml(patient.couinaud);
    for (int k = 0; k < couinaud_count; ++k)
        if (volumes[k] == 0.0) doubts.without_branch.push_back(k + 1);
    doubts.veins_known = static_cast<int>(std::ranges::count(found->frame.vein_known, true));
    doubts.liver_found = liver_was_found(patient.source);
    patient.doubts->segments = std::move(doubts);
}

nlohmann::ordered_json segments_ml_json(const Mask& couinaud) {
    const auto volumes = segment_volumes_ml(couinaud);
    nlohmann::ordered_json json;
    for (int k = 0; k < couinaud_count; ++k) json[std::to_string(k + 1)] = volumes[k];
    return json;
}

}  // namespace hepatica
