// SPDX-License-Identifier: GPL-3.0-or-later
// Files and folders that appear complete or not at all: written beside their target under a
// temporary name, then renamed. On any exception the temporary is removed and the previous content
// stays. Links are followed: their target is replaced, or made where nothing is yet. What an
// InputError of a writer names below the temporary is named as what it would have become.
// What a writer that was killed has left is removed by the next one (core/base/leftovers.h).
// Thread-safe, also between programs and for the same target: the last writer wins with its
// complete content.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace hepatica {

// Calls write(temporary_path), which must create that file, then renames it to `file`. The
// temporary keeps the extension of `file`, because many writers choose their format by it. Missing
// parent folders are created, but not those of a link's target. A device, a pipe or a socket is
// written into once the temporary is complete, and stays. Throws InputError, naming `file` or where
// its link leads, if the folder cannot be written, the disk is full, or nobody reads a pipe.
void write_file_atomically(const std::filesystem::path& file,
                           const std::function<void(const std::filesystem::path&)>& write);

// The same for a text in memory.
void write_text_atomically(const std::filesystem::path& file, std::string_view text);

// Calls write(temporary_folder) with an empty folder, then renames it to `folder`, replacing an
// existing folder with all its content: only for the program's own folders. Throws InputError as
// above, and where a file has that name.
void write_folder_atomically(const std::filesystem::path& folder,
                             const std::function<void(const std::filesystem::path&)>& write);

// The same for a folder that may contain foreign files: files for which is_own(path relative to the
// folder) is false, and that are not written anew, are kept. They are moved once the new folder is
// in place; one that cannot be moved is named in an InputError and stays in the temporary folder,
// which is then not removed.
void renew_folder_atomically(const std::filesystem::path& folder,
                             const std::function<void(const std::filesystem::path&)>& write,
                             const std::function<bool(const std::filesystem::path& below)>& is_own);

// Calls write(temporary_folder) with an empty folder, then moves its files into `folder`, in the
// order of their names. Other files there stay; older files of these names are replaced, and links
// followed. A device, a pipe or a socket of such a name is written into after all others, and
// stays. If write() throws, nothing is, and a folder that was missing is not left behind; if a move
// fails, those before it are undone as far as the file system lets them. Not one step: a reader in
// between, or a crash, finds some files of either kind. Throws InputError as above.
void write_files_atomically(const std::filesystem::path& folder,
                            const std::function<void(const std::filesystem::path&)>& write);

}  // namespace hepatica
