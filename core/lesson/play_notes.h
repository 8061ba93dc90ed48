// SPDX-License-Identifier: GPL-3.0-or-later
// What an instructor writes beside a recording: notes at moments of it, in NAME.notes.json beside
// NAME.hrec. The recording itself is never changed.
//   {"format": "hepatica-notes", "version": 1, "notes": [{"at_s": 12.5, "text": "Slower here"}]}
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hepatica {

struct PlayNote {
    double at_s = 0.0;  // as in PlayEvent
    std::string text;   // not empty
    bool operator==(const PlayNote&) const = default;
};

std::filesystem::path notes_file_of(const std::filesystem::path& recording);

// In the order of time; none where there is no such file. Throws InputError that names the file,
// the place in it and what is wrong.
std::vector<PlayNote> read_notes(const std::filesystem::path& recording);
std::vector<PlayNote> notes_of(const std::string& text, const std::string& place);

// Whole or not at all; no notes remove the file. Throws InputError where it cannot be written.
void write_notes(const std::filesystem::path& recording, const std::vector<PlayNote>& notes);

}  // namespace hepatica
