// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/atomic_write.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "core/base/error.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// Removes what it names unless told that the work succeeded.
class Temporary {
  public:
    explicit Temporary(const fs::path& target)
        : path_(fs::absolute(target).parent_path() /
                (".hepatica-" + std::to_string(getpid()) + "-" + target.filename().string())) {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ~Temporary() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

fs::path without_trailing_slash(const fs::path& path) {
    return path.has_filename() ? path : path.parent_path();
}

[[noreturn]] void throw_unwritable(const fs::path& target, const std::error_code& reason) {
    throw InputError("cannot be written (" + reason.message() + ")", target.string(),
                     "Check that the folder exists, may be written and has free space");
}

void make_parent(const fs::path& target) {
    std::error_code error;
    fs::create_directories(fs::absolute(target).parent_path(), error);
    if (error) throw_unwritable(target, error);
}

}  // namespace

void write_file_atomically(const fs::path& file,
                           const std::function<void(const fs::path&)>& write) {
    make_parent(file);
    const Temporary temporary(file);
    write(temporary.path());
    std::error_code error;
    fs::rename(temporary.path(), file, error);
    if (error) throw_unwritable(file, error);
}

void write_text_atomically(const fs::path& file, std::string_view text) {
    write_file_atomically(file, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
        out.flush();
        if (!out) throw_unwritable(file, std::error_code(errno, std::generic_category()));
    });
}

void write_folder_atomically(const fs::path& target,
                             const std::function<void(const fs::path&)>& write) {
    const fs::path folder = without_trailing_slash(target);
    make_parent(folder);
    const Temporary temporary(folder);
    std::error_code error;
    fs::create_directory(temporary.path(), error);
    if (error) throw_unwritable(folder, error);
    write(temporary.path());

    // A folder cannot be renamed over a full one: the old one steps aside first and comes back
    // if the new one cannot take its place.
    const fs::path aside = temporary.path().string() + ".old";
    const bool replaces = fs::exists(folder);
    if (replaces) fs::rename(folder, aside, error);
    if (error) throw_unwritable(folder, error);
    fs::rename(temporary.path(), folder, error);
    if (error) {
        std::error_code ignored;
        if (replaces) fs::rename(aside, folder, ignored);
        throw_unwritable(folder, error);
    }
    if (replaces) fs::remove_all(aside, error);
}

}  // namespace hepatica
