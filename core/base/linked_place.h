// SPDX-License-Identifier: GPL-3.0-or-later
// Where a file or folder comes to lie that is written to a link's name: behind the link, which
// stays, also where nothing is there yet.
#pragma once

#include <filesystem>
#include <system_error>

namespace hepatica {

// The place itself where it is no link. Throws InputError for links in a circle, and, naming that
// place, for a link into a folder that is not there, as of a share that is not mounted.
std::filesystem::path place_behind_links(const std::filesystem::path& place);

// Throws the InputError that says why something cannot be written there.
[[noreturn]] void throw_unwritable(const std::filesystem::path& place,
                                   const std::error_code& reason);

}  // namespace hepatica
