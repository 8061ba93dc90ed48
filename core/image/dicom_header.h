// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a DICOM file before its pixels (DICOM PS3.5 and PS3.10). Parsed here, with every
// length held against the file's size, because GDCM's own parser ends the program on some damaged
// files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hepatica {

// A stretch of the file.
struct FileRange {
    std::uint64_t offset = 0;
    std::uint32_t bytes = 0;
};

struct DicomHeader {
    // Values of the top level up to the pixels, as they stand in the file; long ones left out.
    // Keyed by group << 16 | element.
    std::map<std::uint32_t, std::string> values;
    std::string transfer_syntax;
    bool big_endian = false;
    bool has_pixels = false;
    bool has_modality_lut = false;     // a Modality LUT Sequence (0028,3000) that is not empty
    bool has_contrast_agents = false;  // a Contrast/Bolus Agent Sequence (0018,0012), likewise
    // Of an enhanced file: what its functional groups (5200,9229 and 5200,9230) say of position,
    // orientation, pixel spacing and kernel, in their order; keyed as above.
    std::map<std::uint32_t, std::vector<std::string>> group_values;
    bool compressed = false;           // the pixels are in fragments of a JPEG, RLE ... stream
    std::uint64_t pixel_offset = 0;    // of the first pixel, where they are not compressed
    std::uint64_t pixel_bytes = 0;     // length as the file states it; 0 where compressed
    std::vector<FileRange> fragments;  // of compressed pixels, without the offset table
    // Where the deflated data set begins in the file; 0 where it is not deflated as a whole. The
    // offsets above then count from the beginning of the inflated data.
    std::uint64_t deflated_at = 0;

    bool has(std::uint16_t group, std::uint16_t element) const;
    // Trimmed; "" where the value is missing.
    std::string text(std::uint16_t group, std::uint16_t element) const;
    // The numbers of a decimal string; empty where one of them is none.
    std::vector<double> numbers(std::uint16_t group, std::uint16_t element) const;
    // The same, or nothing where one of them is none; empty where the value is missing or blank.
    std::optional<std::vector<double>> numbers_if_sound(std::uint16_t group,
                                                        std::uint16_t element) const;
    // The same of the functional groups, for each time that the value stands there.
    std::vector<std::vector<double>> group_numbers(std::uint16_t group,
                                                   std::uint16_t element) const;
    // Trimmed, of the first; "" where there is none.
    std::string group_text(std::uint16_t group, std::uint16_t element) const;
    // A 16-bit value, or `otherwise` where it is missing.
    int unsigned_short(std::uint16_t group, std::uint16_t element, int otherwise = 0) const;
};

// Nothing where the file is no DICOM file or its header is damaged. Throws nothing.
std::optional<DicomHeader> read_dicom_header(const std::filesystem::path& file);

// The same from memory, which a file's bytes may be given in.
std::optional<DicomHeader> parse_dicom_header(std::istream& in, std::uint64_t size);

// Judged by its first bytes.
bool is_dicom_file(const std::filesystem::path& file);

}  // namespace hepatica
