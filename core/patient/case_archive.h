// SPDX-License-Identifier: GPL-3.0-or-later
// A case in one file, NAME.hepz: a zip archive of the files of a case's folder, as any zip program
// reads and writes it. Names no folders, and knows nothing of what the files mean.
//
// An archive may come from anybody. Refused are names that are not plain ones (a folder, "..", a
// leading dot, anything but letters, digits, "_", "-" and "."), a name that comes twice,
// encryption, a wrong checksum, and bombs: more than 64 files, more than 4 GiB unpacked, or more
// than a hundredfold of the archive beyond 16 MiB (a case's own files shrink to a third at best).
// Sizes are counted while unpacking, whatever the archive claims.
#pragma once

#include <filesystem>

namespace hepatica {

// Named as one, whether it exists or not: ends in .hepz, in capitals or not.
bool is_archive_name(const std::filesystem::path& place);

// A file of that name that is there. Says nothing about whether it can be read.
bool is_case_archive(const std::filesystem::path& place);

// The archive holds a file of this name. False where it cannot be read.
bool archive_holds(const std::filesystem::path& archive, const char* name);

// Unpacks into an empty folder. Throws InputError that names the archive and the reason; what was
// unpacked until then is left in the folder.
void unpack_case(const std::filesystem::path& archive, const std::filesystem::path& folder);

// Packs the files of a folder, which holds no folders, into `archive`, which appears whole or not
// at all; one that stood there is replaced. The same files give the same bytes. Throws InputError
// where it cannot be written.
void pack_case(const std::filesystem::path& folder, const std::filesystem::path& archive);

}  // namespace hepatica
