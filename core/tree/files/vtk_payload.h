// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of one array in a file of VTK's XML formats, where they are binary (VTK's document "XML
// file formats"):
//   uncompressed  [bytes][data]
//   compressed    [blocks][bytes of a block][bytes of the last, 0 where it is as large as the
//   others]
//                 [compressed bytes of each block][blocks]
// In base64 the data of an uncompressed array go on where the header ends; compressed blocks begin
// a new text. Each size is held against the bytes that are there before anything is made of it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hepatica {

enum class VtkCompressor { none, zlib, lz4 };

struct VtkEncoding {
    bool base64 = false;           // else the bytes themselves
    bool big_endian = false;       // of the header's numbers
    std::size_t header_bytes = 4;  // of each number in the header: 4 or 8
    VtkCompressor compressor = VtkCompressor::none;
};

// `data` begins with the array's header and may go on after its end. `bytes`: how many the array
// must have, where that is known. Throws std::invalid_argument that says, with the value, what is
// wrong.
std::string vtk_payload(std::string_view data, const VtkEncoding& encoding,
                        std::optional<std::size_t> bytes);

}  // namespace hepatica
