// SPDX-License-Identifier: GPL-3.0-or-later
// The message for an unknown, most likely misspelt key.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hepatica {

// `is not known; the nearest key is "over_s"`: the first known key that begins with `key` (three
// letters or more), else the nearest by edit distance (Levenshtein), the first of several. If more
// than half of the letters differ, all known keys are listed.
std::string unknown_key(std::string_view key, std::span<const std::string> known);

}  // namespace hepatica
