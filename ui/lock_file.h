// SPDX-License-Identifier: GPL-3.0-or-later
// Lock files by which running programs tell each other what they use.
#pragma once

#include <QLockFile>
#include <filesystem>
#include <memory>

#include "ui/paths.h"

namespace hepatica {

// Not locked yet: tryLock(0) fails where a running program holds it. It never expires by age; a
// dead owner is recognised by its process id.
inline std::unique_ptr<QLockFile> lock_file(const std::filesystem::path& file) {
    auto lock = std::make_unique<QLockFile>(to_text(file));
    lock->setStaleLockTime(0);
    return lock;
}

}  // namespace hepatica
