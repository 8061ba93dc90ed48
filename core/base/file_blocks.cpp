// SPDX-License-Identifier: GPL-3.0-or-later
// Unformatted reads; a read that fails sets the stream's badbit, the end of the file does not.
#include "core/base/file_blocks.h"

#include <fstream>
#include <vector>

#include "core/base/error.h"
#include "core/base/regular_file.h"

namespace hepatica {

void for_each_block(const std::filesystem::path& file,
                    const std::function<void(std::span<const std::byte>)>& visit) {
    require_regular_file(file);
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError("cannot be read", file.string(), "Check that it exists");
    std::vector<char> block(1 << 16);
    while (in) {
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        if (in.bad())
            throw InputError("cannot be read to its end", file.string(), "Check the disk");
        visit(std::as_bytes(std::span(block).first(static_cast<std::size_t>(in.gcount()))));
    }
}

}  // namespace hepatica
