// SPDX-License-Identifier: GPL-3.0-or-later
// The whole of a text file, or a clear word on why not.
#pragma once

#include <filesystem>
#include <string>

namespace hepatica {

// Throws InputError, naming the file, where it does not exist, is a folder or cannot be read;
// `remedy` says what should have been given.
std::string read_text_file(const std::filesystem::path& file, const std::string& remedy);

}  // namespace hepatica
