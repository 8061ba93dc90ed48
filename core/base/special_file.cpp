// SPDX-License-Identifier: GPL-3.0-or-later
// POSIX descriptors: only they can open a pipe without waiting for its reader.
#include "core/base/special_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>

namespace hepatica {

namespace fs = std::filesystem;

namespace {

std::error_code last_error() {
    return {errno, std::generic_category()};
}

// A file that is open for writing; -1 where it cannot be.
class OpenPlace {
  public:
    explicit OpenPlace(const fs::path& file)
        : descriptor_(open(file.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
    ~OpenPlace() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    OpenPlace(const OpenPlace&) = delete;
    OpenPlace& operator=(const OpenPlace&) = delete;

    int descriptor() const { return descriptor_; }

  private:
    int descriptor_;
};

// A reader may be slow. A signal ends the waiting, so that it can end the program.
std::error_code wait_until_taken(int descriptor) {
    pollfd place{descriptor, POLLOUT, 0};
    return poll(&place, 1, -1) < 0 ? last_error() : std::error_code();
}

std::error_code write_all(int descriptor, const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t written = write(descriptor, bytes, count);
        if (written >= 0) {
            bytes += written;
            count -= static_cast<std::size_t>(written);
        } else if (errno != EAGAIN) {
            return last_error();
        } else if (const std::error_code error = wait_until_taken(descriptor)) {
            return error;
        }
    }
    return {};
}

}  // namespace

bool is_special_file(const fs::path& file) {
    std::error_code ignored;
    return fs::is_other(fs::status(file, ignored));
}

std::error_code write_into_special_file(const fs::path& from, const fs::path& to) {
    std::ifstream in(from, std::ios::binary);
    if (!in) return std::make_error_code(std::errc::no_such_file_or_directory);
    const OpenPlace place(to);
    struct stat found {};
    if (place.descriptor() < 0 || fstat(place.descriptor(), &found) != 0) return last_error();
    if (S_ISBLK(found.st_mode)) return std::make_error_code(std::errc::operation_not_permitted);
    std::array<char, 1 << 16> block{};
    while (in) {
        in.read(block.data(), block.size());
        if (in.bad()) return std::make_error_code(std::errc::io_error);
        if (const std::error_code error =
                write_all(place.descriptor(), block.data(), static_cast<std::size_t>(in.gcount())))
            return error;
    }
    return {};
}

}  // namespace hepatica
