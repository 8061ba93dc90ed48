// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the file for a running program's unsaved lesson; programs that run at once use different
// files.
#pragma once

#include <filesystem>
#include <memory>

class QLockFile;

namespace hepatica {

// Holds the file from construction to destruction by a lock file beside it. A lock left by a crash
// is ignored.
class DraftSlot {
  public:
    // `first` is the first file tried, "unsaved-lesson.json"; then come "unsaved-lesson-2.json" and
    // so on up to 64. Files left by an ended program are taken before free names. Empty: no file.
    explicit DraftSlot(const std::filesystem::path& first);
    ~DraftSlot();

    // Empty if no file can be locked; then no copy is kept, so that none is overwritten.
    const std::filesystem::path& file() const { return file_; }

  private:
    bool take(const std::filesystem::path& file);

    std::filesystem::path file_;
    std::unique_ptr<QLockFile> lock_;
};

}  // namespace hepatica
