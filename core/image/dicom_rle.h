// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM's run-length encoding (PS3.5 annex G): the bytes of all pixels by significance, each plane
// packed on its own. Decoded here because GDCM's decoder reads beyond damaged data.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace hepatica {

// Little-endian words of word_bytes each, `pixels` of them; nothing where the data are damaged.
std::optional<std::vector<char>> decode_rle(std::span<const unsigned char> frame,
                                            std::size_t pixels, std::size_t word_bytes);

}  // namespace hepatica
