// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a path may be opened to be read: opening a named pipe waits for a writer, who may never
// come.
#pragma once

#include <filesystem>
#include <string>

namespace hepatica {

// Throws InputError, naming the file, for a folder, pipe, socket or device. What does not exist or
// cannot be looked up passes: opening it says why. So does what a shell hands over (/dev/stdin,
// /dev/fd/63), which has its writer.
void require_regular_file(const std::filesystem::path& file,
                          const std::string& remedy = "Choose a file");

}  // namespace hepatica
