// SPDX-License-Identifier: GPL-3.0-or-later
// What to say of a key that nobody knows: it is most likely misspelt.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hepatica {

// `is not known; the nearest key is "over_s"`: the first that begins with it, else the nearest by
// edit distance (Levenshtein), the first of several. Where more than half of the letters would have
// to change it lists them all.
std::string unknown_key(std::string_view key, std::span<const std::string> known);

}  // namespace hepatica
