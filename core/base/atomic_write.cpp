// SPDX-License-Identifier: GPL-3.0-or-later
// Temporaries beside the target, renames, and an exchange of folders by renameat2 where possible.
#include "core/base/atomic_write.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <deque>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/base/leftovers.h"
#include "core/base/linked_place.h"
#include "core/base/special_file.h"
#include "core/base/temporary_folder.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// The path of a temporary file or folder; removed at the end unless it is kept.
class Temporary {
  public:
    explicit Temporary(const fs::path& target)
        : path_(fs::absolute(target).parent_path() / temporary_name(target)) {}
    ~Temporary() {
        std::error_code ignored;
        if (!kept_) fs::remove_all(path_, ignored);
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    const fs::path& path() const { return path_; }
    void keep(bool kept) { kept_ = kept; }

  private:
    fs::path path_;
    bool kept_ = false;
};

fs::path without_trailing_slash(const fs::path& path) {
    return path.has_filename() ? path : path.parent_path();
}

// Calls write(temporary). What an error names below the hidden temporary, which is gone by then, is
// named as what it would have become.
void write_as(const fs::path& target, const fs::path& temporary,
              const std::function<void(const fs::path&)>& write) {
    try {
        write(temporary);
    } catch (const InputError& error) {
        const std::string hidden = temporary.string();
        if (!error.place().starts_with(hidden)) throw;
        throw InputError(error.problem(), target.string() + error.place().substr(hidden.size()),
                         error.remedy());
    }
}

// Writes among the temporary files first, because many writers go back in what they write.
void write_into(const fs::path& special, const std::function<void(const fs::path&)>& write) {
    const TemporaryFolder folder;
    const fs::path whole = folder.path() / special.filename();
    write_as(special, whole, write);
    if (const std::error_code error = write_into_special_file(whole, special))
        throw_unwritable(special, error);
}

// Exchanges `fresh` and `old`, in one step if the file system supports it. Otherwise `old` is moved
// aside first, and back if `fresh` cannot take its place.
void exchange(const fs::path& fresh, const fs::path& old, std::error_code& error) {
    if (renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0) return;
    const fs::path aside = fresh.string() + ".old";
    fs::rename(old, aside, error);
    if (error) return;
    fs::rename(fresh, old, error);
    std::error_code ignored;
    fs::rename(aside, error ? old : fresh, ignored);
}

// Who may read and write the old file or folder, and nobody else, may do so with what replaces it.
// A folder that its owner may not write is left out: foreign files have to come back into it. What
// its writer has closed to all others stays closed.
void take_permissions(const fs::path& old, const fs::path& fresh) {
    std::error_code ignored;
    constexpr fs::perms of_others = fs::perms::group_all | fs::perms::others_all;
    if ((fs::status(fresh, ignored).permissions() & of_others) == fs::perms::none) return;
    const fs::file_status was = fs::status(old, ignored);
    const bool open_folder =
        fs::is_directory(was) && (was.permissions() & fs::perms::owner_all) == fs::perms::owner_all;
    if (fs::is_regular_file(was) || open_folder) fs::permissions(fresh, was.permissions(), ignored);
}

bool any_file(const fs::path&) {
    return true;
}

void make_parent(const fs::path& target) {
    std::error_code error;
    fs::create_directories(fs::absolute(target).parent_path(), error);
    if (error) throw_unwritable(target, error);
}

}  // namespace

void write_file_atomically(const fs::path& target,
                           const std::function<void(const fs::path&)>& write) {
    if (is_special_file(target)) return write_into(target, write);
    const fs::path file = place_behind_links(target);
    make_parent(file);
    const Temporary temporary(file);
    write_as(target, temporary.path(), write);
    take_permissions(file, temporary.path());
    std::error_code error;
    fs::rename(temporary.path(), file, error);
    if (error) throw_unwritable(target, error);
    sweep_leftovers(file, any_file);
}

void write_text_atomically(const fs::path& file, std::string_view text) {
    write_file_atomically(file, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
        out.flush();
        if (!out) throw_unwritable(temporary, std::error_code(errno, std::generic_category()));
    });
}

namespace {

// Moves all files that are not the program's own from the folder `was` to `is`, unless they exist
// there. Returns the first that could not be moved.
std::optional<fs::path> move_foreign(const fs::path& was, const fs::path& is,
                                     const std::function<bool(const fs::path&)>& is_own) {
    std::vector<fs::path> files;
    std::error_code unreadable;
    for (fs::recursive_directory_iterator entry(was, unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable))
        if (entry->is_symlink() || !entry->is_directory())
            files.push_back(entry->path().lexically_relative(was));
    if (unreadable) return was;
    for (const fs::path& file : files) {
        if (is_own(file) || fs::exists(fs::symlink_status(is / file))) continue;
        std::error_code error;
        fs::create_directories((is / file).parent_path(), error);
        fs::rename(was / file, is / file, error);
        if (error) return was / file;
    }
    return std::nullopt;
}

void replace_folder(const fs::path& target, const std::function<void(const fs::path&)>& write,
                    const std::function<bool(const fs::path&)>& is_own) {
    const fs::path folder = place_behind_links(without_trailing_slash(target));
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))  // it would be moved aside
        throw_unwritable(target, std::make_error_code(std::errc::not_a_directory));
    make_parent(folder);
    Temporary temporary(folder);
    error.clear();
    fs::create_directory(temporary.path(), error);
    if (error) throw_unwritable(target, error);
    take_permissions(folder, temporary.path());
    write_as(without_trailing_slash(target), temporary.path(), write);
    const bool replaces = fs::exists(folder);
    if (replaces)  // rename() cannot replace a folder that is not empty
        exchange(temporary.path(), folder, error);
    else
        fs::rename(temporary.path(), folder, error);
    if (error) throw_unwritable(target, error);
    sweep_leftovers(folder, is_own);
    if (!replaces) return;
    temporary.keep(true);  // from here on no foreign file may be removed, whatever fails
    if (const auto left = move_foreign(temporary.path(), folder, is_own))
        throw InputError("was in the folder and could not be put back into it", left->string(),
                         "Move it to " + target.string() + " by hand");
    temporary.keep(false);
}

}  // namespace

