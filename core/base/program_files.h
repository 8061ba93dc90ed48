// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the files that come with the program, those of assets/ and its helper programs: relative to
// the installed program, or in the source tree it was built in. No absolute path is compiled in, so
// both may be moved.
#pragma once

#include <filesystem>

namespace hepatica {

// The file or folder `name` of assets/, such as "scripts/drag.json", as an absolute path. The
// installed place takes precedence. Throws InputError if it is in neither. Thread-safe.
std::filesystem::path asset(const std::filesystem::path& name);

// The same for a program at `program` (an absolute path).
std::filesystem::path asset_of(const std::filesystem::path& program,
                               const std::filesystem::path& name);

// The same for a helper, which only our programs start. Helpers are installed in libexec, and built
// beside the programs.
std::filesystem::path helper(const std::filesystem::path& name);
std::filesystem::path helper_of(const std::filesystem::path& program,
                                const std::filesystem::path& name);

}  // namespace hepatica
