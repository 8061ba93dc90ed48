// SPDX-License-Identifier: GPL-3.0-or-later
// Where a verb is about to write: refused before the work is done, not after.
#pragma once

#include <filesystem>

namespace hepatica {

// Throws InputError where `place`, which need not exist yet, could not be created: a file stands in
// its way, or the nearest folder above it may not be written to. One folder above it may be missing
// and is made with it, which is logged (out/ in out/p1.hep); where more are missing the path is
// more likely mistyped, and is refused.
void require_writable(const std::filesystem::path& place);

// The same for a folder that a verb puts its files into, which may be there already.
void require_writable_folder(const std::filesystem::path& folder);

// Throws InputError where `folder` exists and is anything but an empty folder.
void require_empty_or_new(const std::filesystem::path& folder);

// Throws UsageError where `place` is named like another file: a case is a folder, NAME.hep or
// without an extension, or one file, NAME.hepz.
void require_case_name(const std::filesystem::path& place);

// All that a verb asks before it makes a case: its name, that it can be written, and that nothing
// but an older case stands there. Throws as require_case_name(), require_writable() and
// require_own_or_new().
void require_case_place(const std::filesystem::path& place);

// Throws UsageError where `file` does not end in .png, in capitals or not.
void require_png_name(const std::filesystem::path& file);

// Throws InputError where `folder` exists and is neither empty nor one that holds `mark`, the file
// by which this program knows its own output: nobody's files are overwritten by a slip of the hand.
void require_own_or_new(const std::filesystem::path& folder, const std::filesystem::path& mark);

}  // namespace hepatica
