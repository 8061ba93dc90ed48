// SPDX-License-Identifier: GPL-3.0-or-later
// Small helpers for image headers that are text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hepatica {

std::string trimmed(std::string_view text);
std::string lower_case(std::string_view text);
// Words between white space.
std::vector<std::string> words(std::string_view text);
// A number with a decimal point whatever the user's language; nothing where it is none.
std::optional<double> number(std::string_view text);
// As many numbers as there are words; nothing where one of them is none.
std::optional<std::vector<double>> numbers(std::string_view text);

}  // namespace hepatica
