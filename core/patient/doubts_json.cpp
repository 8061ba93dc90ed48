// SPDX-License-Identifier: GPL-3.0-or-later
// Converts doubts to and from JSON.
#include "core/patient/doubts_json.h"

#include "core/base/json_number.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

Json json_of(const SegmentDoubts& doubts) {
    return {{"unsure_share", doubts.unsure_share},
            {"without_branch", doubts.without_branch},
            {"veins_known", doubts.veins_known},
            {"liver_found", doubts.liver_found}};
}

SegmentDoubts segment_doubts_from(const Json& json) {
    SegmentDoubts doubts;
    doubts.unsure_share = json.at("unsure_share").get<double>();
    for (const Json& number : json.at("without_branch"))
        doubts.without_branch.push_back(whole_number<int>(number));
    doubts.veins_known = whole_number<int>(json.at("veins_known"));
    doubts.liver_found = json.value("liver_found", false);  // missing in older cases
    return doubts;
}

}  // namespace

Json json_of(const Doubts& doubts) {
    Json json{{"contrast_hu", doubts.contrast_hu},
              {"noise_hu", doubts.noise_hu},
              {"coarsest_spacing_mm", doubts.coarsest_spacing_mm},
              {"uncertain_share", doubts.uncertain_share},
              {"unknown_share", doubts.unknown_share},
              {"opened_loops", doubts.opened_loops},
              {"loops", doubts.loops}};
    if (doubts.segments) json["segments"] = json_of(*doubts.segments);
    json["in_words"] = sentences(doubts);
    return json;
}

Doubts doubts_from(const Json& json) {
    Doubts doubts;
    doubts.contrast_hu = json.at("contrast_hu").get<double>();
    doubts.noise_hu = json.at("noise_hu").get<double>();
    doubts.coarsest_spacing_mm = json.at("coarsest_spacing_mm").get<double>();
    doubts.uncertain_share = json.at("uncertain_share").get<double>();
    doubts.unknown_share = json.at("unknown_share").get<double>();
    doubts.opened_loops = whole_number<int>(json.at("opened_loops"));
    doubts.loops = whole_number<int>(json.at("loops"));
    if (json.contains("segments")) doubts.segments = segment_doubts_from(json.at("segments"));
    return doubts;
}

}  // namespace hepatica
