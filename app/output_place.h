// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of the place that a verb will write to, made before its work is done.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hepatica {

struct PatientCase;

// Throws InputError where `place`, which need not exist yet, could not be created: because a file
// is in the way, or the nearest existing folder above it is not writable. One missing folder above
// it is accepted, and logged, because it is made with it (out/ in out/p1.hep); where more are
// missing the path is probably mistyped, and is refused.
void require_writable(const std::filesystem::path& place);

// The same for a file in the format of this ending (".csv"), and throws UsageError where its name
// has another ending, and InputError where a folder has that name. A name without an ending is
// accepted, and so is a device, a pipe or a socket, which is written into
// (core/base/atomic_write.h).
void require_writable_file(const std::filesystem::path& file, const std::string& ending);

// The same for a file that grows while its work goes on, and throws InputError for a device, a pipe
// or a socket: opening a pipe waits for its reader, who may never come.
void require_growing_file(const std::filesystem::path& file, const std::string& ending);

// Throws UsageError where two of these files, to write or to read, are one: the last would
// overwrite the first. Empty paths are none; devices and pipes take several.
void require_different(const std::vector<std::filesystem::path>& files);

// The same as require_writable() for a folder that a verb writes files into, and that may exist.
void require_writable_folder(const std::filesystem::path& folder);

// Throws InputError where `folder` exists and is not an empty folder.
void require_empty_or_new(const std::filesystem::path& folder);

// Throws UsageError where `place` has the extension of another file type: a case is a folder,
// NAME.hep or without an extension, or one file, NAME.hepz.
void require_case_name(const std::filesystem::path& place);

// All checks before a case is made: its name, that it can be written, and that only an older case
// may be replaced. Throws as require_case_name(), require_writable() and require_place_of_case().
void require_case_place(const std::filesystem::path& place);

// Throws InputError where a case cannot take the place of what is there, and warns of the
// corrections that an older case holds: they end with it. To be called before the long work.
void require_replaceable_case(const std::filesystem::path& place);

// What an option --replace of a verb that makes a case does.
inline constexpr const char* replace_help =
    "Replace the case in its place also where it is of another patient";

// Throws InputError where `place` holds the case of another patient, or one that does not tell or
// cannot be read, unless it may be replaced.
void require_same_patient_at(const std::filesystem::path& place, const PatientCase& patient,
                             bool may_replace);

// Whether what is written to `out`, empty for the place itself, replaces the case at `place`.
bool is_in_place(const std::filesystem::path& out, const std::filesystem::path& place);

// Throws InputError where the case at `place` is not the one any more that was read there, by its
// digest_of_case() of before the reading: another program has saved in between.
void require_as_read(const std::filesystem::path& place, const std::string& digest);

// Throws UsageError where `file` does not end in .png, in any case.
void require_png_name(const std::filesystem::path& file);

// Throws InputError where `folder` exists, is not empty and does not contain `mark`, the file by
// which this program recognises its own output. So no other files are overwritten by mistake.
void require_own_or_new(const std::filesystem::path& folder, const std::filesystem::path& mark);

}  // namespace hepatica
