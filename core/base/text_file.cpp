// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a file into a string.
#include "core/base/text_file.h"

#include <fstream>
#include <iterator>

#include "core/base/error.h"

namespace hepatica {

std::string read_text_file(const std::filesystem::path& file, const std::string& remedy) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw InputError("does not exist", file.string(), remedy);
    if (std::filesystem::is_directory(file, ignored))
        throw InputError("is a folder", file.string(), remedy);
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError("cannot be read; check its permissions", file.string(), remedy);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace hepatica
