// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/kept_files.h"

#include <system_error>

#include "core/base/atomic_write.h"
#include "core/base/text_file.h"

namespace hepatica {

namespace fs = std::filesystem;

KeptFiles::KeptFiles(const fs::path& folder, std::span<const char* const> names) {
    for (const char* name : names)
        if (std::error_code ignored; fs::exists(folder / name, ignored))
            bytes_[name] = read_text_file(folder / name, "Check that it exists and may be read");
}

void KeptFiles::write_to(const fs::path& folder) const {
    for (const auto& [name, bytes] : bytes_) write_text_atomically(folder / name, bytes);
}

}  // namespace hepatica
