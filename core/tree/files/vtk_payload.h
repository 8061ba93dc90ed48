// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes the bytes of one binary array in a file of VTK's XML formats (VTK's document "XML file
// formats"):
//   uncompressed  [bytes][data]
//   compressed    [blocks][bytes per block][bytes of the last block; 0: as the others]
//                 [compressed bytes of each block][blocks]
// In base64, header and data of an uncompressed array are one text; compressed blocks begin a new
// one. Each size is checked against the bytes available before memory is allocated for it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hepatica {

enum class VtkCompressor { none, zlib, lz4 };

struct VtkEncoding {
    bool base64 = false;           // else raw bytes
    bool big_endian = false;       // byte order of the header
    std::size_t header_bytes = 4;  // size of each number in the header: 4 or 8
    VtkCompressor compressor = VtkCompressor::none;
};

// `data` begins with the array's header and may continue after its end. `bytes` is the required
// size of the result, if known. Throws std::invalid_argument with the problem and the value.
std::string vtk_payload(std::string_view data, const VtkEncoding& encoding,
                        std::optional<std::size_t> bytes);

}  // namespace hepatica
