// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_extension.h"

#include <algorithm>

namespace hepatica {

std::string extension_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension;
}

}  // namespace hepatica
