// SPDX-License-Identifier: GPL-3.0-or-later
// Parses only the markers up to the size of the picture; nothing is decoded.
#include "core/image/codestream.h"

#include <cstddef>
#include <cstdint>

namespace hepatica {

namespace {

using Bytes = std::span<const unsigned char>;

// A big-endian number of `count` bytes; bytes beyond the end count as 0.
std::uint32_t number(Bytes bytes, std::size_t at, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value = value << 8 | (at + i < bytes.size() ? bytes[at + i] : 0u);
    return value;
}

std::optional<CodestreamSize> jpeg_2000_size(Bytes bytes) {
    // The start of the codestream, immediately followed by the size marker.
    if (number(bytes, 2, 2) != 0xff51 || bytes.size() < 45) return std::nullopt;
    const std::uint32_t right = number(bytes, 8, 4);
    const std::uint32_t bottom = number(bytes, 12, 4);
    const std::uint32_t left = number(bytes, 16, 4);
    const std::uint32_t top = number(bytes, 20, 4);
    const bool whole_samples = bytes[43] == 1 && bytes[44] == 1;
    if (right > 65535 || bottom > 65535 || left >= right || top >= bottom || !whole_samples)
        return std::nullopt;
    return CodestreamSize{static_cast<int>(right - left), static_cast<int>(bottom - top),
                          static_cast<int>(number(bytes, 40, 2)), (bytes[42] & 0x7f) + 1};
}

bool is_frame_marker(unsigned marker) {
    // Huffman tables, reserved, arithmetic coding conditions.
    const bool other = marker == 0xc4 || marker == 0xc8 || marker == 0xcc;
    return (marker >= 0xc0 && marker <= 0xcf && !other) || marker == 0xf7;
}

// GDCM terminates the program where the JPEG library warns about the JFIF version.
bool is_unknown_jfif(Bytes bytes, std::size_t at) {
    return bytes[at + 1] == 0xe0 && number(bytes, at + 4, 4) == 0x4a464946 && bytes[at + 9] != 1;
}

// Walks from segment to segment to the start of the pixels. Each segment must follow the one before
// immediately, because GDCM terminates the program otherwise.
std::optional<CodestreamSize> jpeg_size(Bytes bytes) {
    constexpr unsigned start_of_pixels = 0xda;
    std::optional<CodestreamSize> size;
    std::size_t at = 2;
    while (at + 10 < bytes.size()) {
        const unsigned marker = bytes[at + 1];
        if (bytes[at] != 0xff || is_unknown_jfif(bytes, at)) return std::nullopt;
        if (marker == start_of_pixels) return size;
        if (is_frame_marker(marker)) {
            if (size) return std::nullopt;
            size = CodestreamSize{static_cast<int>(number(bytes, at + 7, 2)),
                                  static_cast<int>(number(bytes, at + 5, 2)), bytes[at + 9],
                                  bytes[at + 4]};
        }
        at += 2 + number(bytes, at + 2, 2);
    }
    return std::nullopt;
}

}  // namespace

std::optional<CodestreamSize> codestream_size(Bytes bytes) {
    if (number(bytes, 0, 2) == 0xff4f) return jpeg_2000_size(bytes);
    if (number(bytes, 0, 2) == 0xffd8) return jpeg_size(bytes);
    return std::nullopt;
}

}  // namespace hepatica
