// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a whole text file, with errors that state why it cannot be read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>

namespace hepatica {

// The content of the file. Throws InputError, naming the file, if it does not exist, is no regular
// file, cannot be opened or cannot be read to its end; `remedy` says what should have been given.
// Thread-safe.
std::string read_text_file(const std::filesystem::path& file, const std::string& remedy);

// What is left in a stream of the file. Throws InputError, naming the file, where a read fails, and
// where the stream ends before `least_bytes`, the file's size when it was opened (0: unknown).
std::string read_text_stream(std::istream& in, std::uint64_t least_bytes,
                             const std::filesystem::path& file);

}  // namespace hepatica
