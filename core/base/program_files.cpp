// SPDX-License-Identifier: GPL-3.0-or-later
// Paths relative to /proc/self/exe.
#include "core/base/program_files.h"

#include <initializer_list>
#include <system_error>

#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// The file in the first of the folders that contains it.
fs::path first_with(const fs::path& name, std::initializer_list<fs::path> folders) {
    for (const fs::path& folder : folders) {
        fs::path place = (folder / name).lexically_normal();
        std::error_code ignored;
        if (fs::exists(place, ignored)) return place;
    }
    throw InputError("a file of the program itself is missing", name.string(),
                     "Install Hepatica again, or run it where it was built");
}

// Empty without /proc; the files are then not found.
fs::path this_program() {
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored);
}

}  // namespace

// Installed places as configured in CMake; in the build tree programs are in build/PRESET/bin.
fs::path asset_of(const fs::path& program, const fs::path& name) {
    const fs::path bin = program.parent_path();
    return first_with(name, {bin / HEPATICA_ASSETS_FROM_BIN, bin / "../../../assets"});
}

fs::path helper_of(const fs::path& program, const fs::path& name) {
    const fs::path bin = program.parent_path();
    return first_with(name, {bin / HEPATICA_HELPERS_FROM_BIN, bin});
}

fs::path asset(const fs::path& name) {
    return asset_of(this_program(), name);
}

fs::path helper(const fs::path& name) {
    return helper_of(this_program(), name);
}

}  // namespace hepatica
