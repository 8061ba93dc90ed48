// SPDX-License-Identifier: GPL-3.0-or-later
// Lock files by which running programs tell each other what they use.
#pragma once

#include <QFile>
#include <QLockFile>
#include <QSysInfo>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "ui/paths.h"

namespace hepatica {

// Whether a process of this computer has ended although its id is still in use, because its parent
// has not asked for its exit status yet (state Z of proc(5)).
inline bool is_zombie(qint64 process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string stat;
    std::getline(file, stat);
    const std::size_t name_end = stat.rfind(')');  // "ID (NAME) STATE", with any name
    return name_end != std::string::npos && stat.compare(name_end, 3, ") Z") == 0;
}

// Not locked yet: tryLock(0) fails where a running program holds it. It never expires by age; a
// dead owner is recognised by its process id.
inline std::unique_ptr<QLockFile> lock_file(const std::filesystem::path& file) {
    auto lock = std::make_unique<QLockFile>(to_text(file));
    lock->setStaleLockTime(0);
    qint64 owner = 0;
    QString computer, program;
    if (lock->getLockInfo(&owner, &computer, &program) && computer == QSysInfo::machineHostName() &&
        is_zombie(owner)) {
        // QLockFile takes it for a running program's. Another program may be taking it just now.
        QLockFile removing(to_text(file) + ".dead");
        qint64 now = 0;
        if (removing.tryLock(0) && lock->getLockInfo(&now, &computer, &program) && now == owner)
            QFile::remove(to_text(file));
    }
    return lock;
}

}  // namespace hepatica
