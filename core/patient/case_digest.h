// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether the case at a place is still the one that was read or written there: other people
// and programs may save into the same folder.
#pragma once

#include <filesystem>
#include <string>

namespace hepatica {

// SHA-256 of what the case holds: of case.json, which has the digests of the other files, and of
// what was measured by hand. A dial, which any program may measure anew, and files of others have
// no part in it. Empty where no case is, "unreadable" where one cannot be read.
std::string digest_of_case(const std::filesystem::path& place);

}  // namespace hepatica
