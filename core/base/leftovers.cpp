// SPDX-License-Identifier: GPL-3.0-or-later
// Names are ".hepatica-PROCESS.COMPUTER-RANDOM-TAIL", and with ".old" at the end for what was moved
// aside; those of older programs are ".hepatica-RANDOM-TAIL".
#include "core/base/leftovers.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <fstream>
#include <optional>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/hash.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view name_beginning = ".hepatica-";
constexpr std::string_view aside_ending = ".old";
constexpr std::chrono::days long_ago{7};

// Of this computer since it was started, and of the container in it that numbers its processes by
// itself. Computers may share a name.
std::string this_computer() {
    std::array<char, 256> name{};
    gethostname(name.data(), name.size() - 1);
    std::error_code ignored;
    const std::string numbering = fs::read_symlink("/proc/self/ns/pid", ignored).string();
    std::string start;
    std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), start);
    Hasher hasher;
    hasher.add_bytes(name.data(), name.size());
    hasher.add_bytes(start.data(), start.size());
    hasher.add_bytes(numbering.data(), numbering.size());
    return to_hex(hasher.value()).substr(0, 8);
}

std::string tail_of(const fs::path& target) {
    constexpr std::size_t longest = 100;
    const std::string name = target.filename().string();
    return name.substr(name.size() - std::min(name.size(), longest));
}

struct Leftover {
    fs::path path;
    pid_t process = 0;  // 0: not of this computer, or not known
    std::string tail{};
};

// The text before the next "-", which is taken away with it.
std::string_view take_part(std::string_view& text) {
    const std::size_t end = std::min(text.find('-'), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// Nothing for a name that no writer gives, and for what was moved aside: where its writer died
// between two renames it is the only copy.
std::optional<Leftover> leftover_at(const fs::path& path) {
    const std::string name = path.filename().string();
    if (!name.starts_with(name_beginning) || name.ends_with(aside_ending)) return std::nullopt;
    Leftover left{path};
    std::string_view rest = std::string_view(name).substr(name_beginning.size());
    const std::string_view writer = take_part(rest);
    std::string_view number = writer;
    if (const std::size_t dot = writer.find('.'); dot != std::string_view::npos) {
        if (!is_number(writer.substr(0, dot))) return std::nullopt;
        number = take_part(rest);
        if (writer.substr(dot + 1) == this_computer())
            std::from_chars(writer.data(), writer.data() + dot, left.process);
    }
    if (!is_number(number) || rest.empty()) return std::nullopt;
    left.tail = rest;
    return left;
}

bool is_of_dead_writer(const Leftover& left) {
    if (left.process > 0) return kill(left.process, 0) == -1 && errno == ESRCH;
    std::error_code unknown;
    const fs::file_time_type changed = fs::last_write_time(left.path, unknown);
    return !unknown && changed < fs::file_time_type::clock::now() - long_ago;
}

void remove_own(const fs::path& folder, const std::function<bool(const fs::path&)>& is_own) {
    std::error_code ignored;
    std::vector<fs::path> files, folders{folder};
    for (fs::recursive_directory_iterator at(folder, ignored), end; !ignored && at != end;
         at.increment(ignored))
        (!at->is_symlink() && at->is_directory() ? folders : files).push_back(at->path());
    for (const fs::path& file : files)
        if (is_own(file.lexically_relative(folder))) fs::remove(file, ignored);
    while (!folders.empty()) {  // those within others come later in the list
        rmdir(folders.back().c_str());
        folders.pop_back();
    }
}

}  // namespace

std::string temporary_name(const fs::path& target) {
    std::random_device random;
    const std::string first = std::to_string(random());
    const std::string second = std::to_string(random());
    return std::string(name_beginning) + std::to_string(getpid()) + "." + this_computer() + "-" +
           first + second + "-" + tail_of(target);
}

void sweep_leftovers(const fs::path& written,
                     const std::function<bool(const fs::path& below)>& is_own) {
    const fs::path folder = fs::absolute(written).parent_path();
    std::error_code ignored;
    std::vector<Leftover> found;
    for (fs::directory_iterator at(folder, ignored), end; !ignored && at != end;
         at.increment(ignored))
        if (auto left = leftover_at(at->path())) found.push_back(std::move(*left));
    for (const Leftover& left : found) {
        const fs::file_type type = fs::symlink_status(left.path, ignored).type();
        const bool same = left.tail == tail_of(written);
        if (!is_of_dead_writer(left)) continue;
        if (type == fs::file_type::directory && same) remove_own(left.path, is_own);
        if (type == fs::file_type::regular && (same || fs::exists(folder / left.tail, ignored)))
            fs::remove(left.path, ignored);
    }
}

}  // namespace hepatica
