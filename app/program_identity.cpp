// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/program_identity.h"

#include <elf.h>
#include <link.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace hepatica {
namespace {

// The note NT_GNU_BUILD_ID among the notes of one segment, in hexadecimal digits; "" where there is
// none.
std::string build_id_among(const char* notes, std::size_t size) {
    while (size >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) head;
        std::memcpy(&head, notes, sizeof head);
        const std::size_t name_size = (head.n_namesz + 3U) & ~std::size_t{3};
        const std::size_t whole =
            sizeof head + name_size + ((head.n_descsz + 3U) & ~std::size_t{3});
        if (whole > size) break;
        if (head.n_type == NT_GNU_BUILD_ID) {
            std::string digits;
            for (std::size_t i = 0; i < head.n_descsz; ++i) {
                char pair[3];
                const char byte = notes[sizeof head + name_size + i];
                std::snprintf(pair, sizeof pair, "%02x", static_cast<unsigned char>(byte));
                digits += pair;
            }
            return digits;
        }
        notes += whole;
        size -= whole;
    }
    return {};
}

// The first object listed is the program itself; returning 1 ends the iteration.
int find_build_id(dl_phdr_info* program, std::size_t /*size*/, void* found) {
    for (int i = 0; i < program->dlpi_phnum; ++i) {
        const ElfW(Phdr)& segment = program->dlpi_phdr[i];
        if (segment.p_type != PT_NOTE) continue;
        const auto* notes = reinterpret_cast<const char*>(program->dlpi_addr + segment.p_vaddr);
        std::string id = build_id_among(notes, segment.p_memsz);
        if (!id.empty()) *static_cast<std::string*>(found) = id;
    }
    return 1;
}

std::string size_and_time() {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    return std::to_string(fs::file_size(program, ignored)) + " bytes of " +
           std::to_string(fs::last_write_time(program, ignored).time_since_epoch().count());
}

}  // namespace

std::string program_identity() {
    std::string build_id;
    dl_iterate_phdr(find_build_id, &build_id);
    return std::string(HEPATICA_VERSION) + " " + (build_id.empty() ? size_and_time() : build_id);
}

}  // namespace hepatica
