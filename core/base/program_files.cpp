// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/program_files.h"

#include <system_error>

#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

fs::path asset_of(const fs::path& program, const fs::path& name) {
    const fs::path bin = program.parent_path();
    // Installed as CMake was told; built as build/PRESET/bin.
    for (const fs::path& assets : {bin / HEPATICA_ASSETS_FROM_BIN, bin / "../../../assets"}) {
        fs::path place = (assets / name).lexically_normal();
        std::error_code ignored;
        if (fs::exists(place, ignored)) return place;
    }
    throw InputError("a file of the program itself is missing", name.string(),
                     "Install Hepatica again, or run it where it was built");
}

fs::path asset(const fs::path& name) {
    std::error_code ignored;  // without /proc there is no path, and the answer is that of a miss
    return asset_of(fs::read_symlink("/proc/self/exe", ignored), name);
}

}  // namespace hepatica
