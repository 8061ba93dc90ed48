// SPDX-License-Identifier: GPL-3.0-or-later
// Where a verb is about to write: refused before the work is done, not after.
#pragma once

#include <filesystem>

namespace hepatica {

// Throws InputError where `place`, which need not exist yet, could not be created: a file stands in
// its way, or the nearest folder above it may not be written to.
void require_writable(const std::filesystem::path& place);

// Throws InputError where `folder` exists and is neither empty nor one that holds `mark`, the file
// by which this program knows its own output: nobody's files are overwritten by a slip of the hand.
void require_own_or_new(const std::filesystem::path& folder, const std::filesystem::path& mark);

}  // namespace hepatica
