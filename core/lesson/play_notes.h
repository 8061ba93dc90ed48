// SPDX-License-Identifier: GPL-3.0-or-later
// An instructor's notes on moments of a recording, in NAME.notes.json beside NAME.hrec. The
// recording itself is never changed.
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

// Sorted by time; empty if there is no file. Throws InputError with the file, the place in it and
// the problem.
std::vector<PlayNote> read_notes(const std::filesystem::path& recording);
std::vector<PlayNote> notes_of(const std::string& text, const std::string& place);

// Writes atomically; an empty list removes the file. Throws InputError where that fails.
void write_notes(const std::filesystem::path& recording, const std::vector<PlayNote>& notes);

}  // namespace hepatica
