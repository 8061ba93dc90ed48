// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_place.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

void require_writable(const fs::path& place) {
    fs::path above = fs::absolute(place);
    if (!above.has_filename()) above = above.parent_path();
    std::error_code ignored;
    do above = above.parent_path();
    while (!fs::exists(above, ignored) && above.has_relative_path());
    if (!fs::is_directory(above, ignored))
        throw InputError("cannot be created: " + above.string() + " is not a folder",
                         place.string(), "Choose another place");
    if (access(above.c_str(), W_OK | X_OK) != 0)
        throw InputError("cannot be created: " + std::generic_category().message(errno) + " (" +
                             above.string() + ")",
                         place.string(), "Choose a folder that you may write to");
}

void require_own_or_new(const fs::path& folder, const fs::path& mark) {
    if (!fs::exists(folder) || fs::exists(folder / mark)) return;
    if (fs::is_directory(folder) && fs::is_empty(folder)) return;
    throw InputError("is there already and was not made by this verb", folder.string(),
                     "Choose another name or remove it");
}

}  // namespace hepatica
