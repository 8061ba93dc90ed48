// SPDX-License-Identifier: GPL-3.0-or-later
// Tells programs of this and other computers which case this one has open, by a hidden lock file
// beside it (.NAME.hep.lock). It keeps nobody from anything: who opens the case as well is told.
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

class QLockFile;

namespace hepatica {

// UI thread only.
class CaseLock {
  public:
    CaseLock();
    ~CaseLock();

    // Marks this case as open and the former one no longer; empty: none. Returns the computer whose
    // program has it open already, once for each time that it becomes the present case; else
    // nullopt, also where nothing can be written beside it. To be called again from time to time:
    // the other program may end. One that died on this computer does not count.
    std::optional<QString> follow(const std::filesystem::path& place);

  private:
    std::filesystem::path place_;
    std::unique_ptr<QLockFile> lock_;
};

}  // namespace hepatica
