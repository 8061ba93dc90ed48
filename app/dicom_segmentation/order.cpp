// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom_segmentation/order.h"

#include <cstdlib>
#include <sstream>

namespace hepatica::dicom_segmentation {

namespace {

namespace fs = std::filesystem;

Refusal cut_off() {
    return {"cannot be made: the helper's order is cut off",
            "Free some space among the temporary files, or set TMPDIR"};
}

// Values end with a zero byte, so that any file name and label can be passed.
std::vector<std::string> values_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<std::string> values;
    for (std::string value; std::getline(in, value, '\0');) {
        if (in.eof()) throw cut_off();  // the value has no end
        values.push_back(value);
    }
    if (in.bad()) throw cut_off();
    if (values.empty())
        throw Refusal{"cannot be made: the helper's order has no " + file.filename().string(),
                      "Install the program again"};
    return values;
}

std::array<int, 3> colour_of(const std::string& text) {
    std::array<int, 3> colour{};
    std::istringstream numbers(text);
    for (int& channel : colour) numbers >> channel;
    if (!numbers) throw cut_off();
    return colour;
}

}  // namespace

Order::Order(const fs::path& folder)
    : slices_(values_of(folder / "slices")), frames_(folder / "frames", std::ios::binary) {
    constexpr std::size_t values_per_segment = 6;
    const std::vector<std::string> values = values_of(folder / "segments");
    if (!frames_ || values.size() % values_per_segment != 0) throw cut_off();
    for (std::size_t i = 0; i < values.size(); i += values_per_segment)
        segments_.push_back({values[i], values[i + 1], values[i + 2], values[i + 3], values[i + 4],
                             colour_of(values[i + 5])});
}

bool Order::next(std::size_t pixels, Frame& frame) {
    frames_.read(reinterpret_cast<char*>(&frame.segment), sizeof frame.segment);
    if (frames_.gcount() == 0 && !frames_.bad()) return false;
    frames_.read(reinterpret_cast<char*>(&frame.slice), sizeof frame.slice);
    frame.pixels.resize(pixels);
    frames_.read(reinterpret_cast<char*>(frame.pixels.data()),
                 static_cast<std::streamsize>(pixels));
    if (!frames_ || frame.segment < 1 || frame.segment > segments_.size() ||
        frame.slice >= slices_.size())
        throw cut_off();
    return true;
}

}  // namespace hepatica::dicom_segmentation
