// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM's run-length encoding (PS3.5 annex G): the bytes of all pixels ordered by significance,
// each plane packed separately. Decoded here because GDCM's decoder reads beyond damaged data.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace hepatica {

// The bytes of `pixels` little-endian words of word_bytes each; nothing if the data are damaged.
std::optional<std::vector<char>> decode_rle(std::span<const unsigned char> frame,
                                            std::size_t pixels, std::size_t word_bytes);

}  // namespace hepatica
