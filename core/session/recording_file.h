// SPDX-License-Identifier: GPL-3.0-or-later
// A recording on disk as JSON lines: a header, then one line for each step and each keyframe. Lines
// are only appended, so that a crash leaves everything that was played; the last line may then be
// incomplete, and the reader drops it.
//   {"format": "hepatica-recording", "version": 2, "program": "0.1.0", "back_end": "cpu",
//    "patient_hash": "...", "played_at": "2026-11-23T13:20:05Z", "scene": {...}}
//   {"keyframe": 0, ...}                                 where it began amid a play
//   {"hash": "...", "commands": [...]}
//   {"keyframe": 600, "played_steps": 600, "automatic": false, "world": {...}}
#pragma once

#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/session/recording.h"

namespace hepatica {

// Formats and writes on a thread of its own, so that no step waits for the disk or for the text of
// a keyframe.
class RecordingWriter {
  public:
    // Writes the header, the beginning and the steps of `start`. Replaces an existing file. Throws
    // InputError where it cannot be written.
    RecordingWriter(std::filesystem::path file, const Recording& start);
    ~RecordingWriter();  // writes all steps appended so far
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    // Thread-safe. Never waits for the disk.
    void append(RecordedStep step);
    // Writes all steps appended so far and closes the file. Throws InputError where any step could
    // not be written.
    void close();

  private:
    void write_until_closed();
    void finish() noexcept;

    std::filesystem::path file_;
    std::ofstream out_;
    std::mutex mutex_;  // guards waiting_ and closing_
    std::vector<RecordedStep> waiting_;
    bool closing_ = false;
    std::condition_variable changed_;
    bool failed_ = false;  // belongs to the writing thread until that has ended
    std::jthread thread_;
};

// Writes a whole recording. Throws InputError where it cannot be written.
void write_recording(const std::filesystem::path& file, const Recording& recording);

// When it was played, see Recording::played_at, whichever version wrote it; empty: it does not say,
// or is no recording.
std::string played_at_in(const std::filesystem::path& file);

// What is read of a recording.
enum class RecordingPart {
    header,    // without steps
    commands,  // without keyframes, which are most of the file
    all,
};

// Drops an incomplete last line with a warning. Throws InputError that names file and line where
// any other line is damaged, and where the format or the version of the program is another one,
// because replayed steps would then differ in their last bits. For the back end see
// require_back_end. Throws Cancelled soon after a stop is requested.
Recording read_recording(const std::filesystem::path& file, RecordingPart part = RecordingPart::all,
                         const std::stop_token& stop = {});

}  // namespace hepatica
