// SPDX-License-Identifier: GPL-3.0-or-later
// mkdtemp in the system's folder for temporary files (TMPDIR, else /tmp).
#include "core/base/temporary_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    if (error) {
        const char* wanted = std::getenv("TMPDIR");
        throw InputError("is no folder for temporary files", wanted ? wanted : "/tmp",
                         "Make that folder, or let TMPDIR name one that is there");
    }
    std::string name = (parent / "hepatica-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw InputError("no temporary folder can be made", name, "Free some space there");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace hepatica
