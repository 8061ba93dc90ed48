// SPDX-License-Identifier: GPL-3.0-or-later
// main() of every test program: gives each process a temporary folder of its own, so that tests may
// run beside each other, and removes it afterwards.
#include <gmock/gmock.h>
#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <string>

int main(int argc, char** argv) {
    std::string folder = (std::filesystem::temp_directory_path() / "hepatica-test-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
        std::fprintf(stderr, "no temporary folder can be made as %s\n", folder.c_str());
        return 1;
    }
    setenv("TMPDIR", folder.c_str(), 1);
    setenv("TEST_TMPDIR", folder.c_str(), 1);
    testing::InitGoogleMock(&argc, argv);
    const int result = RUN_ALL_TESTS();
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    return result;
}
