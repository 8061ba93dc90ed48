// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case_lock.h"

#include <system_error>
#include <utility>

#include "ui/lock_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// The same for every link to the case.
fs::path lock_beside(const fs::path& place) {
    std::error_code unreadable;
    const fs::path real = fs::weakly_canonical(place, unreadable);
    const fs::path& whole = unreadable ? place : real;
    return whole.parent_path() / ("." + whole.filename().string() + ".lock");
}

}  // namespace

CaseLock::CaseLock() = default;

CaseLock::~CaseLock() = default;

std::optional<QString> CaseLock::follow(const fs::path& place) {
    const bool is_new = std::exchange(place_, place) != place;
    if (is_new) lock_.reset();
    if (place.empty() || lock_) return std::nullopt;
    std::unique_ptr<QLockFile> lock = lock_file(lock_beside(place));
    if (lock->tryLock(0)) {
        lock_ = std::move(lock);
        return std::nullopt;
    }
    if (!is_new || lock->error() != QLockFile::LockFailedError) return std::nullopt;
    qint64 process = 0;
    QString computer, program;
    if (!lock->getLockInfo(&process, &computer, &program)) return std::nullopt;
    return computer;
}

}  // namespace hepatica
