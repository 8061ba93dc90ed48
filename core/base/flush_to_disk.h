// SPDX-License-Identifier: GPL-3.0-or-later
// Waits until a written file is on the disk, for what must survive a power cut: a file that is
// renamed into its place may otherwise be found there without its content.
#pragma once

#include <filesystem>

namespace hepatica {

// Throws InputError with the reason where the file's content cannot be brought to the disk, as
// where the disk of another computer turns out to be full. The error names `written_as`, the place
// that the user knows.
void flush_to_disk(const std::filesystem::path& file, const std::filesystem::path& written_as);

}  // namespace hepatica
