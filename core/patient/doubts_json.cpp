// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/doubts_json.h"

#include "core/base/json_number.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

Json json_of(const Doubts& doubts) {
    return {{"contrast_hu", doubts.contrast_hu},
            {"noise_hu", doubts.noise_hu},
            {"coarsest_spacing_mm", doubts.coarsest_spacing_mm},
            {"uncertain_share", doubts.uncertain_share},
            {"unknown_share", doubts.unknown_share},
            {"opened_loops", doubts.opened_loops},
            {"loops", doubts.loops},
            {"in_words", sentences(doubts)}};
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
    return doubts;
}

}  // namespace hepatica
