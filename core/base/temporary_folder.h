// SPDX-License-Identifier: GPL-3.0-or-later
// A new folder among the system's temporary files, removed with its content by the destructor.
#pragma once

#include <filesystem>

namespace hepatica {

class TemporaryFolder {
  public:
    // Throws InputError if no folder can be created.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace hepatica
