// SPDX-License-Identifier: GPL-3.0-or-later
// The files that come with the program, those of assets/: found beside the installed program, or in
// the source tree that it was built in. No place is compiled in, so that both may be moved.
#pragma once

#include <filesystem>

namespace hepatica {

// The file or folder `name` of assets/, such as "scripts/drag.json", as an absolute path. Looks in
// the installed place first. Throws InputError where it is in neither. Any thread.
std::filesystem::path asset(const std::filesystem::path& name);

// The same as the program at `program` (an absolute path) would find it.
std::filesystem::path asset_of(const std::filesystem::path& program,
                               const std::filesystem::path& name);

}  // namespace hepatica
