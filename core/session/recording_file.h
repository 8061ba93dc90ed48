// SPDX-License-Identifier: GPL-3.0-or-later
// A recording on disk: JSON lines, a header, then one line per step and one per keyframe. It grows
// as the session goes and is never rewritten, so that a program that dies leaves all that was
// played; the line that it was writing may be torn and is dropped when the file is read.
//   {"format": "hepatica-recording", "version": 2, "program": "0.1.0", "back_end": "cpu",
//    "patient_hash": "...", "scene": {...}}
//   {"hash": "...", "commands": [...]}
//   {"keyframe": 600, "played_steps": 600, "automatic": false, "world": {...}}
#pragma once

#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <thread>
#include <vector>

#include "core/session/recording.h"

namespace hepatica {

// Writes on a thread of its own, so that no step waits for a disk or for a keyframe to be spelt
// out.
class RecordingWriter {
  public:
    // Begins the file with the header of `start` and its steps; what stood there before is gone.
    // Throws InputError where it cannot be written.
    RecordingWriter(std::filesystem::path file, const Recording& start);
    ~RecordingWriter();  // writes what waits
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    // Any thread. Never waits for the disk.
    void append(RecordedStep step);
    // Writes what waits and ends the file. Throws InputError where any of it could not be written.
    void close();

  private:
    void write_until_closed();
    void finish() noexcept;

    std::filesystem::path file_;
    std::ofstream out_;
    std::mutex mutex_;  // of the next two
    std::vector<RecordedStep> waiting_;
    bool closing_ = false;
    std::condition_variable changed_;
    bool failed_ = false;  // the writing thread's, until it has ended
    std::jthread thread_;
};

// The same at once.
void write_recording(const std::filesystem::path& file, const Recording& recording);

// A torn last line is dropped, and a warning says so. Throws InputError that names the file and the
// line where any other line is damaged, or where the recording is of another format, of another
// version of the program, or of a back end that this program does not have: their steps would not
// have the same bits.
Recording read_recording(const std::filesystem::path& file);

}  // namespace hepatica
