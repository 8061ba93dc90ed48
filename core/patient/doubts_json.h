// SPDX-License-Identifier: GPL-3.0-or-later
// The doubts as JSON, in case.json and in answers of the command line.
#pragma once

#include <nlohmann/json.hpp>

#include "core/patient/doubts.h"

namespace hepatica {

// Includes the sentences as `in_words`.
nlohmann::ordered_json json_of(const Doubts& doubts);
// Throws nlohmann::json::exception where a number is missing or has another type, InputError where
// a count is not a whole number.
Doubts doubts_from(const nlohmann::ordered_json& json);

}  // namespace hepatica
