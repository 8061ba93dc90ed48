// SPDX-License-Identifier: GPL-3.0-or-later
// A case in one file, NAME.hepz: a zip archive of the files of a case's folder, as any zip program
// reads and writes it. It holds no folders. This code does not know what the files mean.
//
// An archive may come from anybody. Refused are names that are not plain ones (a folder, "..", a
// leading dot, anything but letters, digits, "_", "-" and "."), duplicate names, encryption, a
// wrong checksum, and zip bombs: more than 64 files, more than 4 GiB unpacked, or more than a
// hundred times the archive's size beyond 16 MiB (a case's own files shrink to a third at best).
// Sizes are counted while unpacking, whatever the archive claims.
#pragma once

#include <cstddef>
#include <filesystem>

namespace hepatica {

inline constexpr std::size_t most_files_of_archive = 64;

// Whether the name is that of an archive: ends in .hepz, in any case. The file need not exist.
bool is_archive_name(const std::filesystem::path& place);

// Whether this is an existing file with such a name; it may still be unreadable.
bool is_case_archive(const std::filesystem::path& place);

// Throws InputError where a folder has the archive's name. To be called before long work.
void require_no_folder_at(const std::filesystem::path& archive);

// Whether the archive holds a file of this name; false where it cannot be read.
bool archive_holds(const std::filesystem::path& archive, const char* name);

// Unpacks into an empty folder. Throws InputError with the archive and the reason; files unpacked
// before that stay in the folder.
void unpack_case(const std::filesystem::path& archive, const std::filesystem::path& folder);

// Packs the files of a folder without subfolders into `archive`, replacing it atomically. The same
// files give the same bytes. Throws InputError where it cannot be written.
void pack_case(const std::filesystem::path& folder, const std::filesystem::path& archive);

}  // namespace hepatica
