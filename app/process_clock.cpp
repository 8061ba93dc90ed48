// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/process_clock.h"

#include <unistd.h>

#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace hepatica {

double seconds_since_process_start() {
    std::ifstream file("/proc/self/stat");
    const std::string stat{std::istreambuf_iterator<char>(file), {}};
    // Field 2, the program's name, is in parentheses and may contain blanks. Field 22 is the start
    // in clock ticks since boot.
    const std::size_t name_end = stat.rfind(')');
    if (name_end == std::string::npos) return -1.0;
    std::istringstream fields(stat.substr(name_end + 1));
    std::string field;
    for (int number = 3; number <= 22; ++number) fields >> field;
    timespec now{};
    if (field.empty() || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return -1.0;
    const double started_s = std::stod(field) / static_cast<double>(sysconf(_SC_CLK_TCK));
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - started_s;
}

}  // namespace hepatica
