// SPDX-License-Identifier: GPL-3.0-or-later
// A moment of a world that can be restored to the bit: what snapshots and the keyframes of
// recordings keep.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "core/scene/bleeding.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"

namespace hepatica {

struct WorldCheckpoint {
    double time_s = 0.0;
    double leaked_g = 0.0;                   // out of torn vessels
    double leaked_drug_g = 0.0;              // of that
    std::optional<DeformCheckpoint> deform;  // where the scene has the part
    std::optional<FlowCheckpoint> flow;
    std::vector<BloodPool> pools{};  // where leaked_g lies; empty: not known
};

// Numbers are exact to the last bit; the drug's arrival times are left out, because they follow
// from the injection. Reading throws InputError that names the key that is missing or wrong;
// whether the values fit the patient is checked by World::restore.
nlohmann::ordered_json to_json(const WorldCheckpoint& checkpoint);
WorldCheckpoint world_checkpoint_from_json(const nlohmann::ordered_json& json);

}  // namespace hepatica
