// SPDX-License-Identifier: GPL-3.0-or-later
// What core/image/segmentation_writer.cpp leaves in a folder for this helper: which slices of a CT
// were segmented, which segments there are, and their pixels.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace hepatica::dicom_segmentation {

// Why no segmentation can be written, and what its owner can do about it.
struct Refusal {
    std::string problem;
    std::string remedy;
};

struct Segment {
    std::string label;                    // shown by viewers
    std::string category_code, category;  // SNOMED CT, and its meaning
    std::string type_code, type;          // likewise
    std::array<int, 3> colour{};          // sRGB, 0 to 255
};

// One pixel is one where the segment is.
struct Frame {
    std::uint16_t segment = 0;  // from 1
    std::uint32_t slice = 0;    // from 0
    std::vector<std::uint8_t> pixels;
};

class Order {
  public:
    // Throws Refusal where the folder does not hold an order.
    explicit Order(const std::filesystem::path& folder);

    const std::vector<std::string>& slices() const { return slices_; }  // files, from the first on
    const std::vector<Segment>& segments() const { return segments_; }

    // The next frame of so many pixels; false where there is none. Throws Refusal where it is cut
    // off.
    bool next(std::size_t pixels, Frame& frame);

  private:
    std::vector<std::string> slices_;
    std::vector<Segment> segments_;
    std::ifstream frames_;
};

}  // namespace hepatica::dicom_segmentation
