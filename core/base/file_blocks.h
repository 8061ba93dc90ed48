// SPDX-License-Identifier: GPL-3.0-or-later
// A file's bytes from its beginning to its end, in blocks of 64 KiB.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>

namespace hepatica {

// Calls visit(bytes) for one block after the other; the bytes are valid during the call. Throws
// InputError, naming the file, if it is no regular file, cannot be opened or cannot be read to its
// end.
void for_each_block(const std::filesystem::path& file,
                    const std::function<void(std::span<const std::byte>)>& visit);

}  // namespace hepatica
