// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a whole text file, with errors that state why it cannot be read.
#pragma once

#include <filesystem>
#include <string>

namespace hepatica {

// The content of the file. Throws InputError, naming the file, if it does not exist, is a folder or
// cannot be read; `remedy` says what should have been given.
std::string read_text_file(const std::filesystem::path& file, const std::string& remedy);

}  // namespace hepatica
