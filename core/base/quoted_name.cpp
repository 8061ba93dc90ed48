// SPDX-License-Identifier: GPL-3.0-or-later
// UTF-8 validation after RFC 3629, and the search for quotation marks.
#include "core/base/quoted_name.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace hepatica {
namespace {

constexpr std::string_view opens = "\xe2\x80\x9c", closes = "\xe2\x80\x9d";
constexpr std::string_view unreadable = "\xef\xbf\xbd";

// Length in bytes of the character at the beginning of the text; 0 if it is invalid.
std::size_t character_size(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t size = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
    if (size == 0 || size > text.size()) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    // Overlong, a UTF-16 surrogate, or beyond U+10FFFF.
    const bool refused = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f) ||
                         (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f);
    return refused ? 0 : size;
}

std::string without(std::string text, std::string_view part) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
        text.erase(at, part.size());
    return text;
}

}  // namespace

std::string quoted_name(std::string_view name) {
    std::string plain = as_utf8(name);
    // Removing a mark may join bytes to a new mark, so this repeats until nothing changes.
    for (std::string before; before != plain;) {
        before = plain;
        plain = without(without(before, opens), closes);
    }
    return std::string(opens) + plain + std::string(closes);
}

std::string without_names(std::string_view sentence) {
    std::string text;
    while (true) {
        const std::size_t begin = sentence.find(opens);
        const std::size_t end =
            begin == std::string_view::npos ? std::string_view::npos : sentence.find(closes, begin);
        if (end == std::string_view::npos) return text += sentence;
        text += sentence.substr(0, begin);
        text.append(opens).append("…").append(closes);
        sentence.remove_prefix(end + closes.size());
    }
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        if (size == 0) return false;
        text.remove_prefix(size);
    }
    return true;
}

std::string as_utf8(std::string_view text) {
    std::string valid;
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        valid += size == 0 ? unreadable : text.substr(0, size);
        text.remove_prefix(std::max<std::size_t>(1, size));
    }
    return valid;
}

}  // namespace hepatica
