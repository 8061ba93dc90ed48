// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/linked_place.h"

#include <cerrno>

#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

void throw_unwritable(const fs::path& target, const std::error_code& reason) {
    if (reason.value() == ENOSPC || reason.value() == EDQUOT)
        throw InputError("cannot be written: the disk is full", target.string(),
                         "Free some space there, or choose another folder");
    throw InputError("cannot be written (" + reason.message() + ")", target.string(),
                     "Check that the folder exists, may be written and has free space");
}

fs::path place_behind_links(const fs::path& target) {
    constexpr int most_links = 40;  // as many as the system follows
    std::error_code error;
    fs::path place = target;
    int links = 0;
    for (; fs::is_symlink(fs::symlink_status(place, error)); ++links) {
        if (links == most_links)
            throw_unwritable(target,
                             std::make_error_code(std::errc::too_many_symbolic_link_levels));
        const fs::path next = fs::read_symlink(place, error);
        if (error) throw_unwritable(target, error);
        place = place.parent_path() / next;
    }
    const fs::path real = fs::weakly_canonical(place, error);
    if (error) return fs::absolute(target);
    if (links > 0 && !fs::exists(fs::absolute(real).parent_path(), error))
        throw_unwritable(real, std::make_error_code(std::errc::no_such_file_or_directory));
    return real;
}

}  // namespace hepatica
