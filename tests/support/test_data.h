// SPDX-License-Identifier: GPL-3.0-or-later
// Where the data lie that tests may use and the project does not ship.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace hepatica::test {

inline std::filesystem::path shared_data() {
    if (const char* folder = std::getenv("HEPATICA_TEST_DATA")) return folder;
    return std::filesystem::path(HEPATICA_SOURCE_DIR) / "../shared/data";
}

}  // namespace hepatica::test
