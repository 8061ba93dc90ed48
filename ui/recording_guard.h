// SPDX-License-Identifier: GPL-3.0-or-later
// Marks a recording while it is being written, by a locked file beside it that is removed when the
// play ends. A mark without a lock belongs to a play that ended by a crash or a power cut. That of
// an attempt at a lesson holds the result that it has then.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class QLockFile;

namespace hepatica {

struct Attempt;

// UI thread only.
class RecordingGuard {
  public:
    explicit RecordingGuard(std::filesystem::path recording);
    ~RecordingGuard();
    RecordingGuard(const RecordingGuard&) = delete;
    RecordingGuard& operator=(const RecordingGuard&) = delete;
    // What the play comes to if it ends by a crash. Throws InputError where that cannot be written.
    void note(const Attempt& if_interrupted);

  private:
    std::filesystem::path recording_;
    std::unique_ptr<QLockFile> lock_;
};

// Whether a running program is writing it.
bool is_being_recorded(const std::filesystem::path& recording);

// All recordings in the folder, the newest first.
std::vector<std::filesystem::path> recordings_in(const std::filesystem::path& folder);

// The interrupted recordings in the folder that were not forgotten, the newest first.
std::vector<std::filesystem::path> interrupted_recordings(const std::filesystem::path& folder);
// Writes the result that the mark of an interrupted attempt holds, unless there is one; it ended
// when the recording did. Throws InputError where that fails.
void keep_interrupted(const std::filesystem::path& recording);
// Removes the mark; the recording stays.
void forget_interruption(const std::filesystem::path& recording);
// As that; of an attempt in which something was done the result and the recording go, too. The
// recording of a free play stays.
void forget_attempt(const std::filesystem::path& recording);

// The recordings called after this lesson and the time, as the window calls those of attempts,
// without result and not being written, the oldest first.
std::vector<std::filesystem::path> recordings_without_result(const std::filesystem::path& folder,
                                                             const std::string& lesson);

}  // namespace hepatica
