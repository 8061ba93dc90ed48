// SPDX-License-Identifier: GPL-3.0-or-later
// Available memory from /proc/meminfo and the process limit.
#include "core/image/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <limits>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

// The memory that the process may still map under its own limit (ulimit -v). Beyond that limit the
// stack cannot grow either, and the system terminates the process without a message.
std::uint64_t bytes_below_own_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return most;
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const std::uint64_t mapped = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    return limit.rlim_cur > mapped ? limit.rlim_cur - mapped : 0;
}

std::uint64_t free_bytes() {
    std::ifstream info("/proc/meminfo");
    std::string name;
    std::uint64_t kilobytes = 0;
    std::string unit;
    while (info >> name >> kilobytes >> unit)
        if (name == "MemAvailable:") return kilobytes * 1024;
    return most;
}

std::uint64_t available_bytes() {
    return std::min(free_bytes(), bytes_below_own_limit());
}

}  // namespace

std::uint64_t bytes_of(std::int64_t nx, std::int64_t ny, std::int64_t nz,
                       std::int64_t value_bytes) {
    std::uint64_t product = 1;
    for (const std::int64_t factor : {nx, ny, nz, value_bytes})
        if (__builtin_mul_overflow(product, static_cast<std::uint64_t>(factor), &product))
            return most;
    return product;
}

std::string readable_bytes(std::uint64_t bytes) {
    static constexpr std::array<const char*, 4> units{"kB", "MB", "GB", "TB"};
    if (bytes < 1000) return std::to_string(bytes) + " bytes";
    double value = static_cast<double>(bytes) / 1000.0;
    std::size_t unit = 0;
    while (value >= 1000.0 && unit + 1 < units.size()) {
        value /= 1000.0;
        ++unit;
    }
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), value < 1e6 ? "%.1f %s" : "%.3g %s", value,
                  units[unit]);
    return text.data();
}

void require_memory(std::uint64_t bytes, const std::string& place) {
    const std::uint64_t available = available_bytes();
    if (bytes <= available / 10 * 8) return;
    throw InputError("needs " + readable_bytes(bytes) + " of memory, and " +
                         readable_bytes(available) + " are available",
                     place,
                     "Close other programs, or export the image cropped or at half resolution");
}

}  // namespace hepatica
