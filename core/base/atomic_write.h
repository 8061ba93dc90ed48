// SPDX-License-Identifier: GPL-3.0-or-later
// Files and folders that appear whole or not at all: written beside their place under a temporary
// name, then renamed. On any exception the temporary is removed and what stood there before stays.
// A link is followed: what it points to is replaced. Calls from several threads or programs, also
// for one place, do not disturb each other: the last one wins, whole.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace hepatica {

// Calls write(temporary_path), which must create that file, then renames it to `file`. The
// temporary keeps the extension(s) of `file`, which many writers choose their format by.
// Throws InputError, naming `file`, where the folder cannot be written or the disk is full.
void write_file_atomically(const std::filesystem::path& file,
                           const std::function<void(const std::filesystem::path&)>& write);

// The same for a text already in memory.
void write_text_atomically(const std::filesystem::path& file, std::string_view text);

// Calls write(temporary_folder), an empty folder, then renames it to `folder`, replacing a folder
// that stood there with all that was in it: for folders of the program's own. Throws InputError as
// above.
void write_folder_atomically(const std::filesystem::path& folder,
                             const std::function<void(const std::filesystem::path&)>& write);

// The same for a folder into which others may put files: those for which is_own(path below the
// folder) is false, and that are not written anew, stay. They follow once the new folder is there;
// one that cannot is named in an InputError and lies in the temporary folder, which then stays.
void renew_folder_atomically(const std::filesystem::path& folder,
                             const std::function<void(const std::filesystem::path&)>& write,
                             const std::function<bool(const std::filesystem::path& below)>& is_own);

// Calls write(temporary_folder), an empty folder, then moves the files in it into `folder`, in the
// order of their names, beside what else is there; older files of these names are replaced. On an
// exception none is. Throws InputError as above.
void write_files_atomically(const std::filesystem::path& folder,
                            const std::function<void(const std::filesystem::path&)>& write);

}  // namespace hepatica