void write_folder_atomically(const fs::path& target,
                             const std::function<void(const fs::path&)>& write) {
    replace_folder(target, write, any_file);
}

void renew_folder_atomically(const fs::path& target,
                             const std::function<void(const fs::path&)>& write,
                             const std::function<bool(const fs::path&)>& is_own) {
    replace_folder(target, write, is_own);
}

namespace {

// A folder, made with those above it that are missing. The destructor removes what was made and is
// empty, unless it is kept.
class MadeFolder {
  public:
    explicit MadeFolder(const fs::path& folder) {
        std::error_code error;
        const auto missing = [&](const fs::path& path) {
            return fs::symlink_status(path, error).type() == fs::file_type::not_found;
        };
        const fs::path whole = fs::absolute(folder, error);
        if (error) throw_unwritable(folder, error);
        for (fs::path at = without_trailing_slash(whole); missing(at); at = at.parent_path())
            made_.push_back(at);
        error.clear();
        fs::create_directories(folder, error);
        if (error) throw_unwritable(folder, error);
    }
    ~MadeFolder() {
        for (const fs::path& path : made_) rmdir(path.c_str());
    }
    MadeFolder(const MadeFolder&) = delete;
    MadeFolder& operator=(const MadeFolder&) = delete;

    void keep() { made_.clear(); }

  private:
    std::vector<fs::path> made_;  // the lowest first
};

// A finished file and the place it goes to.
struct Move {
    fs::path fresh;
    fs::path target;
    bool replaces = false;  // an older file, which is then at `fresh`
    bool special = false;   // the target is a pipe or a device, which is written into
};

void make(const Move& move, std::error_code& error) {
    if (move.special)
        error = write_into_special_file(move.fresh, move.target);
    else if (move.replaces)
        exchange(move.fresh, move.target, error);
    else
        fs::rename(move.fresh, move.target, error);
}

void undo(const Move& move) {
    std::error_code ignored;
    if (move.special) return;  // what a pipe or a device took does not come back
    if (move.replaces)
        exchange(move.fresh, move.target, ignored);
    else
        fs::rename(move.target, move.fresh, ignored);
}

// The move of a finished file to `place`. A link may lead to another file system: what goes there
// is copied beside its target first.
Move move_of(const fs::path& file, const fs::path& place, std::deque<Temporary>& beside_links) {
    std::error_code error;
    if (is_special_file(place) && !fs::is_directory(file, error))
        return {.fresh = file, .target = place, .special = true};
    Move move{file, place_behind_links(place)};
    if (fs::is_symlink(fs::symlink_status(place, error))) {
        move.fresh = beside_links.emplace_back(move.target).path();
        fs::copy(file, move.fresh, fs::copy_options::recursive, error);
        if (error) throw_unwritable(place, error);
    }
    // A folder is never exchanged: what it holds would be removed with the temporary.
    move.replaces = fs::exists(move.target, error) && !fs::is_directory(move.target, error) &&
                    !fs::is_directory(file, error);
    if (move.replaces) take_permissions(move.target, move.fresh);
    return move;
}

// Makes all moves, or undoes those made and throws.
void make_all(const std::vector<Move>& moves) {
    for (std::size_t i = 0; i < moves.size(); ++i) {
        std::error_code error;
        make(moves[i], error);
        if (!error) continue;
        for (std::size_t made = i; made > 0; --made) undo(moves[made - 1]);
        throw_unwritable(moves[i].target, error);
    }
}

}  // namespace

void write_files_atomically(const fs::path& folder,
                            const std::function<void(const fs::path&)>& write) {
    MadeFolder made(folder);
    std::error_code error;
    const Temporary temporary(folder / "files");  // on the file system of `folder`
    fs::create_directory(temporary.path(), error);
    if (error) throw_unwritable(folder, error);
    write_as(without_trailing_slash(folder), temporary.path(), write);
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(temporary.path()))
        files.push_back(entry.path());
    std::ranges::sort(files);
    std::deque<Temporary> beside_links;
    std::vector<Move> moves;
    for (const fs::path& file : files)
        moves.push_back(move_of(file, folder / file.filename(), beside_links));
    // Last, because they cannot be undone.
    std::stable_partition(moves.begin(), moves.end(), [](const Move& m) { return !m.special; });
    make_all(moves);
    sweep_leftovers(folder / "files", any_file);
    made.keep();
}

}  // namespace hepatica
