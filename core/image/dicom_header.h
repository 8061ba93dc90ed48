// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a DICOM file, up to its pixels (DICOM PS3.5 and PS3.10). Parsed here with every
// length checked against the file's size, because GDCM's own parser terminates the program on some
// damaged files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hepatica {

// A range of bytes in the file.
struct FileRange {
    std::uint64_t offset = 0;
    std::uint32_t bytes = 0;
};

struct DicomHeader {
    // Values of the top level up to the pixels, unparsed; values above 4096 bytes are left out.
    // Keyed by group << 16 | element.
    std::map<std::uint32_t, std::string> values;
    std::string transfer_syntax;
    bool big_endian = false;
    bool has_pixels = false;
    bool has_modality_lut = false;     // a non-empty Modality LUT Sequence (0028,3000)
    bool has_contrast_agents = false;  // a non-empty Contrast/Bolus Agent Sequence (0018,0012)
    // Of an enhanced file: the values for position, orientation, pixel spacing and kernel in its
    // functional groups (5200,9229 and 5200,9230), in file order; keyed as above.
    std::map<std::uint32_t, std::vector<std::string>> group_values;
    bool compressed = false;           // the pixels are stored in fragments (JPEG, RLE ...)
    std::uint64_t pixel_offset = 0;    // of the first pixel, if not compressed
    std::uint64_t pixel_bytes = 0;     // length that the file states; 0 if compressed
    std::vector<FileRange> fragments;  // of compressed pixels, without the offset table
    // Where the deflated data set begins in the file; 0 if it is not deflated as a whole. If it is,
    // the offsets above count from the beginning of the inflated data.
    std::uint64_t deflated_at = 0;

    bool has(std::uint16_t group, std::uint16_t element) const;
    // Trimmed; "" where the value is missing.
    std::string text(std::uint16_t group, std::uint16_t element) const;
    // The numbers of a decimal string; empty if one of them is not a number.
    std::vector<double> numbers(std::uint16_t group, std::uint16_t element) const;
    // The same, but nothing if one of them is not a number; empty if the value is missing or blank.
    std::optional<std::vector<double>> numbers_if_sound(std::uint16_t group,
                                                        std::uint16_t element) const;
    // numbers() for each occurrence of the value in the functional groups.
    std::vector<std::vector<double>> group_numbers(std::uint16_t group,
                                                   std::uint16_t element) const;
    // The first value in the functional groups, trimmed; "" if there is none.
    std::string group_text(std::uint16_t group, std::uint16_t element) const;
    // A 16-bit value, or `otherwise` if it is missing.
    int unsigned_short(std::uint16_t group, std::uint16_t element, int otherwise = 0) const;
};

// Nothing if the file is not a DICOM file, cannot be read or its header is damaged. Throws no
// InputError.
std::optional<DicomHeader> read_dicom_header(const std::filesystem::path& file);

// The same from a stream of `size` bytes. A deflated data set is only located, not parsed.
std::optional<DicomHeader> parse_dicom_header(std::istream& in, std::uint64_t size);

// Decided by the first 132 bytes.
bool is_dicom_file(const std::filesystem::path& file);

}  // namespace hepatica
