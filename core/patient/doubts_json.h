// SPDX-License-Identifier: GPL-3.0-or-later
// The report of doubt as it stands in case.json and in the answers of the command line.
#pragma once

#include <nlohmann/json.hpp>

#include "core/patient/doubts.h"

namespace hepatica {

// With the sentences as `in_words`.
nlohmann::ordered_json json_of(const Doubts& doubts);
// Throws what the JSON library does where a number is missing or none, InputError where a count is
// no whole number.
Doubts doubts_from(const nlohmann::ordered_json& json);

}  // namespace hepatica
