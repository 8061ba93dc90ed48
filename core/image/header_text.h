// SPDX-License-Identifier: GPL-3.0-or-later
// Helpers for image headers that are text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hepatica {

// Without leading and trailing white space and nulls.
std::string trimmed(std::string_view text);
std::string lower_case(std::string_view text);
// The words separated by white space.
std::vector<std::string> words(std::string_view text);
// A number with a decimal point, independent of the locale; nothing if the text is not one number.
std::optional<double> number(std::string_view text);
// One number per word; nothing if a word is not a number.
std::optional<std::vector<double>> numbers(std::string_view text);

}  // namespace hepatica
