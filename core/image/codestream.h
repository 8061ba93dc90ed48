// SPDX-License-Identifier: GPL-3.0-or-later
// The size stated inside a compressed picture. Decoders trust it more than the DICOM header, so
// both are compared before a decoder runs.
#pragma once

#include <optional>
#include <span>

namespace hepatica {

struct CodestreamSize {
    int columns = 0;
    int rows = 0;
    int components = 0;
    int bits = 0;  // per sample
};

// The size of a JPEG 2000 codestream (ISO 15444-1 A.5.1) or a JPEG or JPEG-LS picture (ISO 10918-1
// B.2.2); nothing if the bytes are neither or damaged. Thread-safe.
std::optional<CodestreamSize> codestream_size(std::span<const unsigned char> bytes);

}  // namespace hepatica
