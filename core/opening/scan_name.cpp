// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/scan_name.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/image/header_text.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 13> common_to_all{
    "ct",  "dcm",  "dicom", "dicomdir", "dicoms", "image",        "images",
    "img", "imgs", "serie", "series",   "slices", "patient_dicom"};
constexpr std::array<std::string_view, 9> before_numbers{"",   "ct",     "im", "pa",   "s",
                                                         "se", "series", "st", "study"};

bool is_common(const std::string& name) {
    return std::ranges::find(common_to_all, lower_case(name)) != common_to_all.end();
}

// As writers of DICOM number their folders: S0001, SE2, 42.
bool is_numbered(const std::string& name) {
    const std::size_t last = name.find_last_not_of("0123456789");
    const std::size_t letters = last == std::string::npos ? 0 : last + 1;
    return letters < name.size() &&
           std::ranges::find(before_numbers, lower_case(name.substr(0, letters))) !=
               before_numbers.end();
}

}  // namespace

std::string name_of_scan(const fs::path& folder) {
    const fs::path own = folder.has_filename() ? folder : folder.parent_path();
    std::string numbers;
    for (fs::path at = own; at.has_filename(); at = at.parent_path()) {
        const std::string name = at.filename().string();
        if (is_numbered(name))
            numbers = " " + name + numbers;
        else if (!is_common(name))
            return name + numbers;
    }
    return own.filename().string();
}

}  // namespace hepatica
