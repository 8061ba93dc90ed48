// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/scan_name.h"

#include <algorithm>
#include <array>
#include <iterator>
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

// The user's home, the top of a disc, or where everything lands.
bool is_beyond_scans(const fs::path& folder) {
    const fs::path below_root = folder.relative_path();
    const auto depth = std::distance(below_root.begin(), below_root.end());
    const std::string first = depth > 0 ? below_root.begin()->string() : std::string();
    const std::ptrdiff_t top = first == "media"                    ? 3
                               : first == "run"                    ? 4
                               : first == "home" || first == "mnt" ? 2
                                                                   : 1;
    const std::string name = lower_case(folder.filename().string());
    return depth <= top || name == "downloads" || name == "documents" || name == "desktop";
}

}  // namespace

std::string name_of_scan(const fs::path& folder) {
    const fs::path own = folder.has_filename() ? folder : folder.parent_path();
    std::string numbers;
    for (fs::path at = own; at.has_filename(); at = at.parent_path()) {
        const std::string name = at.filename().string();
        if (is_numbered(name))
            numbers = " " + name + numbers;
        else if (is_beyond_scans(at) && at != own)
            break;
        else if (!is_common(name))
            return name + numbers;
    }
    return own.filename().string();
}

}  // namespace hepatica
