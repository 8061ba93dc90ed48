// SPDX-License-Identifier: GPL-3.0-or-later
// The files that come with the program, those of assets/ and its helpers: found beside the
// installed program, or in the source tree that it was built in. No place is compiled in, so that
// both may be moved.
#pragma once

#include <filesystem>

namespace hepatica {

// The file or folder `name` of assets/, such as "scripts/drag.json", as an absolute path. Looks in
// the installed place first. Throws InputError where it is in neither. Any thread.
std::filesystem::path asset(const std::filesystem::path& name);

// The same as the program at `program` (an absolute path) would find it.
std::filesystem::path asset_of(const std::filesystem::path& program,
                               const std::filesystem::path& name);

// The same of a helper: a program that only our programs start. It stands in libexec where they are
// installed, beside them where they are built.
std::filesystem::path helper(const std::filesystem::path& name);
std::filesystem::path helper_of(const std::filesystem::path& program,
                                const std::filesystem::path& name);

}  // namespace hepatica
