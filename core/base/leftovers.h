// SPDX-License-Identifier: GPL-3.0-or-later
// Temporaries that a killed writer left beside its target (core/base/atomic_write.h): their names
// say which process of which computer writes them, so that the next writer can remove those of dead
// ones.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace hepatica {

// A new name for a temporary beside the target, hidden, different for every call. It ends like the
// target's, of which it takes the last hundred bytes.
std::string temporary_name(const std::filesystem::path& target);

// To be called once `written` is there whole. Removes beside it what dead writers of it left, and
// files that they left of other targets, if those are there, too: else it may be the only copy. Of
// a folder only files go for which is_own(path below it) is true, and the folder once it is empty:
// a killed writer may not have moved files of others back into the target yet. What a writer has
// moved aside stays. Dead is a process of this computer that has ended; of another computer, from
// before this one was started, and of older programs, what has not changed for a week. Errors are
// ignored. Thread-safe.
void sweep_leftovers(const std::filesystem::path& written,
                     const std::function<bool(const std::filesystem::path& below)>& is_own);

}  // namespace hepatica
