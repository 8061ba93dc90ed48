// SPDX-License-Identifier: GPL-3.0-or-later
// The header of 16 words and one PackBits run per byte plane.
#include "core/image/dicom_rle.h"

#include <algorithm>
#include <cstdint>

namespace hepatica {

namespace {

using Bytes = std::span<const unsigned char>;

constexpr std::size_t header_bytes = 64;  // the number of planes and the offset of each

std::uint32_t header_word(Bytes frame, std::size_t index) {
    const Bytes word = frame.subspan(4 * index, 4);
    return word[0] | word[1] << 8 | word[2] << 16 | static_cast<std::uint32_t>(word[3]) << 24;
}

// PackBits: a count n below 128 is followed by n + 1 literal bytes, a count above 128 by one byte
// that is repeated 257 - n times; 128 is skipped. Writes every stride-th byte; false if data are
// missing.
bool unpack(Bytes packed, char* out, std::size_t pixels, std::size_t stride) {
    std::size_t done = 0;
    std::size_t at = 0;
    while (done < pixels) {
        if (at >= packed.size()) return false;
        const unsigned count = packed[at++];
        if (count == 128) continue;
        const bool run = count > 128;
        const std::size_t length =
            std::min<std::size_t>(run ? 257 - count : count + 1, pixels - done);
        if (at + (run ? 1 : length) > packed.size()) return false;
        for (std::size_t i = 0; i < length; ++i)
            out[(done + i) * stride] = static_cast<char>(packed[run ? at : at + i]);
        at += run ? 1 : length;
        done += length;
    }
    return true;
}

}  // namespace

std::optional<std::vector<char>> decode_rle(Bytes frame, std::size_t pixels,
                                            std::size_t word_bytes) {
    if (frame.size() < header_bytes || header_word(frame, 0) != word_bytes) return std::nullopt;
    std::vector<char> words(pixels * word_bytes);
    for (std::size_t plane = 0; plane < word_bytes; ++plane) {
        const std::size_t begin = header_word(frame, 1 + plane);
        const std::size_t end =
            plane + 1 < word_bytes ? header_word(frame, 2 + plane) : frame.size();
        if (begin < header_bytes || end < begin || end > frame.size()) return std::nullopt;
        // The first plane holds the most significant bytes.
        if (!unpack(frame.subspan(begin, end - begin), words.data() + (word_bytes - 1 - plane),
                    pixels, word_bytes))
            return std::nullopt;
    }
    return words;
}

}  // namespace hepatica
