// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of three bytes to four characters and back.
#include "core/base/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace hepatica {

namespace {

constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr char padding = '=';

constexpr std::array<int, 256> values = [] {
    std::array<int, 256> found{};
    found.fill(-1);
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        found[static_cast<unsigned char>(alphabet[i])] = static_cast<int>(i);
    return found;
}();

}  // namespace

std::string to_base64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t given = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = (group << 8) | (k < given ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= given ? alphabet[(group >> (18 - 6 * k)) & 63U] : padding;
    }
    return text;
}

std::optional<std::string> from_base64(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        const bool last = i + 4 == text.size();
        const std::size_t padded =
            last ? (text[i + 3] == padding ? 1U : 0U) + (text[i + 2] == padding ? 1U : 0U) : 0U;
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const bool is_padding = k >= 4 - padded && text[i + k] == padding;
            const int value = is_padding ? 0 : values[static_cast<unsigned char>(text[i + k])];
            if (value < 0) return std::nullopt;
            group = (group << 6) | static_cast<std::uint32_t>(value);
        }
        for (std::size_t k = 0; k < 3 - padded; ++k)
            bytes += static_cast<char>((group >> (16 - 8 * k)) & 255U);
        // Unused bits must be 0, as to_base64() writes them.
        if (padded > 0 && (group & ((1U << (8 * padded)) - 1U)) != 0) return std::nullopt;
    }
    return bytes;
}

}  // namespace hepatica
