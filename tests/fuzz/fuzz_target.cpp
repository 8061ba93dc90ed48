// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer's entry point: one program for each list of readers; -DHEPATICA_FUZZ_LIST names the
// list, and the environment variable READER the reader.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/fuzz/readers.h"

namespace {

const hepatica::fuzz::Reader& chosen_reader() {
    const char* name = std::getenv("READER");
    for (const hepatica::fuzz::Reader& reader : hepatica::fuzz::HEPATICA_FUZZ_LIST())
        if (name != nullptr && reader.name == name) return reader;
    std::fprintf(stderr, "set READER to one of:\n");
    for (const hepatica::fuzz::Reader& reader : hepatica::fuzz::HEPATICA_FUZZ_LIST())
        std::fprintf(stderr, "  %.*s\n", static_cast<int>(reader.name.size()), reader.name.data());
    std::exit(2);
}

}  // namespace

// VTK loses a little memory where it refuses a file.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libvtk\n";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const hepatica::fuzz::Reader reader = chosen_reader();
    reader.read({data, size});
    return 0;
}
