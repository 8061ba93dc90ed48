// SPDX-License-Identifier: GPL-3.0-or-later
// A file system tells of quotas, and of what it keeps for root, only to those who write.
#include "core/base/room_on_disk.h"

#include <string>

#include "core/base/atomic_write.h"
#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

void require_room(const fs::path& folder, std::size_t bytes) {
    try {
        write_files_atomically(folder, [bytes](const fs::path& temporary) {
            const fs::path tried = temporary / "tried";
            write_text_atomically(tried, std::string(bytes, ' '));
            fs::remove(tried);
        });
    } catch (const InputError& error) {
        throw InputError(error.problem(), folder.string(), error.remedy());
    }
}

}  // namespace hepatica
