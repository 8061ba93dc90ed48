// SPDX-License-Identifier: GPL-3.0-or-later
// fsync(), which some file systems do not offer.
#include "core/base/flush_to_disk.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"

namespace hepatica {

void flush_to_disk(const std::filesystem::path& file, const std::filesystem::path& written_as) {
    const int opened = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    int reason = opened < 0 || fsync(opened) != 0 ? errno : 0;
    if (reason == EINVAL || reason == ENOSYS)
        reason = 0;  // the file system has nothing to wait for
    if (opened >= 0) close(opened);
    if (reason == 0) return;
    throw InputError("cannot be written (" + std::generic_category().message(reason) + ")",
                     written_as.string(),
                     "Check that the folder exists, may be written and has free space");
}

}  // namespace hepatica
