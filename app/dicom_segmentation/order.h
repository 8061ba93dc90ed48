// SPDX-License-Identifier: GPL-3.0-or-later
// The order that core/image/segmentation_writer.cpp leaves in a folder for this helper: the CT
// slices that were segmented, the segments, and their pixels.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace hepatica::dicom_segmentation {

// The exit code of the helper where the file to write cannot be written; 1 where anything else is
// refused.
inline constexpr int exit_unwritable = 3;

// Why no segmentation can be written, and what the user can do.
struct Refusal {
    std::string problem;
    std::string remedy;
    int exit_code = 1;
};

struct Segment {
    std::string label;                    // shown by viewers
    std::string category_code, category;  // SNOMED CT code and its meaning
    std::string type_code, type;          // the same
    std::array<int, 3> colour{};          // sRGB, 0 to 255
};

// One slice of one segment; pixels are 1 where the segment is.
struct Frame {
    std::uint16_t segment = 0;  // counted from 1
    std::uint32_t slice = 0;    // counted from 0
    std::vector<std::uint8_t> pixels;
};

class Order {
  public:
    // Throws Refusal where the folder does not hold a whole order or a read fails.
    explicit Order(const std::filesystem::path& folder);

    const std::vector<std::string>& slices() const { return slices_; }  // files, in order
    const std::vector<Segment>& segments() const { return segments_; }

    // Reads the next frame of `pixels` pixels; false at the end. Throws Refusal where the file is
    // truncated or inconsistent or a read fails.
    bool next(std::size_t pixels, Frame& frame);

  private:
    std::vector<std::string> slices_;
    std::vector<Segment> segments_;
    std::ifstream frames_;
};

}  // namespace hepatica::dicom_segmentation
