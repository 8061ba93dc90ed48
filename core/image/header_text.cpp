// SPDX-License-Identifier: GPL-3.0-or-later
// Number and word parsing that does not depend on the locale's decimal point.
#include "core/image/header_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>

namespace hepatica {

std::string trimmed(std::string_view text) {
    using namespace std::string_view_literals;
    constexpr std::string_view blanks = " \t\r\n\0"sv;  // some DICOM writers pad with nulls
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

std::vector<std::string> words(std::string_view text) {
    std::istringstream in{std::string(text)};
    std::vector<std::string> list;
    for (std::string word; in >> word;) list.push_back(word);
    return list;
}

std::optional<double> number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<std::vector<double>> numbers(std::string_view text) {
    std::vector<double> values;
    for (const std::string& word : words(text)) {
        const std::optional<double> value = number(word);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

}  // namespace hepatica
