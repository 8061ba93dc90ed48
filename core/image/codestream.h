// SPDX-License-Identifier: GPL-3.0-or-later
// The size that a compressed picture states itself. Decoders trust it more than the DICOM header,
// so the two are compared before one of them runs.
#pragma once

#include <optional>
#include <span>

namespace hepatica {

struct CodestreamSize {
    int columns = 0;
    int rows = 0;
    int components = 0;
    int bits = 0;  // of a sample
};

// Of a JPEG 2000 codestream (ISO 15444-1 A.5.1) or a JPEG or JPEG-LS picture (ISO 10918-1 B.2.2);
// nothing where the bytes are neither or damaged.
std::optional<CodestreamSize> codestream_size(std::span<const unsigned char> bytes);

}  // namespace hepatica
