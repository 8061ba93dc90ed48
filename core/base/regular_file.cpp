// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/regular_file.h"

#include <system_error>

#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

void require_regular_file(const fs::path& file, const std::string& remedy) {
    if (file == "/dev/stdin" || file.parent_path() == "/dev/fd") return;
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    if (fs::is_directory(status)) throw InputError("is a folder", file.string(), remedy);
    if (fs::is_other(status))
        throw InputError("is a pipe, a socket or a device, not a file", file.string(), remedy);
}

}  // namespace hepatica
