// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a case in memory, byte for byte as they lay on disk: a patient who was read without
// his voxels keeps theirs so (half a megabyte for the built-in patient), and can be saved wherever
// his case has gone meanwhile.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace hepatica {

class KeptFiles {
  public:
    // Those of these files that the folder holds. Throws InputError where one cannot be read.
    KeptFiles(const std::filesystem::path& folder, std::span<const char* const> names);

    // Writes them into a folder. Throws InputError where that is not possible.
    void write_to(const std::filesystem::path& folder) const;

  private:
    std::map<std::string, std::string> bytes_;  // by name
};

}  // namespace hepatica
