// SPDX-License-Identifier: GPL-3.0-or-later
// Which file a running program keeps its unsaved lesson in: one of its own, however many run.
#pragma once

#include <filesystem>
#include <memory>

class QLockFile;

namespace hepatica {

// Holds the file from the constructor on, by a lock beside it that a crash leaves free.
class DraftSlot {
  public:
    // `first`: "unsaved-lesson.json"; the next ones are "unsaved-lesson-2.json" and so on. A file
    // that a program left behind comes before a free name. `first` empty: none is kept.
    explicit DraftSlot(const std::filesystem::path& first);
    ~DraftSlot();

    // Empty where no file can be locked: a copy is not kept then, rather than one overwritten.
    const std::filesystem::path& file() const { return file_; }

  private:
    bool take(const std::filesystem::path& file);

    std::filesystem::path file_;
    std::unique_ptr<QLockFile> lock_;
};

}  // namespace hepatica
