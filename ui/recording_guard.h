// SPDX-License-Identifier: GPL-3.0-or-later
// Marks a recording that is being written, by a file beside it that goes when the play ends as it
// should. A mark that nobody holds any more is of a play that a crash or a power cut ended.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class QLockFile;

namespace hepatica {

// UI thread.
class RecordingGuard {
  public:
    explicit RecordingGuard(std::filesystem::path recording);
    ~RecordingGuard();
    RecordingGuard(const RecordingGuard&) = delete;
    RecordingGuard& operator=(const RecordingGuard&) = delete;

  private:
    std::filesystem::path recording_;
    std::unique_ptr<QLockFile> lock_;
};

// Some program writes it now.
bool is_being_recorded(const std::filesystem::path& recording);

// All in the folder, the newest first.
std::vector<std::filesystem::path> recordings_in(const std::filesystem::path& folder);

// Those in the folder that were interrupted and not forgotten, the newest first.
std::vector<std::filesystem::path> interrupted_recordings(const std::filesystem::path& folder);
// It is not offered any more; the recording stays.
void forget_interruption(const std::filesystem::path& recording);

// Those of a lesson, by the beginning of their names, that have no result and that nobody writes
// now, the oldest first.
std::vector<std::filesystem::path> recordings_without_result(const std::filesystem::path& folder,
                                                             const std::string& lesson);

}  // namespace hepatica
