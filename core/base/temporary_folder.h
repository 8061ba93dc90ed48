// SPDX-License-Identifier: GPL-3.0-or-later
// A new folder among the system's temporary files, removed with all that is in it at the end.
#pragma once

#include <filesystem>

namespace hepatica {

class TemporaryFolder {
  public:
    // Throws InputError where none can be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace hepatica
